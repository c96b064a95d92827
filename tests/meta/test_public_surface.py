"""Public names: the contract, signatures and docstrings."""

from __future__ import annotations

import ast
import dataclasses
import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from importlib import import_module

import pytest

import skinshade as sk
from skinshade._core import errors

CONTRACT = {
    "bake": "source, output, settings=None",
    "build_curvature_lut": (
        "profile, *, size=(512, 512), radius_mm=(1.0, 100.0), kernel='sphere', energy_gain=True"
    ),
    "build_shadow_lut": "profile, *, size=(512, 512), width_mm=(8.0, 100.0), sharpening=10.0",
    "builtin_head": "seed=0",
    "diffuse_on_mesh": "positions_mm, faces, values, profile",
    "head_scene": "head, *, yaw_deg=28.0, pitch_deg=4.0",
    "load_head": "path, *, unit_mm=None",
    "load_scene": "path, *, lights=None",
    "limits": "",
    "load_mesh": "path, *, unit_mm=None",
    "mesh_curvature": ("positions, faces, normals=None, *, method='shape-operator', smoothing=2"),
    "mesh_curvature_tensor": "positions, faces, normals=None",
    "mesh_diffused_normals": "positions_mm, faces, normals, profile",
    "mesh_uv_scale": "positions, uvs, faces",
    "open_renderer": "scene, backend='auto'",
    "presets": "",
    "render": "scene, *, size=(1280, 720), backend='auto', samples=4",
    "save_image": "path, image, *, tone=None, exposure=None",
    "split_sun": "environment",
    "use_limits": "base=None, /, **changes",
    "Lut.load": "path",
    "Profile.burley": "*, length_mm, kind, albedo",
    "Profile.dipole": "*, sigma_s_prime_per_mm, sigma_a_per_mm, ior=1.3, albedo=None",
    "Profile.gaussians": "*, variances_mm2, weights, albedo",
    "Profile.preset": "name",
    "Profile.tabulated": "*, edges_mm, flux, albedo",
}
"""Signatures of the contract; a callable may take more keywords that have defaults."""

MEMBERS = {
    "Head": ["mesh", "material"],
    "Lut": ["values", "sample", "save", "load"],
    "Mesh": ["positions", "normals", "uvs", "faces", "unit_mm"],
    "Profile": ["transfer", "scaled", "rms_radius_mm", "albedo"],
    "RenderSettings": ["shading", "deep_scatter_taps", "debug_view", "seed"],
    "Scene": ["mesh", "camera", "material", "lights", "environment"],
}
FURTHER_NAMES = [
    *(
        "Camera",
        "DirectionalLight",
        "Environment",
        "EyeLuts",
        "EyeParams",
        "Material",
        "SkinParams",
        "SpotLight",
    ),
    *("InputError", "SkinshadeError", "__version__", "BakeSettings", "RenderedImage"),
    *("Skin", "build_eye_lut", "build_transfer_lut", "export_shaders", "gpu", "vertex_attributes"),
    *("AmbientTransfer", "Limits", "Part", "mesh_ambient_transfer", "mesh_thickness"),
]


def named(path):
    """Return the public object of a dotted name."""
    value = sk
    for name in path.split("."):
        value = getattr(value, name)
    return value


def test_the_exported_names_are_those_of_the_contract():
    expected = {name.split(".")[0] for name in (*CONTRACT, *MEMBERS)} | set(FURTHER_NAMES)
    assert sorted(expected) == sorted(sk.__all__)
    assert dir(sk) == sorted(sk.__all__)


@pytest.mark.parametrize("name", sk.__all__)
def test_every_public_name_can_be_imported(name):
    assert named(name) is not None
    space = {}
    exec(f"from skinshade import {name}", space)
    assert space[name] is named(name)


def test_an_unknown_name_is_an_attribute_error_that_names_it():
    with pytest.raises(AttributeError, match="no attribute 'dwarf'"):
        named("dwarf")


LAZY = ["skinshade", "skinshade.mesh", "skinshade.params", "skinshade.rendering"]
"""Packages whose public names are imported at their first use."""


@pytest.mark.parametrize("package", LAZY)
def test_imports_for_type_checkers_are_the_lazy_imports(package):
    module = import_module(package)
    block = next(
        node
        for node in ast.parse(inspect.getsource(module)).body
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    )
    sources = {alias.name: node.module for node in block.body for alias in node.names}
    for name, source in sources.items():
        if source is not None:  # None for a submodule
            value = getattr(import_module(f".{source}", package), name)
            assert getattr(module, name) is value, name
    assert {*sources, "__version__"} == {*module.__all__, "__version__"}


@pytest.mark.parametrize(
    "statement",
    ["import skinshade.baking.jobs", "import skinshade.rendering.api", "import skinshade.heads"],
)
def test_bake_and_render_are_functions_whichever_module_is_imported_first(statement):
    script = f"{statement}; import skinshade as sk; print(callable(sk.bake), callable(sk.render))"
    command = [sys.executable, "-W", "error", "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout == "True True\n"


@pytest.mark.parametrize("name", CONTRACT)
def test_every_signature_follows_the_contract(name):
    expected = inspect.signature(eval(f"lambda {CONTRACT[name]}: None")).parameters
    actual = inspect.signature(named(name)).parameters
    common = {key: (actual[key].kind, actual[key].default) for key in actual if key in expected}
    assert common == {key: (value.kind, value.default) for key, value in expected.items()}
    assert list(common) == list(expected)
    for key in actual.keys() - expected.keys():
        assert actual[key].kind is inspect.Parameter.KEYWORD_ONLY, key
        assert actual[key].default is not inspect.Parameter.empty, key


@pytest.mark.parametrize("name", MEMBERS)
def test_every_class_has_the_members_of_the_contract(name):
    kind = named(name)
    fields = [field.name for field in dataclasses.fields(kind)]
    assert [m for m in MEMBERS[name] if m not in fields and not hasattr(kind, m)] == []


# -- docstrings ------------------------------------------------------------------------------------


def members(path):
    """Yield name and value of every public function, property and constructor of a class."""
    for name, value in vars(named(path)).items():
        if not name.startswith("_"):
            value = getattr(value, "__func__", value)
            if inspect.isfunction(value) or isinstance(value, property):
                yield f"{path}.{name}", value


PUBLIC = {name: getattr(sk, name) for name in sk.__all__ if hasattr(sk, name)}
CLASSES = [name for name, value in PUBLIC.items() if inspect.isclass(value)]
METHODS = [pair for name in CLASSES for pair in members(name)]
FUNCTIONS = [(n, v) for n, v in PUBLIC.items() if callable(v) and n not in CLASSES]
MAKERS = [
    (name, getattr(named(name), "__func__", named(name)))
    for name, _ in METHODS
    if inspect.ismethod(named(name))
]


def by_name(pairs):
    return pytest.mark.parametrize("value", [v for _, v in pairs], ids=[n for n, _ in pairs])


def described(doc, heading):
    """Return the names that a section of a NumPy docstring describes."""
    section = re.search(rf"^{heading}\n-+\n((?:.*\n?)*?)(?=^\w.*\n-+\n|\Z)", doc, re.MULTILINE)
    heads = re.findall(r"^[\w*].*$", section[1], re.MULTILINE) if section else []
    return [name.strip(" *") for head in heads for name in head.split(" : ")[0].split(",")]


def parameters(value):
    return [
        key
        for key, value in inspect.signature(value).parameters.items()
        if key not in ("self", "cls") and value.kind is not inspect.Parameter.VAR_KEYWORD
    ]


@by_name([*[(n, named(n)) for n in CLASSES], *METHODS, *FUNCTIONS])
def test_every_public_name_has_a_docstring(value):
    doc = inspect.getdoc(value)
    assert doc
    assert doc.splitlines()[0].endswith(".") or "Error" in doc, doc.splitlines()[0]


@by_name([*FUNCTIONS, *MAKERS])
def test_a_function_or_constructor_describes_every_parameter_in_order(value):
    assert described(inspect.getdoc(value), "Parameters") == parameters(value)


@pytest.mark.parametrize("name", [n for n in CLASSES if dataclasses.is_dataclass(named(n))])
def test_a_class_describes_every_field_in_order(name):
    fields = dataclasses.fields(named(name))
    names = described(inspect.getdoc(named(name)), "Attributes")
    abouts = {
        field.name: field.metadata.get("meaning") or field.metadata.get("choice")
        for field in fields
    }
    if all(abouts.values()):
        names += [name for name, meaning in abouts.items() if meaning.about]
    assert sorted(names) == sorted(field.name for field in fields)


@by_name([p for p in METHODS if inspect.isfunction(p[1]) and p not in MAKERS])
def test_a_method_describes_or_names_every_parameter(value):
    doc = inspect.getdoc(value)
    unit = re.compile(r"_(mm|mm2|deg|per_mm)$")
    missing = [k for k in parameters(value) if not re.search(rf"\b{unit.sub('', k)}s?\b", doc)]
    assert missing == []


# -- errors ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def modules():
    names = [module.name for module in pkgutil.walk_packages(sk.__path__, "skinshade.")]
    return [importlib.import_module(name) for name in names if not name.endswith("__main__")]


def tree_lines(kind):
    """Return the lines of a drawing of an error and its subclasses."""
    lines = [kind.__name__]
    children = [child for child in kind.__subclasses__() if child.__module__ == errors.__name__]
    for child in children:
        last = child is children[-1]
        first, *rest = tree_lines(child)
        lines += [("└── " if last else "├── ") + first]
        lines += [("    " if last else "│   ") + line for line in rest]
    return lines


def test_the_drawing_of_the_tree_contains_every_error(modules):
    drawing = re.findall(r"^ {4}[ │├└─]*\w+Error\b", errors.__doc__, re.MULTILINE)
    assert tree_lines(errors.SkinshadeError) == [line[4:] for line in drawing]


def test_every_error_is_defined_in_one_module(modules):
    everything = [value for module in modules for value in vars(module).values()]
    kinds = [v for v in everything if inspect.isclass(v) and issubclass(v, Exception)]
    ours = [kind for kind in kinds if kind.__module__.startswith("skinshade.")]
    assert {kind.__module__ for kind in ours} == {"skinshade._core.errors"}
    assert {kind.__name__ for kind in ours} == set(errors.__all__)
