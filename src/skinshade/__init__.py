"""skinshade: film-like skin for any renderer.

Names are imported when first asked for, so that ``import skinshade`` costs next to nothing.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._core.version import __version__

if TYPE_CHECKING:
    from . import gpu
    from ._core.errors import InputError, SkinshadeError
    from .lut import Lut, build_curvature_lut, build_shadow_lut, build_transfer_lut
    from .mesh import (
        Mesh,
        diffuse_on_mesh,
        load_mesh,
        mesh_curvature,
        mesh_curvature_tensor,
        mesh_diffused_normals,
        mesh_uv_scale,
        vertex_attributes,
    )
    from .params import SkinParams
    from .profile import Profile, presets
    from .render import RenderSettings, render
    from .scene import (
        Camera,
        DirectionalLight,
        Environment,
        Material,
        Scene,
        SpotLight,
        load_scene,
    )
    from .scene.heads import builtin_head, head_scene
    from .sdk import export_shaders
    from .shading.skin import Skin

__all__ = [
    "Camera",
    "DirectionalLight",
    "Environment",
    "InputError",
    "Lut",
    "Material",
    "Mesh",
    "Profile",
    "RenderSettings",
    "Scene",
    "Skin",
    "SkinParams",
    "SkinshadeError",
    "SpotLight",
    "__version__",
    "build_curvature_lut",
    "build_shadow_lut",
    "build_transfer_lut",
    "builtin_head",
    "diffuse_on_mesh",
    "export_shaders",
    "gpu",
    "head_scene",
    "load_mesh",
    "load_scene",
    "mesh_curvature",
    "mesh_curvature_tensor",
    "mesh_diffused_normals",
    "mesh_uv_scale",
    "presets",
    "render",
    "vertex_attributes",
]

_HOMES = {
    "._core.errors": ("InputError", "SkinshadeError"),
    ".lut": ("Lut", "build_curvature_lut", "build_shadow_lut", "build_transfer_lut"),
    ".mesh": (
        "Mesh",
        "diffuse_on_mesh",
        "load_mesh",
        "mesh_curvature",
        "mesh_curvature_tensor",
        "mesh_diffused_normals",
        "mesh_uv_scale",
        "vertex_attributes",
    ),
    ".params": ("SkinParams",),
    ".profile": ("Profile", "presets"),
    ".render": ("RenderSettings",),
    ".scene": (
        "Camera",
        "DirectionalLight",
        "Environment",
        "Material",
        "Scene",
        "SpotLight",
        "load_scene",
    ),
    ".scene.heads": ("builtin_head", "head_scene"),
    ".sdk": ("export_shaders",),
    ".shading.skin": ("Skin",),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module 'skinshade' has no attribute {name!r}")
    if name in ("gpu", "render"):  # the packages themselves; ``render`` is called
        return import_module(f".{name}", __name__)
    value = getattr(import_module(_HOME_OF[name], __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
