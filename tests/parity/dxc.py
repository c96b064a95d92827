"""DirectX shader compiler, by its C++ interfaces: HLSL with includes to DXIL or SPIR-V.

The compiler runs in its own process, whose program is this file. At the end of a process the library locks
a mutex in memory that it has freed; if another driver has reused that memory, the process hangs. This
process therefore ends without calling any library's exit handlers.
"""

from __future__ import annotations

import ctypes
import os
import pickle
import subprocess
import sys
import uuid
from pathlib import Path

LIBRARY = Path(sys.prefix, "lib", "dxc", "libdxcompiler.so")
"""Path at which tools/language_tools.py installs the compiler."""
COMPILER = "73e22d93-e6ce-47f3-b5bf-f0664f39c1b0", "228b4687-5a6a-4730-900c-9702b2203f54"
UTILS = "6245d6af-66e0-48fd-80b4-4d271796748c", "4605c4cb-2019-492a-ada4-65f20bb7d67f"
RESULT = "58346cda-dde7-4497-9461-6f87af5e0659"
UTF8 = 65001
# Indices of methods in the virtual tables. Outside Windows, IUnknown has a virtual destructor, which
# occupies two entries, so that the methods of the interfaces begin at 5.
BLOB_POINTER, BLOB_SIZE = 5, 6
STATUS, GET_RESULT, GET_ERRORS = 5, 6, 7
COMPILE = 5
DEFAULT_INCLUDES = 11
UNSIGNED = (
    "warning: DXIL.dll not found.  Resulting DXIL will not be signed"
    " for use in release environments."
)
"""Warning that says nothing about the source: only Windows can sign DXIL."""


class Source(ctypes.Structure):
    _fields_ = (
        ("pointer", ctypes.c_void_p),
        ("size", ctypes.c_size_t),
        ("encoding", ctypes.c_uint32),
    )


def compiled(jobs):
    """Return binary and messages of each job; the binary is empty if the compiler rejects the text.

    A job is a text, the folder of its includes, and flags. Warnings are errors.
    """
    command = [sys.executable, __file__]
    done = subprocess.run(command, input=pickle.dumps(jobs), capture_output=True)
    if done.returncode:
        raise OSError(done.stderr.decode("utf-8", "replace"))
    return pickle.loads(done.stdout)


class Compiler:
    """Compiles one text at a time."""

    def __init__(self):
        self.library = ctypes.CDLL(str(LIBRARY))
        self.compiler, self.utils = self._instance(*COMPILER), self._instance(*UTILS)
        self.includes = ctypes.c_void_p()
        call_method(self.utils, DEFAULT_INCLUDES, ctypes.byref(self.includes))

    def __call__(self, text, folder, flags):
        data = text.encode("utf-8")
        pointer = ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p)
        arguments = ["-I", str(folder), "-WX", *flags]
        result = ctypes.c_void_p()
        call_method(
            self.compiler,
            COMPILE,
            ctypes.byref(Source(pointer, len(data), UTF8)),
            (ctypes.c_wchar_p * len(arguments))(*arguments),
            ctypes.c_uint32(len(arguments)),
            self.includes,
            guid(RESULT),
            ctypes.byref(result),
        )
        status, errors, binary = ctypes.c_int32(), ctypes.c_void_p(), ctypes.c_void_p()
        call_method(result, STATUS, ctypes.byref(status))
        call_method(result, GET_ERRORS, ctypes.byref(errors))
        if not status.value:
            call_method(result, GET_RESULT, ctypes.byref(binary))
        messages = contents(errors).rstrip(b"\0").decode("utf-8", "replace")
        return contents(binary), messages.replace(UNSIGNED, "").strip()

    def _instance(self, kind, interface):
        instance = ctypes.c_void_p()
        code = self.library.DxcCreateInstance(guid(kind), guid(interface), ctypes.byref(instance))
        if code:
            raise OSError(f"DxcCreateInstance returned {code & 0xFFFFFFFF:#x}")
        return instance


def guid(text):
    return ctypes.c_char_p(uuid.UUID(text).bytes_le)


def call_method(instance, index, *arguments, returns=ctypes.c_int32):
    """Call a method by its index in the virtual table; raise if it returns an error code."""
    table = ctypes.cast(instance, ctypes.POINTER(ctypes.POINTER(ctypes.c_void_p)))[0]
    value = ctypes.CFUNCTYPE(returns)(table[index])(instance, *arguments)
    if returns is ctypes.c_int32 and value < 0:
        raise OSError(f"method {index} returned {value & 0xFFFFFFFF:#x}")
    return value


def contents(blob):
    """Return the bytes of a blob; no bytes for a null pointer."""
    if not blob:
        return b""
    pointer = call_method(blob, BLOB_POINTER, returns=ctypes.c_void_p)
    size = call_method(blob, BLOB_SIZE, returns=ctypes.c_size_t)
    return ctypes.string_at(pointer, size) if size else b""


def main():
    compiler = Compiler()
    results = [compiler(*job) for job in pickle.load(sys.stdin.buffer)]
    sys.stdout.buffer.write(pickle.dumps(results))
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
