"""Every file of the corpus gives the result that its table states."""

import re
from pathlib import Path

import numpy as np
import pytest

from skinshade._core.errors import SkinshadeError
from skinshade.mesh import load_mesh

FOLDER = Path(__file__).resolve().parents[2] / "corpus"
ROW = re.compile(r"\| `(.+?)` \| .+? \| (.+?) \| (.+?) \| `(.+)` \|")
TABLE = [
    match.groups()
    for line in (FOLDER / "README.md").read_text(encoding="utf-8").splitlines()
    if (match := ROW.fullmatch(line))
]
CORNERS = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0]])
SHAPES = {
    "tetrahedron": CORNERS[[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]],
    "square": CORNERS[[[0, 1, 4], [0, 4, 2]]],
}


def triangles_of(corners):
    """Return triangles (F, 3, 3) as a set; their first corner is the least one."""
    turned = set()
    for triangle in np.round(corners, 9) + 0.0:  # a file has 1e-44 instead of 0
        a, b, c = (tuple(corner.tolist()) for corner in triangle)
        turned.add(min((a, b, c), (b, c, a), (c, a, b)))
    return turned


@pytest.mark.parametrize(("name", "shape", "unit", "result"), TABLE, ids=[row[0] for row in TABLE])
def test_a_file_gives_the_result_of_the_table(name, shape, unit, result, capfd):
    file = FOLDER / name
    unit_mm = None if unit == "none" else float(unit)
    try:
        mesh = load_mesh(file, unit_mm=unit_mm)
    except SkinshadeError as error:
        text = str(error)
        assert text.startswith(str(file))
        assert f"{type(error).__name__}: {text[len(str(file)) + 2 :]}" == result
    else:
        assert repr(mesh) == result
        if shape != "-":
            assert triangles_of(mesh.positions[mesh.faces]) == triangles_of(SHAPES[shape])
    assert capfd.readouterr() == ("", "")


def test_the_tables_name_every_file():
    files = [path for path in FOLDER.rglob("*") if path.suffix in (".obj", ".ply", ".stl")]
    assert sorted(path.relative_to(FOLDER).as_posix() for path in files) == sorted(
        r[0] for r in TABLE
    )
    assert len(TABLE) > 200
