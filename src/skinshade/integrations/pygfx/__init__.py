"""Skin as one more of pygfx's mesh materials.

::

    material = SkinMaterial(map=albedo, normal_map=normals)
    head = pygfx.Mesh(skin_geometry(mesh), material, cast_shadow=True, receive_shadow=True)
    scene.add(head, skin_light(skinshade.DirectionalLight.from_angles(-38, 26, 1), mesh))

The world is in mm. Lights and shadow maps are pygfx's own, every term of the lighting model skinshade's.
Light that comes through the body needs a shadow map: a light and a mesh that cast, a mesh that receives.
"""

from ..._core.errors import BackendError

try:
    import pygfx
except ImportError as error:
    raise type(error)(
        f'skinshade.integrations.pygfx needs pygfx ({error}): pip install "skinshade[pygfx]"'
    ) from error
try:
    from .geometry import skin_geometry
    from .lights import skin_light
    from .material import SkinMaterial
except ImportError as error:
    raise BackendError(
        f"pygfx {pygfx.__version__} is built otherwise than 0.17, which skinshade's material is"
        f' written for ({error}): pip install "skinshade[pygfx]"'
    ) from error

__all__ = ["SkinMaterial", "skin_geometry", "skin_light"]
