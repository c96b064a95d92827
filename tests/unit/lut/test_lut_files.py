import json
import os

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import tolerances as tol
from skinshade._core.errors import ArgumentError, LutFileError, OutputError, SkinshadeError
from skinshade.lut import Axis, Lut, build_shadow_lut, curvature_lut

AS_ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
SUFFIXES = pytest.mark.parametrize("suffix", [".exr", ".png", ".npz"])
SAME_FOLDER = settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
TEXT = st.text(st.characters(codec="utf-8", exclude_categories=["Cc", "Cs"]), max_size=12)
NOTES = st.dictionaries(
    TEXT,
    TEXT | st.integers(-(2**31), 2**31) | st.booleans() | st.lists(st.floats(-9, 9)),
    max_size=3,
)


@st.composite
def tables(draw):
    shape = (draw(st.integers(2, 6)), draw(st.integers(2, 6)), 3)
    finite = st.floats(-(2.0**20), 2.0**20, width=32)
    low, span = draw(st.floats(0.0, 10.0)), draw(st.floats(0.1, 10.0))
    axis = Axis(draw(TEXT), "1/mm", low, low + span, draw(st.sampled_from(["linear", "sqrt"])))
    kind = draw(st.sampled_from(["curvature", "shadow", "transfer"]))
    return Lut(draw(hnp.arrays(np.float32, shape, elements=finite)), kind, axis, axis, draw(NOTES))


def half_steps(table):
    span = np.ptp(table.values.astype(float), axis=(0, 1))
    rounding = 4.0 * np.finfo(np.float32).eps * np.abs(table.values).max()
    return tol.PNG_HALF_STEP.value * span / 65535.0 + rounding


@SUFFIXES
@SAME_FOLDER
@given(table=tables())
def test_a_saved_table_is_loaded_unchanged(tmp_path, suffix, table):
    table.save(tmp_path / f"table{suffix}")
    loaded = Lut.load(tmp_path / f"table{suffix}")
    assert loaded.description() == table.description()
    assert loaded.values.dtype == np.float32
    if suffix == ".png":
        assert (np.abs(loaded.values.astype(float) - table.values) <= half_steps(table)).all()
    else:
        assert np.array_equal(loaded.values, table.values)


@SUFFIXES
@pytest.mark.parametrize("build", [curvature_lut, build_shadow_lut])
def test_a_built_table_is_loaded_with_its_provenance(tmp_path, suffix, deon, build):
    table = build(deon, size=(32, 16))
    table.save(tmp_path / f"table{suffix}")
    loaded = Lut.load(tmp_path / f"table{suffix}")
    assert loaded.provenance == table.provenance
    assert (loaded.columns, loaded.rows, loaded.kind) == (table.columns, table.rows, table.kind)
    assert (np.abs(loaded.values.astype(float) - table.values) <= half_steps(table)).all()


@pytest.mark.parametrize("suffix", [".EXR", ".PNG", ".NPZ", ".Npz"])
def test_the_case_of_the_suffix_does_not_matter(tmp_path, deon, suffix):
    table = build_shadow_lut(deon, size=(8, 4))
    table.save(tmp_path / f"table{suffix}")
    assert [file.name for file in tmp_path.iterdir()] == [f"table{suffix}"]
    assert Lut.load(tmp_path / f"table{suffix}").values.shape == (4, 8, 3)


def test_an_exr_is_a_float_image_for_other_programs(tmp_path, deon):
    table = curvature_lut(deon, size=(8, 4))
    table.save(tmp_path / "table.exr")
    image = oiio.ImageBuf(str(tmp_path / "table.exr"))
    assert image.spec().format == oiio.FLOAT
    assert (image.spec().width, image.spec().height, image.spec().nchannels) == (8, 4, 3)
    assert np.array_equal(image.get_pixels(oiio.FLOAT), table.values)


def test_a_png_has_16_bits_and_its_range_in_the_metadata(tmp_path, deon):
    table = curvature_lut(deon, size=(8, 4))
    table.save(tmp_path / "table.png")
    spec = oiio.ImageBuf(str(tmp_path / "table.png")).spec()
    assert spec.format == oiio.UINT16
    record = json.loads(spec.getattribute("ImageDescription"))
    assert np.allclose(record["value_low"], table.values.min(axis=(0, 1)))
    assert np.allclose(record["value_span"], np.ptp(table.values, axis=(0, 1)))


def test_a_png_of_one_value_is_loaded_exactly(tmp_path):
    axis = Axis("a", "1", 0.0, 1.0)
    Lut(np.full((2, 2, 3), 0.3, np.float32), "shadow", axis, axis).save(tmp_path / "flat.png")
    assert np.array_equal(
        Lut.load(tmp_path / "flat.png").values, np.full((2, 2, 3), 0.3, np.float32)
    )


# -- faults ----------------------------------------------------------------------------------------


@SUFFIXES
@pytest.mark.parametrize(
    "content",
    [None, b"", b"a table of skin\n" * 20, bytes(range(256)) * 4],
    ids=["missing", "empty", "text", "noise"],
)
def test_a_file_that_is_no_table_is_refused_by_name(tmp_path, suffix, content):
    file = tmp_path / f"table{suffix}"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(LutFileError) as caught:
        Lut.load(file)
    assert str(file) in str(caught.value)


def test_a_folder_is_refused(tmp_path):
    with pytest.raises(LutFileError, match="not a file"):
        Lut.load(tmp_path)


@SUFFIXES
def test_a_truncated_table_is_refused(tmp_path, suffix, deon):
    file = tmp_path / f"table{suffix}"
    curvature_lut(deon, size=(64, 32)).save(file)
    whole = file.read_bytes()
    for share in (0.02, 0.4, 0.9):
        file.write_bytes(whole[: int(len(whole) * share)])
        with pytest.raises(LutFileError) as caught:
            Lut.load(file)
        assert str(file) in str(caught.value)


@SUFFIXES
@settings(SAME_FOLDER, max_examples=80)
@given(data=st.data())
def test_wrong_bytes_raise_only_errors_of_skinshade(tmp_path, suffix, deon, data):
    file = tmp_path / f"table{suffix}"
    if not file.exists():
        build_shadow_lut(deon, size=(8, 8)).save(file)
    whole = file.read_bytes()
    broken = bytearray(whole)
    for _ in range(data.draw(st.integers(1, 4))):
        broken[data.draw(st.integers(0, len(broken) - 1))] = data.draw(st.integers(0, 255))
    damaged = tmp_path / f"damaged{suffix}"
    damaged.write_bytes(broken)
    try:
        assert np.isfinite(Lut.load(damaged).values).all()
    except SkinshadeError as error:
        assert str(damaged) in str(error)


@pytest.mark.parametrize("suffix", [".exr", ".png"])
def test_an_image_without_a_description_is_refused(tmp_path, suffix):
    file = tmp_path / f"image{suffix}"
    spec = oiio.ImageSpec(4, 4, 3, "uint16" if suffix == ".png" else "float")
    image = oiio.ImageBuf(spec)
    assert image.write(str(file))
    with pytest.raises(
        LutFileError, match="has no description of its axes; it is not a table of skinshade"
    ):
        Lut.load(file)


def npz(file, **entries):
    np.savez(file, **entries)
    return file


GOOD = {
    "kind": "shadow",
    "columns": {"name": "u", "unit": "1", "low": 0.0, "high": 1.0, "spacing": "linear"},
    "rows": {"name": "v", "unit": "1", "low": 0.0, "high": 1.0, "spacing": "linear"},
    "provenance": {},
}
PLAIN = np.zeros((2, 2, 3), np.float32)


@pytest.mark.parametrize(
    "description",
    [
        [],
        7,
        {},
        GOOD | {"kind": "specular"},
        GOOD | {"columns": {"low": 0.0}},
        GOOD | {"columns": GOOD["columns"] | {"low": 2.0}},
        GOOD | {"columns": GOOD["columns"] | {"low": "left"}},
        GOOD | {"columns": GOOD["columns"] | {"colour": 1}},
        GOOD | {"rows": GOOD["rows"] | {"low": -1.0, "spacing": "sqrt"}},
        GOOD | {"value_low": [0.0, 0.0], "value_span": [1.0]},
    ],
)
def test_a_wrong_description_is_refused(tmp_path, description):
    file = npz(tmp_path / "a.npz", values=PLAIN, description=json.dumps(description))
    with pytest.raises(LutFileError) as caught:
        Lut.load(file)
    assert str(file) in str(caught.value)


@pytest.mark.parametrize(
    "values",
    [
        np.zeros((2, 2)),
        np.zeros((2, 2, 4)),
        np.full((2, 2, 3), np.nan),
        np.array([[["a"] * 3] * 2] * 2),
    ],
    ids=["two axes", "four channels", "nan", "text"],
)
def test_values_of_a_wrong_shape_or_type_are_refused(tmp_path, values):
    file = npz(tmp_path / "a.npz", values=values, description=json.dumps(GOOD))
    with pytest.raises(LutFileError):
        Lut.load(file)


def test_an_archive_without_a_table_is_refused(tmp_path):
    with pytest.raises(LutFileError, match="not a table of skinshade"):
        Lut.load(npz(tmp_path / "a.npz", weights=np.zeros(3)))


def test_an_npy_file_with_the_suffix_npz_is_refused(tmp_path):
    np.save(tmp_path / "a.npy", PLAIN)
    (tmp_path / "a.npy").rename(tmp_path / "a.npz")
    with pytest.raises(LutFileError):
        Lut.load(tmp_path / "a.npz")


@pytest.mark.parametrize("name", ["table.tif", "table", "table.npz.gz", "table.jpg"])
def test_an_unknown_suffix_is_refused_with_the_choices(tmp_path, deon, name):
    with pytest.raises(ArgumentError, match=r"\.exr, \.png or \.npz"):
        build_shadow_lut(deon, size=(4, 4)).save(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


@SUFFIXES
@pytest.mark.parametrize("folder", ["missing", "file"])
def test_a_path_that_cannot_be_written_is_named(tmp_path, deon, suffix, folder):
    (tmp_path / "file").write_bytes(b"x")
    target = tmp_path / folder / f"table{suffix}"
    with pytest.raises(OutputError) as caught:
        build_shadow_lut(deon, size=(4, 4)).save(target)
    assert str(target) in str(caught.value)
    assert [file.name for file in tmp_path.iterdir()] == ["file"]


@SUFFIXES
@pytest.mark.skipif(AS_ROOT, reason="root can write to every folder")
def test_a_folder_without_permission_remains_empty(tmp_path, deon, suffix):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="cannot write to its folder"):
        build_shadow_lut(deon, size=(4, 4)).save(tmp_path / f"table{suffix}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", [".exr", ".png"])
def test_a_failed_write_names_the_file_and_keeps_the_old_one(tmp_path, deon, suffix, monkeypatch):
    target = tmp_path / f"table{suffix}"
    target.write_bytes(b"old")

    class Broken:
        def open(self, name, spec):
            return True

        def write_image(self, pixels):
            return False

        def geterror(self):
            return "the disk is full"

    class Output:
        create = staticmethod(lambda name: Broken())

    monkeypatch.setattr(oiio, "ImageOutput", Output)
    with pytest.raises(OutputError, match="the disk is full") as caught:
        build_shadow_lut(deon, size=(4, 4)).save(target)
    assert str(target) in str(caught.value)
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def with_description(folder, description):
    """Write an npz table whose description is an array."""
    file = folder / "table.npz"
    np.savez(file, values=np.zeros((2, 2, 3), np.float32), description=description)
    return file


def test_a_description_beyond_unicode_is_refused(tmp_path):
    """NumPy makes a broken string of such code points, which no other code can handle."""
    text = np.frombuffer(np.array([0x7B, 0x21000061, 0x7D], "<u4").tobytes(), "<U3")[0:1].reshape(
        ()
    )
    with pytest.raises(LutFileError, match="the code point 553648225, which is no character"):
        Lut.load(with_description(tmp_path, text))


@pytest.mark.parametrize("description", [np.array(["{}"]), np.array(3.0), np.array(b"{}")])
def test_a_description_that_is_no_text_is_refused(tmp_path, description):
    with pytest.raises(LutFileError, match=r"description has shape .* and type"):
        Lut.load(with_description(tmp_path, description))


def test_a_deeply_nested_description_is_refused(tmp_path):
    with pytest.raises(LutFileError):
        Lut.load(with_description(tmp_path, np.array("[" * 100_000)))


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"provenance": 3}, "provenance is 3; it must be an object"),
        ({"provenance": ["ab"]}, "provenance is .'ab'.; it must be an object"),
        ({"rows": {"name": [1], "unit": "1", "low": 0, "high": 1}}, "name and unit must be text"),
        ({"rows": {"name": "a", "unit": None, "low": 0, "high": 1}}, "name and unit must be text"),
    ],
)
def test_a_description_with_values_of_wrong_types_is_refused(tmp_path, entry, message):
    axis = {"name": "a", "unit": "1", "low": 0.0, "high": 1.0}
    content = {"kind": "shadow", "columns": axis, "rows": axis, "provenance": {}} | entry
    with pytest.raises(LutFileError, match=message):
        Lut.load(with_description(tmp_path, np.array(json.dumps(content))))
