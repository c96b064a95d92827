"""Names of C types: parsed with the declarations that they use, they are the types of cffi."""

import pytest
from cffi import FFI, CDefError

from skinshade.gpu.declarations import parse_used_names
from skinshade.gpu.device import adapters

HEADER = """
typedef struct Adapter* Adapter;
typedef unsigned int Flags;
typedef enum { LOW = 0, HIGH = 7 } Level;
typedef struct { Flags flags; Level level; Adapter adapter; } Options;
typedef void (*Callback)(Level, const Options *, void *);
"""
NAMES = ["Options *", "Adapter[]", "Flags", "struct Adapter *", "void(*)(Level, Flags, void *)"]
NAMES += ["Callback *", "char []", "uint8_t[4]", "Level[3]"]


def interface():
    ffi = FFI()
    ffi.cdef(HEADER)
    return ffi


@pytest.mark.parametrize("name", NAMES)
def test_a_name_is_the_type_of_cffi(name):
    plain, quick = interface(), interface()
    parse_used_names(quick)
    one, other = plain.typeof(name), quick.typeof(name)
    assert (other.kind, other.cname) == (one.kind, one.cname)


def test_the_parser_reads_only_the_types_in_the_name():
    ffi, sources = interface(), []
    parse = ffi._parser._parse
    ffi._parser._parse = lambda source: (
        sources.append(set(ffi._parser._declarations)) or parse(source)
    )
    parse_used_names(ffi)
    declared = set(ffi._parser._declarations)
    ffi.typeof("Options *")
    assert {key for key in sources[0] if key.startswith("typedef ")} == {"typedef Options"}
    assert set(ffi._parser._declarations) >= declared


def test_structs_are_filled_and_later_declarations_are_known():
    ffi = interface()
    parse_used_names(ffi)
    options = ffi.new("Options *", {"flags": 3, "level": 7})
    assert (options.flags, options.level) == (3, 7)
    ffi.cdef("typedef struct { Options options; int more; } Extended;")
    assert ffi.new("Extended *").options.flags == 0


def test_a_name_that_is_no_type_is_an_error_of_cffi_and_changes_nothing():
    ffi = interface()
    parse_used_names(ffi)
    with pytest.raises(CDefError):
        ffi.typeof("Moon *")
    assert ffi.sizeof("Options") > 0


@pytest.mark.parametrize("other", [None, object()])
def test_an_interface_without_the_parser_of_cffi_stays_as_it_is(other):
    parse_used_names(other)
    assert not hasattr(other, "_parser")


def test_the_interface_of_wgpu_parses_the_types_in_a_name_alone():
    adapters()
    binding = pytest.importorskip("wgpu.backends.wgpu_native")
    assert "parse_used_names" in binding.ffi._parser._parse.__qualname__
