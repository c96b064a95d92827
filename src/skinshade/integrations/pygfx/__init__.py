"""A skin material for pygfx meshes.

::

    material = SkinMaterial(map=albedo, normal_map=normals)
    head = pygfx.Mesh(skin_geometry(mesh), material, cast_shadow=True, receive_shadow=True)
    scene.add(head, skin_light(skinshade.DirectionalLight.from_angles(-38, 26, 1), mesh))

The world is in mm. pygfx provides lights and shadow maps; skinshade computes all terms of the lighting
model. Deep scatter needs a shadow map: set ``cast_shadow`` of the light and of the mesh, and
``receive_shadow`` of the mesh.
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
        f"pygfx {pygfx.__version__} differs from pygfx 0.17, which skinshade's material needs"
        f' ({error}): pip install "skinshade[pygfx]"'
    ) from error

__all__ = ["SkinMaterial", "skin_geometry", "skin_light"]
