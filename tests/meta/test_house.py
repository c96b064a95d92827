"""Rules of the project, checked on its files."""

from __future__ import annotations

import ast
import importlib
import os
import re
import subprocess
import sys
import tomllib
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from skinshade._core import errors
from tolerances import Tolerance

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("src", "codegen", "fuzz", "tests", "benchmarks", "tools", "examples")
TEXT = {".py", ".md", ".toml", ".bib", ".json", ".slang", ".yml", ".txt", ".cfg", ""}
GENERATED = {"__pycache__", "findings"}
"""Folders of files that no commit has."""
MOST_LINES = 400
MACHINE_PATH = re.compile(r"(?<![\w.~/-])/(?:work|home|tmp|root|Users|mnt|opt)(?:/|\b)|\b[A-Z]:\\")
CHECKS = re.compile(r"^(?:pytest\.(?:raises|warns|fail)|np\.testing\.\w+|assert_\w+)$")
OTHER_ERRORS = {
    "src/skinshade/_core/lazy.py": {"AttributeError"},  # required of a module's __getattr__
    "src/skinshade/_core/arrays.py": {"TypeError"},  # caught in the same function
    "src/skinshade/cli/app.py": {"typer.Exit"},
    "src/skinshade/scene/schema.py": {"ValueError"},  # required of a validator of pydantic
}


@cache
def files(*folders, suffix=".py"):
    paths = [path for folder in folders for path in sorted((ROOT / folder).rglob(f"*{suffix}"))]
    return {str(p.relative_to(ROOT)): p.read_text(encoding="utf-8") for p in paths if p.is_file()}


@cache
def trees(*folders):
    return {name: ast.parse(text) for name, text in files(*folders).items()}


def text_files():
    everything = [*(ROOT / name for name in ("docs", ".ci", *FOLDERS)), ROOT]
    for folder in everything:
        for path in sorted(folder.rglob("*") if folder != ROOT else folder.iterdir()):
            if path.is_file() and path.suffix in TEXT and GENERATED.isdisjoint(path.parts):
                yield path


def functions(tree):
    return {n.name: n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)}


# -- files -----------------------------------------------------------------------------------------


def test_no_file_has_more_lines_than_the_limit():
    long = {name: len(text.splitlines()) for name, text in files(*FOLDERS).items()}
    assert {name: count for name, count in long.items() if count > MOST_LINES} == {}


def test_no_file_has_a_path_of_this_machine():
    lines = [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for path in text_files()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if MACHINE_PATH.search(line) and "MACHINE_PATH" not in line
    ]
    assert lines == []


@pytest.mark.parametrize("folder", ["home/x", "tmp/x", "work"])
def test_the_search_for_machine_paths_has_no_false_results(folder):
    assert MACHINE_PATH.search(f'open("/{folder}")')
    assert not MACHINE_PATH.search(f"https://a.org/{folder}, ../{folder}, ~/{folder}, a/{folder}")


# -- the package -----------------------------------------------------------------------------------


def lint(folder):
    script = "from importlinter.cli import lint_imports_command; lint_imports_command()"
    command = [sys.executable, "-c", script, "--no-cache", "--config", str(ROOT / "pyproject.toml")]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), str(ROOT)])}
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


def test_imports_point_downwards():
    done = lint(ROOT / "src")
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"Contracts: [1-9]\d* kept, 0 broken", done.stdout)


def test_every_folder_of_the_package_has_its_layer():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = settings["tool"]["importlinter"]["contracts"]
    contract = next(contract for contract in contracts if "containers" not in contract)
    layers = [name.strip() for layer in contract["layers"] for name in layer.split("|")]
    folders = {path.parent.name for path in (ROOT / "src" / "skinshade").glob("*/__init__.py")}
    assert sorted(layers) == sorted(["codegen", *(f"skinshade.{name}" for name in folders)])


def imports_of(name, tree):
    """Yield the modules of the package that a file imports, also inside functions and for type checkers."""
    parts = Path(name).with_suffix("").parts[1:]
    package = parts[:-1]
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = package[: len(package) - node.level + 1]
            module = ".".join([*base, *([node.module] if node.module else [])])
            yield from (f"{module}.{alias.name}" for alias in node.names)
            yield module


@cache
def import_graph():
    """Return the modules that every module of the package imports, by name."""
    modules = {
        ".".join(Path(name).with_suffix("").parts[1:]).removesuffix(".__init__"): (name, tree)
        for name, tree in trees("src").items()
    }
    return {
        module: {other for other in imports_of(name, tree) if other in modules and other != module}
        for module, (name, tree) in modules.items()
    }


def import_cycle(graph):
    """Return the modules of an import cycle, or None."""
    done, path = set(), []

    def visit(module):
        if module in path:
            return [*path[path.index(module) :], module]
        if module in done:
            return None
        path.append(module)
        cycle = next(filter(None, map(visit, sorted(graph[module]))), None)
        path.pop()
        done.add(module)
        return cycle

    return next(filter(None, map(visit, sorted(graph))), None)


def test_the_files_of_the_package_have_no_import_cycle():
    graph = import_graph()
    # A package's __init__ imports its files, so a file that imports from its package is not a cycle.
    files_only = {m: imported - {m.rpartition(".")[0]} for m, imported in graph.items()}
    assert sum(map(len, files_only.values())) > 300
    assert import_cycle(files_only) is None


def test_the_search_for_import_cycles_finds_them():
    assert import_cycle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert import_cycle({"a": {"b", "c"}, "b": {"c"}, "c": set()}) is None


ONLY_IN = {
    "wgpu": {"src/skinshade/gpu/device.py"},
    "OpenImageIO": {"src/skinshade/_core/pixels.py"},
    "trimesh": set(),  # a tool of the tests and benchmarks
    "DracoPy": {"src/skinshade/gltf/draco.py"},
    "embreex": {"src/skinshade/mesh/rays.py"},
}
"""Libraries that one file of the package imports."""


@pytest.mark.parametrize("library", ONLY_IN)
def test_a_library_is_imported_by_one_file(library):
    importers = set()
    for name, tree in trees("src").items():
        for node in ast.walk(tree):
            modules = [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            modules += [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            if any(module.partition(".")[0] == library for module in modules):
                importers.add(name)
    assert importers == ONLY_IN[library]


def test_every_public_function_class_and_module_has_a_docstring():
    undocumented = []
    for name, tree in trees("src").items():
        kinds = [n for n in tree.body if isinstance(n, ast.ClassDef)]
        bodies = [node for body in (tree, *kinds) for node in body.body]
        nodes = [n for n in bodies if isinstance(n, (ast.FunctionDef, ast.ClassDef))]
        public = [n for n in nodes if not n.name.startswith("_")]
        undocumented += [f"{name}: {node.name}" for node in public if not ast.get_docstring(node)]
        if not ast.get_docstring(tree):
            undocumented.append(name)
    assert undocumented == []


def test_every_error_that_is_raised_is_in_the_tree_of_errors():
    others = {}
    for name, tree in trees("src").items():
        raised = [n.exc for n in ast.walk(tree) if isinstance(n, ast.Raise) and n.exc is not None]
        kinds = {ast.unparse(e.func if isinstance(e, ast.Call) else e) for e in raised}
        kinds -= {*errors.__all__, "error", "type(error)"}
        if kinds - OTHER_ERRORS.get(name, set()):
            others[name] = kinds
    assert others == {}


# -- tests -----------------------------------------------------------------------------------------


def checking(node, helpers):
    """Return whether a function asserts, itself or through one of the helpers."""
    for child in ast.walk(node):
        if isinstance(child, ast.Assert):
            return True
        if isinstance(child, ast.Call):
            called = ast.unparse(child.func)
            if CHECKS.match(called) or called.split(".")[-1] in helpers:
                return True
    return False


def test_every_test_asserts_something():
    without = []
    shared = {}
    for name, tree in trees("tests").items():
        if not Path(name).name.startswith("test_"):
            shared |= functions(tree)
    shared_helpers = {n for n, node in shared.items() if n[:5] != "test_" and checking(node, ())}
    for name, tree in trees("tests").items():
        local = functions(tree)
        helpers = shared_helpers - local.keys()
        helpers |= {n for n, node in local.items() if n[:5] != "test_" and checking(node, ())}
        tests = [node for n, node in local.items() if n.startswith("test_")]
        without += [f"{name}: {node.name}" for node in tests if not checking(node, helpers)]
    assert without == []


@pytest.mark.parametrize(
    ("body", "checks"),
    [
        ("assert x", True),
        ("with pytest.raises(E): f()", True),
        ("np.testing.assert_allclose(a, b)", True),
        ("same(a)", True),
        ("f(a)\n    print(a == b)", False),
    ],
)
def test_the_search_for_assertions_finds_every_form(body, checks):
    tree = ast.parse(f"def test_it():\n    {body}")
    assert checking(tree.body[0], {"same"}) is checks


def test_names_of_tests_and_of_their_files_are_unique():
    for name, tree in trees("tests").items():
        bodies = [tree, *(n for n in ast.walk(tree) if isinstance(n, ast.ClassDef))]
        for body in bodies:
            names = [n.name for n in body.body if isinstance(n, ast.FunctionDef)]
            assert [n for n, count in Counter(names).items() if count > 1] == [], name
    stems = Counter(Path(name).stem for name in files("tests") if "conftest" not in name)
    assert [stem for stem, count in stems.items() if count > 1] == []


# -- tolerances ------------------------------------------------------------------------------------


def tables():
    """Yield name and tolerances of every variable that a file of tolerances defines."""
    for name in sorted(Path(n).stem for n in files("tests") if n.endswith("tolerances.py")):
        module = importlib.import_module(name)
        for key, value in vars(module).items():
            text = files("tests")[f"tests/{name}.py"]
            defined = re.search(rf"^{key}\b.* = ", text, re.MULTILINE)
            if defined and (tolerances := list(leaves(value))):
                yield key, tolerances


def leaves(value):
    """Yield the tolerances in a nested structure."""
    if isinstance(value, Tolerance):
        yield value
    elif isinstance(value, (dict, tuple, list)):
        for part in value.values() if isinstance(value, dict) else value:
            yield from leaves(part)


def test_every_tolerance_has_a_value_and_a_reason():
    everything = [(key, tolerance) for key, values in tables() for tolerance in values]
    assert len(everything) > 50
    for key, tolerance in everything:
        assert 0.0 < tolerance.value < float("inf"), key
        assert len(tolerance.reason.split()) >= 2, key
    names = Counter(key for key, _ in tables())
    assert [key for key, count in names.items() if count > 1] == []


def test_every_tolerance_is_used_by_a_test():
    tests = {n: t for n, t in trees("tests").items() if not n.endswith("tolerances.py")}
    used = {
        node.attr if isinstance(node, ast.Attribute) else node.id
        for tree in tests.values()
        for node in ast.walk(tree)
        if isinstance(node, (ast.Attribute, ast.Name))
    }
    assert [key for key, _ in tables() if key not in used] == []
