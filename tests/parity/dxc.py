"""The DirectX shader compiler, through its C++ interfaces: HLSL to DXIL or SPIR-V, with includes.

It works in a process of its own, which is this file. What it frees when a process ends it locks
afterwards, and where another driver has taken that memory the process waits for ever; this one ends
without asking any library.
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
"""Where tools/language_tools.py puts it."""
COMPILER = "73e22d93-e6ce-47f3-b5bf-f0664f39c1b0", "228b4687-5a6a-4730-900c-9702b2203f54"
UTILS = "6245d6af-66e0-48fd-80b4-4d271796748c", "4605c4cb-2019-492a-ada4-65f20bb7d67f"
RESULT = "58346cda-dde7-4497-9461-6f87af5e0659"
UTF8 = 65001
# Places of methods in the virtual tables. Outside Windows IUnknown has a virtual destructor, which
# takes two, so that the interfaces' own methods begin at 5.
BLOB_POINTER, BLOB_SIZE = 5, 6
STATUS, GET_RESULT, GET_ERRORS = 5, 6, 7
COMPILE = 5
DEFAULT_INCLUDES = 11
UNSIGNED = (
    "warning: DXIL.dll not found.  Resulting DXIL will not be signed"
    " for use in release environments."
)
"""Only Windows can sign, so nothing is wrong with what is compiled."""


class Source(ctypes.Structure):
    _fields_ = (
        ("pointer", ctypes.c_void_p),
        ("size", ctypes.c_size_t),
        ("encoding", ctypes.c_uint32),
    )


def compiled(jobs):
    """Return the binary and what the compiler says of each job; no bytes where it rejects one.

    A job is a text, the folder of its includes, and flags. A warning is an error.
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
        method(self.utils, DEFAULT_INCLUDES, ctypes.byref(self.includes))

    def __call__(self, text, folder, flags):
        data = text.encode("utf-8")
        pointer = ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p)
        words = ["-I", str(folder), "-WX", *flags]
        result = ctypes.c_void_p()
        method(
            self.compiler,
            COMPILE,
            ctypes.byref(Source(pointer, len(data), UTF8)),
            (ctypes.c_wchar_p * len(words))(*words),
            ctypes.c_uint32(len(words)),
            self.includes,
            guid(RESULT),
            ctypes.byref(result),
        )
        status, errors, binary = ctypes.c_int32(), ctypes.c_void_p(), ctypes.c_void_p()
        method(result, STATUS, ctypes.byref(status))
        method(result, GET_ERRORS, ctypes.byref(errors))
        if not status.value:
            method(result, GET_RESULT, ctypes.byref(binary))
        said = contents(errors).rstrip(b"\0").decode("utf-8", "replace")
        return contents(binary), said.replace(UNSIGNED, "").strip()

    def _instance(self, kind, interface):
        made = ctypes.c_void_p()
        code = self.library.DxcCreateInstance(guid(kind), guid(interface), ctypes.byref(made))
        if code:
            raise OSError(f"DxcCreateInstance returned {code & 0xFFFFFFFF:#x}")
        return made


def guid(text):
    return ctypes.c_char_p(uuid.UUID(text).bytes_le)


def method(thing, place, *arguments, returns=ctypes.c_int32):
    """Call a method by its place in the virtual table; an error that it returns is raised."""
    table = ctypes.cast(thing, ctypes.POINTER(ctypes.POINTER(ctypes.c_void_p)))[0]
    found = ctypes.CFUNCTYPE(returns)(table[place])(thing, *arguments)
    if returns is ctypes.c_int32 and found < 0:
        raise OSError(f"method {place} returned {found & 0xFFFFFFFF:#x}")
    return found


def contents(blob):
    """Bytes of a blob, if there is one."""
    if not blob:
        return b""
    pointer = method(blob, BLOB_POINTER, returns=ctypes.c_void_p)
    size = method(blob, BLOB_SIZE, returns=ctypes.c_size_t)
    return ctypes.string_at(pointer, size) if size else b""


def main():
    compiler = Compiler()
    found = [compiler(*job) for job in pickle.load(sys.stdin.buffer)]
    sys.stdout.buffer.write(pickle.dumps(found))
    sys.stdout.flush()
    os._exit(0)


if __name__ == "__main__":
    main()
