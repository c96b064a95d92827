"""`import skinshade` imports no other package; a name imports only what it needs."""

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

READERS_AND_PICTURES = {"trimesh", "OpenImageIO", "PIL", "matplotlib", "pooch", "pydantic"}
TERMINAL = {"typer", "rich", "click", "wgpu"}
NEVER_NEEDED_FOR = {
    "presets": READERS_AND_PICTURES | TERMINAL,
    "Profile": READERS_AND_PICTURES | TERMINAL,
    "build_curvature_lut": (READERS_AND_PICTURES | TERMINAL) - {"OpenImageIO"},
    "build_shadow_lut": (READERS_AND_PICTURES | TERMINAL) - {"OpenImageIO"},
    "mesh_curvature": READERS_AND_PICTURES | TERMINAL,
    "diffuse_on_mesh": READERS_AND_PICTURES | TERMINAL,
    "SkinParams": READERS_AND_PICTURES | TERMINAL | {"scipy"},
    "SkinshadeError": READERS_AND_PICTURES | TERMINAL | {"scipy", "numpy"},
    "Scene": TERMINAL | {"matplotlib", "pooch", "PIL", "trimesh", "pydantic"},
    "render": TERMINAL | {"matplotlib", "pooch", "PIL", "trimesh", "pydantic"},
    "builtin_head": TERMINAL | {"matplotlib", "pooch", "PIL", "trimesh", "pydantic"},
    "bake": TERMINAL | {"matplotlib", "pooch", "PIL", "trimesh", "pydantic"},
}
"""Packages that importing a name must not import; those that read files are imported on use."""


def loaded(statement):
    """Return the packages, without the standard library, that a statement imports in a new process."""
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
def test_the_import_imports_no_other_package(statement):
    assert loaded(statement) == {"skinshade"}


def test_the_probe_finds_imported_packages():
    assert {"numpy", "scipy"} <= loaded("import scipy.fft")


@pytest.mark.parametrize("name", NEVER_NEEDED_FOR)
def test_a_name_imports_only_what_it_needs(name):
    assert loaded(f"from skinshade import {name}") & NEVER_NEEDED_FOR[name] == set()


def test_the_library_does_not_import_its_command_line():
    statement = "import skinshade, sys; [getattr(skinshade, n) for n in skinshade.__all__]"
    statement += "; assert not any(m.startswith('skinshade.cli') for m in sys.modules)"
    assert loaded(statement).isdisjoint({"typer", "rich", "click"})


CPU_SECONDS = """
import resource, sys
{statement}
used = resource.getrusage(resource.RUSAGE_SELF)
print(used.ru_utime + used.ru_stime)
"""
IMPORT_SECONDS, HELP_SECONDS, COMMAND_HELP_SECONDS = 0.1, 0.25, 0.4
"""Limits of CPU time, which depends little on other work on the machine."""


def cpu_seconds(statement):
    """Return the least CPU time of five new processes that run a statement, s, with the start of Python."""
    command = [sys.executable, "-c", CPU_SECONDS.format(statement=statement)]
    times = []
    for _ in range(5):
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        times.append(float(done.stdout.splitlines()[-1]))
    return min(times)


def test_importing_skinshade_takes_less_than_a_tenth_of_a_second():
    assert cpu_seconds("import skinshade") <= IMPORT_SECONDS


@pytest.mark.parametrize("words", [["--help"], ["render", "--help"]], ids="-".join)
def test_the_help_takes_little_time_and_imports_no_numerical_packages(words):
    call = f"sys.argv = {['skinshade', *words]}\ntry:\n    main()\nexcept SystemExit:\n    pass"
    statement = f"from skinshade.cli import main\n{call}\nsys.stdout.flush()"
    limit = HELP_SECONDS if words == ["--help"] else COMMAND_HELP_SECONDS
    assert cpu_seconds(statement) <= limit
    packages = {"numpy", "scipy", "trimesh", "matplotlib", "wgpu", "pydantic"}
    output = subprocess.run(
        [sys.executable, "-c", PROBE.format(statement=statement)],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert set(json.loads(output.splitlines()[-1])).isdisjoint(packages)
