"""Accessors: every layout equals a reading byte by byte, and error messages name every fault."""

import struct
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gltf_shapes import CODES, TYPES
from skinshade._core.errors import MeshFileError
from skinshade.gltf import GltfDocument
from skinshade.gltf.accessors import read_accessor, read_matrices, read_triangles
from tolerances import ROUNDING

FORMATS = {"i1": "<b", "u1": "<B", "i2": "<h", "u2": "<H", "u4": "<I", "f4": "<f"}
DIVISORS = {"i1": 127.0, "u1": 255.0, "i2": 32767.0, "u2": 65535.0, "u4": 4294967295.0}
NAME = "folder/head.glb"


def document_of(json, data):
    json.setdefault("buffers", [{"byteLength": len(data)}])
    return GltfDocument(Path(NAME), json, data)


def unpacked_rows(data, start, stride, count, width, kind):
    """Return rows of numbers, each number unpacked separately."""
    size = struct.calcsize(FORMATS[kind])
    return [
        [struct.unpack_from(FORMATS[kind], data, start + row * stride + column * size)[0]
         for column in range(width)]
        for row in range(count)
    ]  # fmt: skip


def specified_value(value, kind, normalized):
    """Return the meaning of a stored number according to the specification (3.6.2.2)."""
    if kind == "f4" or not normalized:
        return float(value)
    return max(value / DIVISORS[kind], -1.0)


@st.composite
def layouts(draw):
    """Draw a document of one accessor, its bytes, and the rows that it means."""
    kind, width = draw(st.sampled_from(list(FORMATS))), draw(st.sampled_from(list(TYPES)))
    count, normalized = draw(st.integers(1, 9)), draw(st.booleans())
    element = width * struct.calcsize(FORMATS[kind])
    stride = draw(st.none() | st.integers(element, element + 40))
    start, offset = draw(st.integers(0, 20)), draw(st.integers(0, 20))
    needed = offset + (stride or element) * (count - 1) + element
    noise = np.random.default_rng(draw(st.integers(0, 10**6)))
    data = bytearray(noise.integers(0, 256, start + needed + draw(st.integers(0, 8)), np.uint8))
    if kind == "f4":  # arbitrary bits would include NaN
        data = bytearray(noise.normal(size=len(data)).astype("<f4").tobytes()[: len(data)])
    accessor = {"componentType": CODES[kind], "count": count, "type": TYPES[width]}
    accessor |= {"normalized": True} if normalized else {}
    views = []
    rows = [[0] * width for _ in range(count)]
    if draw(st.booleans()):
        accessor |= {"bufferView": 0, "byteOffset": offset}
        views.append({"buffer": 0, "byteOffset": start, "byteLength": needed})
        views[0] |= {"byteStride": stride} if stride else {}
        rows = unpacked_rows(data, start + offset, stride or element, count, width, kind)
    if draw(st.booleans()) or not views:
        replaced = sorted(draw(st.sets(st.integers(0, count - 1), min_size=1)))
        index = draw(st.sampled_from(["u1", "u2", "u4"]))
        stored = np.array(replaced, dtype=f"<{index}").tobytes()
        shift = draw(st.integers(0, 5))
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": shift + len(stored)})
        data += bytes(shift) + stored
        values = noise.integers(0, 100, (len(replaced), width)).astype(f"<{kind}")
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes})
        data += values.tobytes()
        accessor["sparse"] = {
            "count": len(replaced),
            "indices": {
                "bufferView": len(views) - 2,
                "componentType": CODES[index],
                "byteOffset": shift,
            },
            "values": {"bufferView": len(views) - 1},
        }
        for row, numbers in zip(replaced, values.tolist(), strict=True):
            rows[row] = numbers
    document = {"accessors": [accessor], "bufferViews": views}
    expected = [[specified_value(v, kind, normalized) for v in row] for row in rows]
    return document, bytes(data), width, expected


@settings(max_examples=300)
@given(layout=layouts())
def test_every_layout_equals_a_reading_byte_by_byte(layout):
    document, data, width, rows = layout
    values = read_accessor(document_of(document, data), 0, "here", width=width)
    assert values.dtype == np.float64
    np.testing.assert_allclose(values, rows, rtol=ROUNDING.value, atol=0.0)


@given(layout=layouts(), lost=st.integers(1, 400))
def test_a_short_buffer_is_refused_unless_the_accessor_fits_in_it(layout, lost):
    document, data, width, rows = layout
    short = data[: max(len(data) - lost, 1)]
    try:
        values = read_accessor(document_of(document, short), 0, "here", width=width)
    except MeshFileError as error:
        assert NAME in str(error)
        assert "accessor 0" in str(error)
        return
    np.testing.assert_allclose(values, rows, rtol=ROUNDING.value, atol=0.0)


def test_matrices_are_stored_column_by_column():
    data = np.arange(32, dtype="<f4").tobytes()
    document = {
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "MAT4"}],
        "bufferViews": [{"buffer": 0, "byteLength": 128}],
    }
    matrices = read_matrices(document_of(document, data), 0, "here")
    assert matrices.shape == (2, 4, 4)
    np.testing.assert_array_equal(matrices[0][:, 3], [12, 13, 14, 15])
    np.testing.assert_array_equal(matrices[1][0], [16, 20, 24, 28])


# -- triangles -------------------------------------------------------------------------------------


def triangles(indices, mode=None, count=9, kind="u1", **more):
    document = {"accessors": [], "bufferViews": []}
    primitive = {} if mode is None else {"mode": mode}
    data = b"\0"
    if indices is not None:
        data = np.array(indices, dtype=f"<{kind}").tobytes()
        entry = {"bufferView": 0, "componentType": CODES[kind], "count": len(indices)}
        document["accessors"] = [entry | {"type": "SCALAR"} | more]
        document["bufferViews"] = [{"buffer": 0, "byteLength": len(data)}]
        primitive["indices"] = 0
    return read_triangles(document_of(document, data), primitive, count, "mesh 0").tolist()


@pytest.mark.parametrize("kind", ["u1", "u2", "u4"])
@pytest.mark.parametrize("mode", [None, 4])
def test_a_triangle_list_has_three_corners_for_each_triangle(kind, mode):
    assert triangles([0, 1, 2, 2, 1, 3], mode, kind=kind) == [[0, 1, 2], [2, 1, 3]]
    assert triangles(None, mode, 6) == [[0, 1, 2], [3, 4, 5]]


def test_every_second_triangle_of_a_strip_is_reversed():
    # the specification: p_i = {v_i, v_(i + (1 + i % 2)), v_(i + (2 - i % 2))}
    assert triangles(None, 5, 6) == [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]]
    assert triangles([7, 3, 5, 1], 5) == [[7, 3, 5], [3, 1, 5]]


def test_all_triangles_of_a_fan_share_its_first_corner():
    assert triangles(None, 6, 5) == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]
    assert triangles([4, 2, 8, 1], 6) == [[4, 2, 8], [4, 8, 1]]


def test_degenerate_triangles_between_strips_are_left_out():
    assert triangles([0, 1, 2, 2, 3, 3, 4, 5], 5) == [[0, 1, 2], [3, 5, 4]]


@pytest.mark.parametrize("mode", [5, 6])
@pytest.mark.parametrize("count", [1, 2])
def test_a_strip_or_fan_of_one_or_two_corners_has_no_triangle(mode, count):
    assert triangles(None, mode, count) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"indices": [0, 1, 9]}, "index 9 is out of range"),
        ({"indices": [0, 1, 2, 3]}, "4 corners"),
        ({"indices": None, "count": 7}, "7 corners"),
        ({"indices": [0, 1, 2], "kind": "i1"}, "unsigned"),
        ({"indices": [0, 1, 2], "kind": "f4"}, "unsigned"),
        ({"indices": [0, 1, 2], "normalized": True}, "normalized"),
    ],
)
def test_faulty_indices_are_refused_by_name(arguments, message):
    with pytest.raises(MeshFileError, match=message) as caught:
        triangles(**arguments)
    assert NAME in str(caught.value)


# -- faults ----------------------------------------------------------------------------------------

ACCESSOR, VIEW, BUFFER, SPARSE = "accessors", "bufferViews", "buffers", "sparse"
NOT_WHOLE = [-1, 1.5, True, "1", None, [], {}, 2**64, 10**400]
FAULTS = [
    *((ACCESSOR, "count", value) for value in [*NOT_WHOLE, 0, 4, 10**9]),
    *((ACCESSOR, "byteOffset", value) for value in [*NOT_WHOLE, 1, 10**9]),
    *((ACCESSOR, "bufferView", value) for value in [*NOT_WHOLE, 5]),
    *((ACCESSOR, "type", value) for value in ["VEC2", "MAT3", "vec3", None, 3, [], {}, True]),
    *((ACCESSOR, "componentType", value) for value in [5124, 0, "5126", 5126.0, None, [], {}]),
    *((ACCESSOR, "normalized", value) for value in ["no", 1, None, []]),
    *((ACCESSOR, "sparse", value) for value in [None, 5, [], {}, "all", True]),
    *((VIEW, "byteLength", value) for value in [*NOT_WHOLE, 0, 35, 10**9]),
    *((VIEW, "byteOffset", value) for value in [*NOT_WHOLE, 14]),
    *((VIEW, "byteStride", value) for value in [*NOT_WHOLE, 0, 11, 13]),
    *((VIEW, "buffer", value) for value in [*NOT_WHOLE, 2]),
    *((BUFFER, "byteLength", value) for value in [*NOT_WHOLE, 0, 200]),
    *((BUFFER, "uri", value) for value in [5, [], True, "gone.bin", "data:,abc", "data:;base64,%"]),
    *((SPARSE, "count", value) for value in [*NOT_WHOLE, 0, 2, 10**9]),
    *((SPARSE, "indices", value) for value in [None, 5, [], {}, {"bufferView": 1}]),
    *((SPARSE, "values", value) for value in [None, 5, [], {}, {"bufferView": 7}]),
]


def valid_document():
    """Return the JSON and the bytes of three points, the last of which is sparse."""
    sparse = {
        "count": 1,
        "indices": {"bufferView": 1, "componentType": 5121},
        "values": {"bufferView": 2},
    }
    accessor = {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
    data = np.arange(9, dtype="<f4").tobytes() + b"\2" + np.ones(3, "<f4").tobytes()
    return {
        "accessors": [accessor | {"sparse": sparse}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 1},
            {"buffer": 0, "byteOffset": 37, "byteLength": 12},
        ],
        "buffers": [{"byteLength": len(data)}],
    }, data


def test_the_valid_document_is_read():
    values = read_accessor(document_of(*valid_document()), 0, "POSITION", width=3)
    np.testing.assert_array_equal(values, [[0, 1, 2], [3, 4, 5], [1, 1, 1]])


@pytest.mark.parametrize(("part", "key", "value"), FAULTS)
def test_the_error_of_every_fault_names_the_file_and_the_accessor(part, key, value):
    document, data = valid_document()
    entry = document["accessors"][0]["sparse"] if part == SPARSE else document[part][0]
    entry[key] = value
    with pytest.raises(MeshFileError) as caught:
        read_accessor(document_of(document, data), 0, "POSITION", width=3)
    assert NAME.split("/")[0] in str(caught.value)
    assert "accessor 0" in str(caught.value) or part == BUFFER
    assert len(str(caught.value)) < 600


@pytest.mark.parametrize("index", [-1, 1, 0.0, True, "0", None, [], {}])
def test_an_index_of_no_accessor_is_refused_by_name(index):
    with pytest.raises(MeshFileError, match="POSITION refers to accessors"):
        read_accessor(document_of(*valid_document()), index, "POSITION", width=3)


@pytest.mark.parametrize("index", [3, 255])
def test_a_sparse_index_out_of_range_is_refused_by_name(index):
    document, data = valid_document()
    changed = data[:36] + bytes([index]) + data[37:]
    with pytest.raises(MeshFileError, match=f"sparse index {index}"):
        read_accessor(document_of(document, changed), 0, "P", width=3)


def test_accessors_that_share_their_bytes_too_often_are_refused():
    """A thousand accessors of the same bytes would need a thousand times the file's memory."""
    data = bytes(1 << 20)
    document = {
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 1 << 20, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 1 << 20}],
    }
    gltf = document_of(document, data)
    with pytest.raises(MeshFileError, match="too many"):
        for _ in range(10):
            read_accessor(gltf, 0, "here", width=1)
