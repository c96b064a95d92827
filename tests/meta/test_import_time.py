"""`import skinshade` loads nothing but itself; each name loads what it needs, and no more."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

PROBE = """
import json, sys
before = set(sys.modules)
{statement}
loaded = {{name.partition(".")[0] for name in set(sys.modules) - before}}
print(json.dumps(sorted(loaded - set(sys.stdlib_module_names))))
"""

READERS_AND_PICTURES = {"trimesh", "pygltflib", "OpenImageIO", "PIL", "matplotlib", "pooch"}
TERMINAL = {"typer", "rich", "click"}
NEVER_NEEDED_FOR = {
    "presets": READERS_AND_PICTURES | TERMINAL,
    "Profile": READERS_AND_PICTURES | TERMINAL,
    "build_curvature_lut": READERS_AND_PICTURES | TERMINAL,
    "build_shadow_lut": READERS_AND_PICTURES | TERMINAL,
    "mesh_curvature": READERS_AND_PICTURES | TERMINAL,
    "diffuse_on_mesh": READERS_AND_PICTURES | TERMINAL,
    "SkinParams": READERS_AND_PICTURES | TERMINAL | {"scipy"},
    "SkinshadeError": READERS_AND_PICTURES | TERMINAL | {"scipy", "numpy"},
    "Scene": TERMINAL | {"matplotlib", "pooch", "PIL"},
    "render": TERMINAL | {"matplotlib", "pooch", "PIL"},
    "builtin_head": TERMINAL | {"matplotlib", "pooch", "PIL"},
}
"""What a name must not load: readers wait for a file, the terminal for the command line."""


def loaded(statement):
    """Packages, beside the standard library, that a statement loads in a fresh interpreter."""
    command = [sys.executable, "-W", "error", "-c", PROBE.format(statement=statement)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stdout))


@pytest.mark.parametrize(
    "statement",
    [
        "import skinshade",
        "import skinshade; skinshade.__version__; dir(skinshade)",
        "from skinshade import SkinshadeError, InputError",
    ],
)
def test_the_import_loads_nothing_but_skinshade(statement):
    assert loaded(statement) == {"skinshade"}


def test_the_probe_sees_what_is_loaded():
    assert {"numpy", "scipy"} <= loaded("import scipy.fft")


@pytest.mark.parametrize("name", NEVER_NEEDED_FOR)
def test_a_name_loads_only_what_it_needs(name):
    assert loaded(f"from skinshade import {name}") & NEVER_NEEDED_FOR[name] == set()


def test_the_library_never_loads_its_command_line():
    statement = "import skinshade, sys; [getattr(skinshade, n) for n in skinshade.__all__]"
    statement += "; assert not any(m.startswith('skinshade.cli') for m in sys.modules)"
    assert loaded(statement).isdisjoint(TERMINAL)
