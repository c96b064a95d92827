"""Film-like skin for any renderer.

Public names are imported on first use, which keeps ``import skinshade`` below 0.1 s.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._core.lazy import names_on_demand
from ._core.version import __version__

if TYPE_CHECKING:
    from . import gpu
    from ._core.errors import InputError, SkinshadeError
    from ._core.limits import Limits, limits, use_limits
    from .baking import BakeSettings, bake
    from .heads import Head, builtin_head, head_scene, load_head
    from .lut import Lut, build_shadow_lut, build_transfer_lut
    from .mesh import (
        AmbientTransfer,
        Mesh,
        diffuse_on_mesh,
        load_mesh,
        mesh_ambient_transfer,
        mesh_curvature,
        mesh_curvature_tensor,
        mesh_diffused_normals,
        mesh_thickness,
        mesh_uv_scale,
        vertex_attributes,
    )
    from .params import EyeParams, SkinParams
    from .profile import Profile, presets
    from .rendering import RenderedImage, RenderSettings, open_renderer, render, save_image
    from .scene import (
        Camera,
        DirectionalLight,
        Environment,
        Material,
        Part,
        Scene,
        SpotLight,
        load_scene,
        split_sun,
    )
    from .sdk import export_shaders
    from .shading.eye_tables import EyeLuts, build_eye_lut
    from .shading.skin import Skin
    from .shading.tables import build_curvature_lut

__all__ = [
    "AmbientTransfer",
    "BakeSettings",
    "Camera",
    "DirectionalLight",
    "Environment",
    "EyeLuts",
    "EyeParams",
    "Head",
    "InputError",
    "Limits",
    "Lut",
    "Material",
    "Mesh",
    "Part",
    "Profile",
    "RenderSettings",
    "RenderedImage",
    "Scene",
    "Skin",
    "SkinParams",
    "SkinshadeError",
    "SpotLight",
    "__version__",
    "bake",
    "build_curvature_lut",
    "build_eye_lut",
    "build_shadow_lut",
    "build_transfer_lut",
    "builtin_head",
    "diffuse_on_mesh",
    "export_shaders",
    "gpu",
    "head_scene",
    "limits",
    "load_head",
    "load_mesh",
    "load_scene",
    "mesh_ambient_transfer",
    "mesh_curvature",
    "mesh_curvature_tensor",
    "mesh_diffused_normals",
    "mesh_thickness",
    "mesh_uv_scale",
    "open_renderer",
    "presets",
    "render",
    "save_image",
    "split_sun",
    "use_limits",
    "vertex_attributes",
]

_MODULES = {
    "._core.errors": ("InputError", "SkinshadeError"),
    "._core.limits": ("Limits", "limits", "use_limits"),
    ".baking.asset": ("bake",),
    ".baking.settings": ("BakeSettings",),
    ".heads": ("Head", "builtin_head", "head_scene", "load_head"),
    ".lut": ("Lut", "build_shadow_lut", "build_transfer_lut"),
    ".mesh": (
        "Mesh",
        "diffuse_on_mesh",
        "load_mesh",
        "mesh_curvature",
        "mesh_curvature_tensor",
        "mesh_diffused_normals",
        "AmbientTransfer",
        "mesh_ambient_transfer",
        "mesh_thickness",
        "mesh_uv_scale",
        "vertex_attributes",
    ),
    ".params": ("EyeParams", "SkinParams"),
    ".profile": ("Profile", "presets"),
    ".rendering": ("RenderSettings", "RenderedImage", "open_renderer", "render", "save_image"),
    ".scene": (
        "Camera",
        "DirectionalLight",
        "Environment",
        "Material",
        "Part",
        "Scene",
        "SpotLight",
        "load_scene",
        "split_sun",
    ),
    ".sdk": ("export_shaders",),
    ".shading.eye_tables": ("EyeLuts", "build_eye_lut"),
    ".shading.skin": ("Skin",),
    ".shading.tables": ("build_curvature_lut",),
}
"""Public names by the modules that define them."""
_named = names_on_demand(__name__, _MODULES)


def __getattr__(name: str) -> Any:
    return import_module(".gpu", __name__) if name == "gpu" else _named(name)


def __dir__() -> list[str]:
    return sorted(__all__)
