"""What notebooks and consoles show for a mesh."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest

import shapes
from skinshade.mesh import Mesh

BALL = shapes.sphere("icosphere", 2)
COUNT = len(BALL.positions)
UVS = BALL.positions[:, :2] * 0.5 + 0.5
MARKUP = "<script>alert('x') & \"y\"</script>"


def plain():
    return Mesh.checked(BALL.positions, BALL.faces, unit_mm=50.0, normals=BALL.normals)


def faulty():
    """Return a mesh with UVs, every baked attribute, and every kind of repair."""
    a, b = BALL.faces[0, :2]
    positions = np.vstack([BALL.positions, [[3.0, 3.0, 3.0], [9.0, 9.0, 9.0]]])
    reversed_face = BALL.faces.copy()
    reversed_face[9] = reversed_face[9, ::-1]
    faces = np.vstack([reversed_face, [[a, b, COUNT], [0, 0, 1]], BALL.faces[:1]])
    count = len(positions)
    attributes = {
        "curvature": np.zeros(count),
        "tensor": np.zeros((count, 6)),
        "thickness": np.ones(count),
    }
    uvs = np.zeros((count, 2))
    return Mesh.checked(positions, faces, unit_mm=10.0, uvs=uvs, attributes=attributes)


def with_long_attributes():
    attributes = {f"_ATTRIBUTE_{number}_{'x' * 60}": np.zeros(COUNT) for number in range(9)}
    return Mesh.checked(BALL.positions, BALL.faces, unit_mm=1.0, attributes=attributes)


MESHES = {
    "plain": plain,
    "with every repair": faulty,
    "with long attributes": with_long_attributes,
}
EVERY_MESH = pytest.mark.parametrize("make", MESHES.values(), ids=MESHES)


def rows(mesh):
    """Return the names and values of the HTML table; text that is not well-formed raises."""
    return {row[0].text: row[1].text for row in ET.fromstring(mesh._repr_html_()).iter("tr")}


@EVERY_MESH
def test_the_repr_is_one_line_of_at_most_200_characters(make):
    text = repr(make())
    assert text.startswith("Mesh(")
    assert "\n" not in text
    assert len(text) <= 200


def test_the_repr_states_counts_size_and_repairs():
    size = " × ".join(f"{side:.4g}" for side in np.ptp(BALL.positions * 50.0, axis=0))
    assert repr(plain()) == f"Mesh({COUNT} vertices, {len(BALL.faces)} faces, {size} mm)"
    mesh = Mesh.checked(BALL.positions, BALL.faces[1:], unit_mm=1.0, uvs=UVS)
    assert repr(mesh).endswith(f" mm, UVs; {COUNT} normals computed, 3 open edges)")


@EVERY_MESH
def test_the_html_states_counts_size_unit_uvs_and_attributes(make):
    mesh = make()
    table = rows(mesh)
    assert table["vertices"] == str(len(mesh.positions))
    assert table["faces"] == str(len(mesh.faces))
    assert table["unit, mm"] == f"{mesh.unit_mm:g}"
    assert table["UVs"] == ("no" if mesh.uvs is None else "yes")
    assert table["attributes"] == (", ".join(mesh.attributes) or "none")
    sides = [float(side) for side in table["size, mm"].split(" × ")]
    assert sides == pytest.approx(np.ptp(mesh.positions_mm, axis=0), rel=5e-4)


def test_the_html_states_every_repair():
    mesh = faulty()
    assert len(mesh.repairs) == 7
    table = rows(mesh)
    assert {repair: table[repair] for repair in mesh.repairs} == {
        repair: str(count) for repair, count in mesh.repairs.items()
    }


def test_markup_in_attribute_names_is_escaped():
    mesh = Mesh.checked(
        BALL.positions, BALL.faces, unit_mm=1.0, attributes={MARKUP: np.zeros(COUNT)}
    )
    assert "<script" not in mesh._repr_html_()
    assert rows(mesh)["attributes"] == MARKUP
