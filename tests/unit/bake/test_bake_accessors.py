"""Numbers out of a glTF file: every layout against a reading byte by byte, and every fault by name."""

import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gltf_shapes import CODES, TYPES
from skinshade._core.errors import MeshFileError
from skinshade.bake.accessors import read_accessor, read_matrices, read_triangles
from skinshade.bake.gltf import GltfFile
from tolerances import ROUNDING

FORMATS = {"i1": "<b", "u1": "<B", "i2": "<h", "u2": "<H", "u4": "<I", "f4": "<f"}
DIVISORS = {"i1": 127.0, "u1": 255.0, "i2": 32767.0, "u2": 65535.0, "u4": 4294967295.0}
NAME = "folder/head.glb"


def opened(document, data):
    document.setdefault("buffers", [{"byteLength": len(data)}])
    return GltfFile(Path(NAME), document, data)


def one_by_one(data, start, stride, count, width, kind):
    """Rows of numbers, each unpacked by itself."""
    size = struct.calcsize(FORMATS[kind])
    return [
        [struct.unpack_from(FORMATS[kind], data, start + row * stride + column * size)[0]
         for column in range(width)]
        for row in range(count)
    ]  # fmt: skip


def meant(value, kind, normalized):
    """As the specification says (3.6.2.2)."""
    if kind == "f4" or not normalized:
        return float(value)
    return max(value / DIVISORS[kind], -1.0)


@st.composite
def layouts(draw):
    """A document of one accessor, its bytes, and the rows that it means."""
    kind, width = draw(st.sampled_from(list(FORMATS))), draw(st.sampled_from(list(TYPES)))
    count, normalized = draw(st.integers(1, 9)), draw(st.booleans())
    element = width * struct.calcsize(FORMATS[kind])
    stride = draw(st.none() | st.integers(element, element + 40))
    at, offset = draw(st.integers(0, 20)), draw(st.integers(0, 20))
    needed = offset + (stride or element) * (count - 1) + element
    noise = np.random.default_rng(draw(st.integers(0, 10**6)))
    data = bytearray(noise.integers(0, 256, at + needed + draw(st.integers(0, 8)), np.uint8))
    if kind == "f4":  # any bits would mean NaN too
        data = bytearray(noise.normal(size=len(data)).astype("<f4").tobytes()[: len(data)])
    accessor = {"componentType": CODES[kind], "count": count, "type": TYPES[width]}
    accessor |= {"normalized": True} if normalized else {}
    views = []
    rows = [[0] * width for _ in range(count)]
    if draw(st.booleans()):
        accessor |= {"bufferView": 0, "byteOffset": offset}
        views.append({"buffer": 0, "byteOffset": at, "byteLength": needed})
        views[0] |= {"byteStride": stride} if stride else {}
        rows = one_by_one(data, at + offset, stride or element, count, width, kind)
    if draw(st.booleans()) or not views:
        places = sorted(draw(st.sets(st.integers(0, count - 1), min_size=1)))
        index = draw(st.sampled_from(["u1", "u2", "u4"]))
        stored = np.array(places, dtype=f"<{index}").tobytes()
        shift = draw(st.integers(0, 5))
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": shift + len(stored)})
        data += bytes(shift) + stored
        values = noise.integers(0, 100, (len(places), width)).astype(f"<{kind}")
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        data += values.tobytes()
        accessor["sparse"] = {
            "count": len(places),
            "indices": {
                "bufferView": len(views) - 2,
                "componentType": CODES[index],
                "byteOffset": shift,
            },
            "values": {"bufferView": len(views) - 1},
        }
        for place, row in zip(places, values.tolist(), strict=True):
            rows[place] = row
    document = {"accessors": [accessor], "bufferViews": views}
    return document, bytes(data), width, [[meant(v, kind, normalized) for v in r] for r in rows]


@settings(max_examples=300)
@given(layout=layouts())
def test_every_layout_reads_as_byte_by_byte(layout):
    document, data, width, rows = layout
    found = read_accessor(opened(document, data), 0, "here", width=width)
    assert found.dtype == np.float64
    np.testing.assert_allclose(found, rows, rtol=ROUNDING.value, atol=0.0)


@given(layout=layouts(), lost=st.integers(1, 400))
def test_a_buffer_that_is_too_short_is_refused_or_not_missed(layout, lost):
    document, data, width, rows = layout
    short = data[: max(len(data) - lost, 1)]
    try:
        found = read_accessor(opened(document, short), 0, "here", width=width)
    except MeshFileError as error:
        assert NAME in str(error)
        assert "accessor 0" in str(error)
        return
    np.testing.assert_allclose(found, rows, rtol=ROUNDING.value, atol=0.0)


def test_matrices_stand_column_after_column():
    data = np.arange(32, dtype="<f4").tobytes()
    document = {
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "MAT4"}],
        "bufferViews": [{"buffer": 0, "byteLength": 128}],
    }
    found = read_matrices(opened(document, data), 0, "here")
    assert found.shape == (2, 4, 4)
    np.testing.assert_array_equal(found[0][:, 3], [12, 13, 14, 15])
    np.testing.assert_array_equal(found[1][0], [16, 20, 24, 28])


# -- triangles -------------------------------------------------------------------------------------


def triangles(indices, mode=None, count=9, kind="u1", **more):
    document = {"accessors": [], "bufferViews": []}
    primitive = {} if mode is None else {"mode": mode}
    data = b"\0"
    if indices is not None:
        data = np.array(indices, dtype=f"<{kind}").tobytes()
        described = {"bufferView": 0, "componentType": CODES[kind], "count": len(indices)}
        document["accessors"] = [described | {"type": "SCALAR"} | more]
        document["bufferViews"] = [{"buffer": 0, "byteLength": len(data)}]
        primitive["indices"] = 0
    return read_triangles(opened(document, data), primitive, count, "mesh 0").tolist()


@pytest.mark.parametrize("kind", ["u1", "u2", "u4"])
@pytest.mark.parametrize("mode", [None, 4])
def test_a_list_is_three_by_three(kind, mode):
    assert triangles([0, 1, 2, 2, 1, 3], mode, kind=kind) == [[0, 1, 2], [2, 1, 3]]
    assert triangles(None, mode, 6) == [[0, 1, 2], [3, 4, 5]]


def test_a_strip_turns_every_other_triangle():
    # the specification's example: p_i = {v_i, v_(i + (1 + i % 2)), v_(i + (2 - i % 2))}
    assert triangles(None, 5, 6) == [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]]
    assert triangles([7, 3, 5, 1], 5) == [[7, 3, 5], [3, 1, 5]]


def test_a_fan_begins_at_its_first_corner():
    assert triangles(None, 6, 5) == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]
    assert triangles([4, 2, 8, 1], 6) == [[4, 2, 8], [4, 8, 1]]


def test_triangles_that_stitch_strips_together_are_left_out():
    assert triangles([0, 1, 2, 2, 3, 3, 4, 5], 5) == [[0, 1, 2], [3, 5, 4]]


@pytest.mark.parametrize("mode", [5, 6])
@pytest.mark.parametrize("count", [1, 2])
def test_one_or_two_corners_are_no_triangle(mode, count):
    assert triangles(None, mode, count) == []


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"indices": [0, 1, 9]}, "index 9 is out of range"),
        ({"indices": [0, 1, 2, 3]}, "4 corners"),
        ({"indices": None, "count": 7}, "7 corners"),
        ({"indices": [0, 1, 2], "kind": "i1"}, "unsigned"),
        ({"indices": [0, 1, 2], "kind": "f4"}, "unsigned"),
        ({"indices": [0, 1, 2], "normalized": True}, "normalized"),
    ],
)
def test_indices_that_are_none_are_named(wrong, said):
    with pytest.raises(MeshFileError, match=said) as caught:
        triangles(**wrong)
    assert NAME in str(caught.value)


# -- faults ----------------------------------------------------------------------------------------

ACCESSOR, VIEW, BUFFER, SPARSE = "accessors", "bufferViews", "buffers", "sparse"
WHOLE = [-1, 1.5, True, "1", None, [], {}, 2**64, 10**400]
FAULTS = [
    *((ACCESSOR, "count", value) for value in [*WHOLE, 0, 4, 10**9]),
    *((ACCESSOR, "byteOffset", value) for value in [*WHOLE, 1, 10**9]),
    *((ACCESSOR, "bufferView", value) for value in [*WHOLE, 5]),
    *((ACCESSOR, "type", value) for value in ["VEC2", "MAT3", "vec3", None, 3, [], {}, True]),
    *((ACCESSOR, "componentType", value) for value in [5124, 0, "5126", 5126.0, None, [], {}]),
    *((ACCESSOR, "normalized", value) for value in ["no", 1, None, []]),
    *((ACCESSOR, "sparse", value) for value in [None, 5, [], {}, "all", True]),
    *((VIEW, "byteLength", value) for value in [*WHOLE, 0, 35, 10**9]),
    *((VIEW, "byteOffset", value) for value in [*WHOLE, 14]),
    *((VIEW, "byteStride", value) for value in [*WHOLE, 0, 11, 13]),
    *((VIEW, "buffer", value) for value in [*WHOLE, 2]),
    *((BUFFER, "byteLength", value) for value in [*WHOLE, 0, 200]),
    *((BUFFER, "uri", value) for value in [5, [], True, "gone.bin", "data:,abc", "data:;base64,%"]),
    *((SPARSE, "count", value) for value in [*WHOLE, 0, 2, 10**9]),
    *((SPARSE, "indices", value) for value in [None, 5, [], {}, {"bufferView": 1}]),
    *((SPARSE, "values", value) for value in [None, 5, [], {}, {"bufferView": 7}]),
]


def sound():
    """Three points, the last of which is sparse."""
    sparse = {
        "count": 1,
        "indices": {"bufferView": 1, "componentType": 5121},
        "values": {"bufferView": 2},
    }
    data = np.arange(9, dtype="<f4").tobytes() + b"\2" + np.ones(3, "<f4").tobytes()
    return {
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": 3,
                "type": "VEC3",
                "sparse": sparse,
            }
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 1},
            {"buffer": 0, "byteOffset": 37, "byteLength": 12},
        ],
        "buffers": [{"byteLength": len(data)}],
    }, data


def test_what_is_sound_is_read():
    found = read_accessor(opened(*sound()), 0, "POSITION", width=3)
    np.testing.assert_array_equal(found, [[0, 1, 2], [3, 4, 5], [1, 1, 1]])


@pytest.mark.parametrize(("part", "key", "value"), FAULTS)
def test_every_fault_names_the_file_and_the_accessor(part, key, value):
    document, data = sound()
    described = document["accessors"][0]["sparse"] if part == SPARSE else document[part][0]
    described[key] = value
    with pytest.raises(MeshFileError) as caught:
        read_accessor(opened(document, data), 0, "POSITION", width=3)
    assert NAME.split("/")[0] in str(caught.value)
    assert "accessor 0" in str(caught.value) or part == BUFFER
    assert len(str(caught.value)) < 600


@pytest.mark.parametrize("index", [-1, 1, 0.0, True, "0", None, [], {}])
def test_an_index_that_points_nowhere_is_named(index):
    with pytest.raises(MeshFileError, match="POSITION refers to accessors"):
        read_accessor(opened(*sound()), index, "POSITION", width=3)


@pytest.mark.parametrize("place", [3, 255])
def test_a_sparse_index_out_of_range_is_named(place):
    document, data = sound()
    with pytest.raises(MeshFileError, match=f"sparse index {place}"):
        read_accessor(opened(document, data[:36] + bytes([place]) + data[37:]), 0, "P", width=3)


def test_a_few_bytes_read_over_and_over_are_refused():
    """A thousand accessors of the same bytes would take a thousand times the file's memory."""
    data = bytes(1 << 20)
    document = {
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 1 << 20, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 1 << 20}],
    }
    gltf = opened(document, data)
    with pytest.raises(MeshFileError, match="too many"):
        for _ in range(10):
            read_accessor(gltf, 0, "here", width=1)
