"""The names that others build on: which there are, how they are called, and what they say of it."""

from __future__ import annotations

import ast
import dataclasses
import importlib
import inspect
import pkgutil
import re
from functools import cached_property

import pytest

import skinshade as sk
from skinshade._core import errors

CONTRACT = {
    "build_curvature_lut": (
        "profile, *, size=(512, 512), radius_mm=(1.0, 100.0), kernel='sphere', energy_gain=True"
    ),
    "build_shadow_lut": "profile, *, size=(512, 512), width_mm=(8.0, 100.0), sharpening=10.0",
    "diffuse_on_mesh": "positions_mm, faces, values, profile",
    "load_mesh": "path, *, unit_mm=None",
    "mesh_curvature": ("positions, faces, normals=None, *, method='shape-operator', smoothing=2"),
    "mesh_curvature_tensor": "positions, faces, normals=None",
    "mesh_diffused_normals": "positions_mm, faces, normals, profile",
    "mesh_uv_scale": "positions, uvs, faces",
    "presets": "",
    "render": "scene, *, size=(1280, 720), backend='auto', samples=4",
    "Lut.load": "path",
    "Profile.burley": "*, length_mm, kind, albedo",
    "Profile.dipole": "*, sigma_s_prime_per_mm, sigma_a_per_mm, ior=1.3, albedo=None",
    "Profile.gaussians": "*, variances_mm2, weights, albedo",
    "Profile.preset": "name",
    "Profile.tabulated": "*, edges_mm, flux, albedo",
}
"""What was promised; a callable may take more, by keyword and with a default."""

MEMBERS = {
    "Lut": ["values", "sample", "save", "load"],
    "Mesh": ["positions", "normals", "uvs", "faces", "unit_mm"],
    "Profile": ["transfer", "scaled", "rms_radius_mm", "albedo"],
    "RenderSettings": ["shading", "deep_scatter_taps", "debug_view", "seed"],
    "Scene": ["mesh", "camera", "material", "lights", "environment"],
}
BESIDE_THE_CONTRACT = [
    *("Camera", "DirectionalLight", "Environment", "Material", "SkinParams", "SpotLight"),
    *("InputError", "SkinshadeError", "__version__", "builtin_head", "head_scene", "load_scene"),
    *("Skin", "build_transfer_lut", "export_shaders", "gpu", "vertex_attributes"),
]


def found(path):
    value = sk
    for name in path.split("."):
        value = getattr(value, name)
    return value


def test_what_is_exported_is_the_contract_and_nothing_else():
    promised = {name.split(".")[0] for name in (*CONTRACT, *MEMBERS)} | set(BESIDE_THE_CONTRACT)
    assert sorted(promised) == sorted(sk.__all__)
    assert dir(sk) == sorted(sk.__all__)


@pytest.mark.parametrize("name", sk.__all__)
def test_every_public_name_can_be_had(name):
    assert found(name) is not None
    space = {}
    exec(f"from skinshade import {name}", space)
    assert space[name] is found(name)


def test_a_name_that_is_not_there_is_an_attribute_error_that_names_it():
    with pytest.raises(AttributeError, match="no attribute 'dwarf'"):
        found("dwarf")


def test_type_checkers_are_told_the_homes_that_the_lazy_imports_have():
    block = next(
        node
        for node in ast.parse(inspect.getsource(sk)).body
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    )
    told = {alias.name: f".{node.module or ''}" for node in block.body for alias in node.names}
    assert told == {**sk._HOME_OF, "gpu": ".", "render": ".render"}
    assert {*told, "__version__"} == set(sk.__all__)


@pytest.mark.parametrize("name", CONTRACT)
def test_every_call_takes_what_was_promised(name):
    promised = inspect.signature(eval(f"lambda {CONTRACT[name]}: None")).parameters
    real = inspect.signature(found(name)).parameters
    plain = {key: (real[key].kind, real[key].default) for key in real if key in promised}
    assert plain == {key: (value.kind, value.default) for key, value in promised.items()}
    assert list(plain) == list(promised)
    for key in real.keys() - promised.keys():
        assert real[key].kind is inspect.Parameter.KEYWORD_ONLY, key
        assert real[key].default is not inspect.Parameter.empty, key


@pytest.mark.parametrize("name", MEMBERS)
def test_every_class_has_the_members_that_were_promised(name):
    kind = found(name)
    fields = [field.name for field in dataclasses.fields(kind)]
    assert [m for m in MEMBERS[name] if m not in fields and not hasattr(kind, m)] == []


# -- what they say ---------------------------------------------------------------------------------


def members(path):
    """Every public function, property and constructor of a class, by name."""
    for name, value in vars(found(path)).items():
        if not name.startswith("_"):
            value = getattr(value, "__func__", value)
            if inspect.isfunction(value) or isinstance(value, (property, cached_property)):
                yield f"{path}.{name}", value


PUBLIC = {name: getattr(sk, name) for name in sk.__all__ if hasattr(sk, name)}
CLASSES = [name for name, value in PUBLIC.items() if inspect.isclass(value)]
METHODS = [pair for name in CLASSES for pair in members(name)]
FUNCTIONS = [(n, v) for n, v in PUBLIC.items() if callable(v) and n not in CLASSES]
MAKERS = [
    (name, getattr(found(name), "__func__", found(name)))
    for name, _ in METHODS
    if inspect.ismethod(found(name))
]


def by_name(pairs):
    return pytest.mark.parametrize("value", [v for _, v in pairs], ids=[n for n, _ in pairs])


def described(doc, heading):
    """Names that a section of a NumPy docstring describes."""
    section = re.search(rf"^{heading}\n-+\n((?:.*\n?)*?)(?=^\w.*\n-+\n|\Z)", doc, re.MULTILINE)
    heads = re.findall(r"^[\w*].*$", section[1], re.MULTILINE) if section else []
    return [name.strip(" *") for head in heads for name in head.split(" : ")[0].split(",")]


def parameters(value):
    return [
        key
        for key, value in inspect.signature(value).parameters.items()
        if key not in ("self", "cls") and value.kind is not inspect.Parameter.VAR_KEYWORD
    ]


@by_name([*[(n, found(n)) for n in CLASSES], *METHODS, *FUNCTIONS])
def test_everything_public_says_what_it_is(value):
    doc = inspect.getdoc(value)
    assert doc
    assert doc.splitlines()[0].endswith(".") or "Error" in doc, doc.splitlines()[0]


@by_name([*FUNCTIONS, *MAKERS])
def test_a_function_or_constructor_describes_every_parameter_in_order(value):
    value = value if inspect.isfunction(value) else getattr(value, "render", value)
    assert described(inspect.getdoc(value), "Parameters") == parameters(value)


@pytest.mark.parametrize("name", [n for n in CLASSES if dataclasses.is_dataclass(found(n))])
def test_a_class_describes_every_field_in_order(name):
    fields = dataclasses.fields(found(name))
    told = described(inspect.getdoc(found(name)), "Attributes")
    if all("meaning" in field.metadata for field in fields):
        told += [field.name for field in fields if field.metadata["meaning"].about]
    assert sorted(told) == sorted(field.name for field in fields)


@by_name([p for p in METHODS if inspect.isfunction(p[1]) and p not in MAKERS])
def test_a_method_describes_or_names_every_parameter(value):
    doc = inspect.getdoc(value)
    unit = re.compile(r"_(mm|mm2|deg|per_mm)$")
    silent = [k for k in parameters(value) if not re.search(rf"\b{unit.sub('', k)}s?\b", doc)]
    assert silent == []


# -- errors ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def modules():
    found = [m.name for m in pkgutil.walk_packages(sk.__path__, "skinshade.")]
    return [importlib.import_module(name) for name in found if not name.endswith("__main__")]


def drawn(kind):
    lines = [kind.__name__]
    children = kind.__subclasses__()
    for child in children:
        last = child is children[-1]
        first, *rest = drawn(child)
        lines += [("└── " if last else "├── ") + first]
        lines += [("    " if last else "│   ") + line for line in rest]
    return lines


def test_every_error_has_its_place_in_the_drawn_tree(modules):
    drawing = re.findall(r"^ {4}[ │├└─]*\w+Error\b", errors.__doc__, re.MULTILINE)
    assert drawn(errors.SkinshadeError) == [line[4:] for line in drawing]


def test_no_module_has_an_error_of_its_own(modules):
    everything = [value for module in modules for value in vars(module).values()]
    kinds = [v for v in everything if inspect.isclass(v) and issubclass(v, Exception)]
    ours = [kind for kind in kinds if kind.__module__.startswith("skinshade.")]
    assert {kind.__module__ for kind in ours} == {"skinshade._core.errors"}
    assert {kind.__name__ for kind in ours} == set(errors.__all__)
