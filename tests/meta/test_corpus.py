"""Every file of the corpus of other formats than OBJ, PLY and STL gives the result that its table states."""

import re
import time
from pathlib import Path

import pytest

from skinshade._core.errors import SkinshadeError
from skinshade.baking import BakeSettings, bake
from skinshade.baking.records import read_record
from skinshade.lut import Lut
from skinshade.mesh import load_mesh
from skinshade.scene import load_scene
from skinshade.scene.images import read_image

resource = pytest.importorskip("resource", reason="measures memory")
FOLDER = Path(__file__).resolve().parents[1] / "corpus"
"""Names relative to the parent of this folder give errors the same text on every machine."""
ROW = re.compile(r"\| `([^`]+)` \| ([^|]+) \| `(.+)` \|")
TABLE = [
    match.groups()
    for line in (FOLDER / "README.md").read_text(encoding="utf-8").splitlines()
    if (match := ROW.fullmatch(line))
]
SECONDS = 2.0
"""Time in which every file is read or refused."""
MEMORY_MIB = 192
"""Most memory that a file takes beyond that of the process: an image of 4096×4096 pixels in float32."""


def read_gltf_and_bake(file, folder):
    """Return the mesh of a glTF, which a bake accepts, or raise the error that a bake raises, too."""
    try:
        mesh = load_mesh(file)
    except SkinshadeError as error:
        with pytest.raises(type(error)) as caught:
            bake(file, folder / "out.glb", BakeSettings())
        assert str(caught.value).startswith(f"{file}: ")
        assert list(folder.iterdir()) == []
        raise
    assert len(bake(file, folder / "out.glb", BakeSettings()).meshes) > 0
    return repr(mesh)


def read_pixels_as_text(file, _):
    """Return size and range of an image."""
    image = read_image(file)
    height, width, channels = image.shape
    return f"{width}×{height}×{channels}, {image.min():.3f} to {image.max():.3f}"


def read_record_as_text(file, _):
    """Return the number of meshes of a record."""
    record = read_record(file)
    return "no record" if record is None else f"a record of {len(record.meshes)} meshes"


READERS = {
    "gltf": read_gltf_and_bake,
    "image": read_pixels_as_text,
    "table": lambda file, _: repr(Lut.load(file)),
    "scene": lambda file, _: repr(load_scene(file)),
    "record": read_record_as_text,
}


def outcome(name, folder):
    """Return the result of reading a file, or the error without the name of the file."""
    file = Path(FOLDER.name) / name
    try:
        return READERS[name.partition("/")[0]](file, folder)
    except SkinshadeError as error:
        text = str(error).replace(str(FOLDER), FOLDER.name)
        return f"{type(error).__name__}: {text.removeprefix(f'corpus/{name}: ')}"


@pytest.mark.filterwarnings("ignore::skinshade._core.errors.UnitWarning")
@pytest.mark.parametrize(("name", "about", "result"), TABLE, ids=[row[0] for row in TABLE])
def test_a_file_gives_the_result_of_its_table(tmp_path, capfd, monkeypatch, name, about, result):
    monkeypatch.chdir(FOLDER.parent)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    start = time.process_time()
    assert outcome(name, tmp_path) == result, about
    assert time.process_time() - start < SECONDS
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MEMORY_MIB << 10
    assert capfd.readouterr() == ("", "")


def test_the_tables_name_every_file_of_these_folders():
    files = [path for folder in READERS for path in (FOLDER / folder).iterdir()]
    assert sorted(path.relative_to(FOLDER).as_posix() for path in files) == sorted(
        row[0] for row in TABLE
    )
    assert len(TABLE) > 120
