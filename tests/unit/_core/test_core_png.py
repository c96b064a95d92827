"""PNG files: the check accepts what libpng reads, and refuses the rest before libpng prints it."""

import struct
import zlib

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from skinshade._core.errors import ImageFileError
from skinshade._core.limits import use_limits
from skinshade._core.pixels import read_pixels
from skinshade._core.png import DEPTHS, SIGNATURE, _header

PALETTE = (b"PLTE", bytes(range(48)))


def chunk(kind, data, checksum=None):
    value = zlib.crc32(kind + data) if checksum is None else checksum
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", value)


def header(width=5, height=4, depth=8, colour=2, compression=0, method=0, interlaced=0):
    return struct.pack(">IIBBBBB", width, height, depth, colour, compression, method, interlaced)


def png(*chunks):
    return SIGNATURE + b"".join(chunk(*parts) for parts in chunks) + chunk(b"IEND", b"")


ROWS = bytes(4 * 16)
HEADER, DATA = (b"IHDR", header()), zlib.compress(ROWS)
PIXELS = (b"IDAT", DATA)
FAULTS = {
    "the signature alone": (SIGNATURE, "its first chunk"),
    "no pixels": (png(HEADER), "ends before its pixels"),
    "cut within the pixels": (png(HEADER, PIXELS)[:50], "cut short in the chunk IDAT"),
    "cut within a length": (png(HEADER)[:35], "cut short"),
    "a wrong checksum": (png((*HEADER, 7), PIXELS), "wrong checksum of the chunk IHDR"),
    "a wrong checksum of text": (png(HEADER, (b"tEXt", b"a\0b", 7), PIXELS), "chunk tEXt"),
    "no header": (png(PIXELS), "its first chunk"),
    "text before the header": (png((b"tEXt", b"a\0b"), HEADER, PIXELS), "its first chunk"),
    "compressed text before the header": (
        png((b"zTXt", b"a\0\0" + DATA), HEADER, PIXELS),
        "its first chunk",
    ),
    "two headers": (png(HEADER, HEADER, PIXELS), "its first chunk, and no other one"),
    "a short header": (png((b"IHDR", header()[:12]), PIXELS), "12 bytes instead of 13"),
    "no columns": (png((b"IHDR", header(0)), PIXELS), "0×4 pixels"),
    "an unknown colour": (png((b"IHDR", header(colour=5)), PIXELS), "unknown form of pixels"),
    "an unknown depth": (png((b"IHDR", header(depth=4)), PIXELS), "unknown form of pixels"),
    "an unknown interlace": (png((b"IHDR", header(interlaced=2)), PIXELS), "unknown form"),
    "an unknown chunk": (png(HEADER, (b"ABCD", b""), PIXELS), "unknown chunk ABCD"),
    "a type with a digit": (png(HEADER, (b"ab1d", b""), PIXELS), "unknown chunk 61623164"),
    "a type with a small third letter": (png(HEADER, (b"zzzz", b""), PIXELS), "unknown chunk zzzz"),
    "no palette": (png((b"IHDR", header(colour=3)), PIXELS), "its palette has 0 bytes"),
    "two palettes": (png(HEADER, PALETTE, PALETTE, PIXELS), "several palettes"),
    "a palette of 4 bytes": (
        png((b"IHDR", header(colour=3)), (b"PLTE", b"1234"), PIXELS),
        "its palette has 4 bytes",
    ),
    "no zlib stream": (png(HEADER, (b"IDAT", b"xxxx")), "incorrect header check"),
    "a wrong sum of the stream": (
        png(HEADER, (b"IDAT", DATA[:-1] + bytes([DATA[-1] ^ 1]))),
        "incorrect data check",
    ),
    "no sum of the stream": (
        png(HEADER, (b"IDAT", DATA[:-4])),
        "the end of its compressed pixels is missing",
    ),
    "two million bytes after the last row": (
        png(HEADER, (b"IDAT", zlib.compress(bytes(2 << 20)))),
        "its pixels go on after the last row",
    ),
    "a row too few": (png(HEADER, (b"IDAT", zlib.compress(ROWS[:-16]))), "16 bytes of its pixels"),
    "an unknown filter": (
        png(HEADER, (b"IDAT", zlib.compress(ROWS[:-16] + b"\x05" + bytes(15)))),
        "unknown filter 5",
    ),
    "the rest after compressed text": (
        png(HEADER, (b"IDAT", DATA[:4]), (b"zTXt", b"a\0\0" + DATA), (b"IDAT", DATA[4:])),
        "of its pixels are missing",
    ),
    "the rest after another chunk": (
        png(HEADER, (b"IDAT", DATA[:4]), (b"tEXt", b"a\0b"), (b"IDAT", DATA[4:])),
        "of its pixels are missing",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_named_and_nothing_is_printed(tmp_path, capfd, name):
    data, message = FAULTS[name]
    path = tmp_path / "a.png"
    path.write_bytes(data)
    with pytest.raises(ImageFileError, match=message) as caught:
        read_pixels(path, ImageFileError)
    assert str(caught.value).startswith(f"{path}: corrupt (")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("extra", "tail"),
    [
        ([(b"tEXt", b"Comment\0text"), (b"abCd", b"private")], b""),
        ([(b"IDAT", b"")], b""),
        ([], b"bytes after the end"),
    ],
    ids=["text and private chunks", "an empty part of the pixels", "bytes after the end"],
)
def test_further_chunks_and_bytes_are_accepted(tmp_path, extra, tail):
    path = tmp_path / "a.png"
    path.write_bytes(png(HEADER, *extra, PIXELS) + tail)
    assert read_pixels(path, ImageFileError)[0].shape == (4, 5, 3)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    width=st.integers(1, 19),
    height=st.integers(1, 19),
    form=st.sampled_from([(colour, depth) for colour in DEPTHS for depth in DEPTHS[colour]]),
    interlaced=st.integers(0, 1),
    split=st.integers(0, 10),
)
def test_every_form_of_pixels_needs_the_bytes_that_libpng_reads(
    tmp_path, capfd, width, height, form, interlaced, split
):
    colour, depth = form
    head = header(width, height, depth, colour, interlaced=interlaced)
    rows = bytes(sum(count * (1 + size) for count, size in _header(head)[3]))
    path = tmp_path / "a.png"
    for missing in (0, 1):
        data = zlib.compress(rows[missing:])
        parts = [(b"IDAT", data[:split]), (b"IDAT", data[split:])]
        path.write_bytes(png((b"IHDR", head), PALETTE, *parts))
        if missing:
            with pytest.raises(ImageFileError, match="1 bytes of its pixels are missing"):
                read_pixels(path, ImageFileError)
        else:
            assert read_pixels(path, ImageFileError)[0].shape[:2] == (height, width)
    assert capfd.readouterr() == ("", "")


def test_a_large_chunk_of_text_is_refused_without_keeping_it(tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(png(HEADER, (b"zTXt", b"Comment\0\0" + bytes(5000)), PIXELS))
    with (
        use_limits(image_text_bytes=4096),
        pytest.raises(ImageFileError, match="its text takes more than 4096 bytes"),
    ):
        read_pixels(path, ImageFileError)
