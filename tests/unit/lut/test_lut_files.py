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
from skinshade.lut import Axis, Lut, build_curvature_lut, build_shadow_lut

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
def test_a_table_comes_back_as_it_was(tmp_path, suffix, table):
    table.save(tmp_path / f"table{suffix}")
    back = Lut.load(tmp_path / f"table{suffix}")
    assert back.description() == table.description()
    assert back.values.dtype == np.float32
    if suffix == ".png":
        assert (np.abs(back.values.astype(float) - table.values) <= half_steps(table)).all()
    else:
        assert np.array_equal(back.values, table.values)


@SUFFIXES
@pytest.mark.parametrize("build", [build_curvature_lut, build_shadow_lut])
def test_a_baked_table_comes_back_with_its_origin(tmp_path, suffix, deon, build):
    table = build(deon, size=(32, 16))
    table.save(tmp_path / f"table{suffix}")
    back = Lut.load(tmp_path / f"table{suffix}")
    assert back.provenance == table.provenance
    assert (back.columns, back.rows, back.kind) == (table.columns, table.rows, table.kind)
    assert (np.abs(back.values.astype(float) - table.values) <= half_steps(table)).all()


@pytest.mark.parametrize("suffix", [".EXR", ".PNG", ".NPZ", ".Npz"])
def test_the_case_of_the_suffix_does_not_matter(tmp_path, deon, suffix):
    table = build_shadow_lut(deon, size=(8, 4))
    table.save(tmp_path / f"table{suffix}")
    assert [file.name for file in tmp_path.iterdir()] == [f"table{suffix}"]
    assert Lut.load(tmp_path / f"table{suffix}").values.shape == (4, 8, 3)


def test_an_exr_is_a_plain_float_image_for_any_other_program(tmp_path, deon):
    table = build_curvature_lut(deon, size=(8, 4))
    table.save(tmp_path / "table.exr")
    image = oiio.ImageBuf(str(tmp_path / "table.exr"))
    assert image.spec().format == oiio.FLOAT
    assert (image.spec().width, image.spec().height, image.spec().nchannels) == (8, 4, 3)
    assert np.array_equal(image.get_pixels(oiio.FLOAT), table.values)


def test_a_png_has_16_bits_and_its_range_in_the_metadata(tmp_path, deon):
    table = build_curvature_lut(deon, size=(8, 4))
    table.save(tmp_path / "table.png")
    spec = oiio.ImageBuf(str(tmp_path / "table.png")).spec()
    assert spec.format == oiio.UINT16
    record = json.loads(spec.getattribute("ImageDescription"))
    assert np.allclose(record["value_low"], table.values.min(axis=(0, 1)))
    assert np.allclose(record["value_span"], np.ptp(table.values, axis=(0, 1)))


def test_a_png_of_one_value_comes_back_exactly(tmp_path):
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
def test_what_is_no_table_is_refused_by_name(tmp_path, suffix, content):
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
    build_curvature_lut(deon, size=(64, 32)).save(file)
    whole = file.read_bytes()
    for share in (0.02, 0.4, 0.9):
        file.write_bytes(whole[: int(len(whole) * share)])
        with pytest.raises(LutFileError) as caught:
            Lut.load(file)
        assert str(file) in str(caught.value)


@SUFFIXES
@settings(SAME_FOLDER, max_examples=80)
@given(data=st.data())
def test_a_table_with_wrong_bytes_raises_nothing_of_its_readers(tmp_path, suffix, deon, data):
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
def test_a_picture_without_a_description_is_no_table(tmp_path, suffix):
    file = tmp_path / f"picture{suffix}"
    spec = oiio.ImageSpec(4, 4, 3, "uint16" if suffix == ".png" else "float")
    picture = oiio.ImageBuf(spec)
    assert picture.write(str(file))
    with pytest.raises(LutFileError, match="carries no description of its axes"):
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
def test_a_misstated_description_is_refused(tmp_path, description):
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
def test_values_that_are_no_table_are_refused(tmp_path, values):
    file = npz(tmp_path / "a.npz", values=values, description=json.dumps(GOOD))
    with pytest.raises(LutFileError):
        Lut.load(file)


def test_an_archive_of_something_else_is_refused(tmp_path):
    with pytest.raises(LutFileError, match="not a table saved by skinshade"):
        Lut.load(npz(tmp_path / "a.npz", weights=np.zeros(3)))


def test_a_bare_array_under_the_name_of_an_archive_is_refused(tmp_path):
    np.save(tmp_path / "a.npy", PLAIN)
    (tmp_path / "a.npy").rename(tmp_path / "a.npz")
    with pytest.raises(LutFileError):
        Lut.load(tmp_path / "a.npz")


@pytest.mark.parametrize("name", ["table.tif", "table", "table.npz.gz", "table.jpg"])
def test_another_suffix_is_refused_with_the_choices(tmp_path, deon, name):
    with pytest.raises(ArgumentError, match=r"\.exr, \.png or \.npz"):
        build_shadow_lut(deon, size=(4, 4)).save(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


@SUFFIXES
@pytest.mark.parametrize("place", ["missing", "file"])
def test_a_place_that_cannot_be_written_is_named(tmp_path, deon, suffix, place):
    (tmp_path / "file").write_bytes(b"x")
    target = tmp_path / place / f"table{suffix}"
    with pytest.raises(OutputError) as caught:
        build_shadow_lut(deon, size=(4, 4)).save(target)
    assert str(target) in str(caught.value)
    assert [file.name for file in tmp_path.iterdir()] == ["file"]


@SUFFIXES
@pytest.mark.skipif(AS_ROOT, reason="root may write everywhere")
def test_a_folder_without_permission_stays_empty(tmp_path, deon, suffix):
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="cannot write here"):
        build_shadow_lut(deon, size=(4, 4)).save(tmp_path / f"table{suffix}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", [".exr", ".png"])
def test_a_write_that_fails_halfway_names_the_file_and_keeps_the_old_one(
    tmp_path, deon, suffix, monkeypatch
):
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
