"""Three tiers of geometry beside diffusion over the mesh itself (MODEL §2, §7).

Run as ``python benchmarks/three_tiers.py``; prints two Markdown tables, smooth bodies in four lights and the
scan with its shadows, and draws where each errs on the scan, docs/images/three_tiers.png.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import trimesh

import skinshade as sk
from skinshade.cli.compare import side_by_side
from skinshade.lut import Lut, build_curvature_lut
from skinshade.mesh import Mesh, diffuse_on_mesh, mesh_curvature, mesh_curvature_tensor
from skinshade.mesh.curvature import tensor_to_world
from skinshade.mesh.topology import corner_areas
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.render.cpu.raster import rasterize
from skinshade.render.cpu.shadow_map import render_shadow_map
from skinshade.scene import Camera, DirectionalLight
from skinshade.scene.images import write_png
from skinshade.shading import classic, direct, shadow
from skinshade.shading.normals import add_mesh_diffusion
from skinshade.shading.skin import Skin
from skinshade.shading.tonemap import srgb_from_linear

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SKINSHADE_DATA", ROOT.parent / "shared" / "data"))
MODELS = ("lambert", "scalar ring", "scalar sphere", "tensor", "diffused normals")
SCAN_LIGHT = (-0.75, 0.45, 0.6)
SHARP_FILTER_MM = 1.5
"""As narrow as the shadow map's texels allow."""
ERROR_SCALE = 4.0
"""Of the error maps: grey is right, ±.125 is white or black."""
TOLERANCE = 1e-4
"""Of diffusion over a mesh: a tenth of the least difference that the tables print."""
LIGHT_COUNT = 8
"""Spread evenly, so that no body is lit along its axes alone."""


@dataclass(frozen=True)
class Body:
    """A mesh, and what shading knows of each of its vertices, lengths in mm."""

    positions: np.ndarray
    faces: np.ndarray
    normals: np.ndarray
    profile: Profile

    @cached_property
    def curvature(self) -> np.ndarray:
        """(V,) mean curvature."""
        return mesh_curvature(self.positions, self.faces, self.normals)

    @cached_property
    def tensor(self) -> np.ndarray:
        """(V, 6) shape operator in world axes."""
        tensor = mesh_curvature_tensor(self.positions, self.faces, self.normals)
        return tensor_to_world(tensor, self.normals)

    @cached_property
    def diffused_normals(self) -> np.ndarray:
        """(V, 3 channels, 3)."""
        return self.diffused(self.normals).swapaxes(1, 2)

    def diffused(self, light: np.ndarray) -> np.ndarray:
        """Return the truth (V, ..., 3): light (V, ...) diffused over the surface."""
        return diffuse_on_mesh(self.positions, self.faces, light, self.profile, tolerance=TOLERANCE)

    def mean_square(self, difference: np.ndarray) -> float:
        """Return the mean over area and channels of the square of (V, 3)."""
        area = corner_areas(self.positions, self.faces, len(self.positions))
        return float(np.average(np.square(difference).mean(axis=1), weights=area))

    def shaded(self, light: np.ndarray, ring: Lut, sphere: Lut) -> dict[str, np.ndarray]:
        """Return (V, 3) of each of `MODELS`, without shadow."""
        seen = np.repeat(self.normals[:, None], 3, axis=1)
        lights = np.broadcast_to(light, self.normals.shape)
        transfer, gain = self.profile.kernel.transfer, np.ones(3)
        bends = direct.directional_curvature(self.tensor, self.normals, lights)
        both = add_mesh_diffusion(seen, self.diffused_normals, self.normals)
        relief = direct.unexplained_length(transfer, seen, self.diffused_normals, bends[1])
        size = np.abs(self.curvature)
        lambert = np.maximum(self.normals @ light, 0.0)
        return {
            "lambert": np.repeat(lambert[:, None], 3, axis=1),
            "scalar ring": direct.direct_scalar(ring, seen, lights, size, gain),
            "scalar sphere": direct.direct_scalar(sphere, seen, lights, size, gain),
            "tensor": direct.direct_tensor(ring, transfer, seen, lights, *bends, gain),
            "diffused normals": direct.direct_diffused_normals(
                ring, transfer, both, relief, lights, bends[0], gain
            ),
        }


def torus(major_mm: float, minor_mm: float, profile: Profile) -> Body:
    """Return a torus with its own normals, edges of about half a millimetre."""
    around = int(2.0 * np.pi * (major_mm + minor_mm) / 0.5)
    made = trimesh.creation.torus(major_mm, minor_mm, around, int(2.0 * np.pi * minor_mm / 0.4))
    p = np.array(made.vertices)
    centre = p * [1.0, 1.0, 0.0]
    centre *= major_mm / np.linalg.norm(centre, axis=1, keepdims=True)
    return Body(p, np.array(made.faces), (p - centre) / minor_mm, profile)


def ellipsoid(axes_mm: tuple[float, float, float], profile: Profile) -> Body:
    """Return an ellipsoid with its own normals."""
    ball = trimesh.creation.icosphere(subdivisions=5)
    unit = np.array(ball.vertices)
    n = unit / axes_mm
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    return Body(unit * axes_mm, np.array(ball.faces), n, profile)


BODIES: dict[str, Callable[[Profile], Body]] = {
    "torus R=12 r=4": lambda profile: torus(12.0, 4.0, profile),
    "torus R=30 r=8": lambda profile: torus(30.0, 8.0, profile),
    "ellipsoid 15, 10, 5": lambda profile: ellipsoid((15.0, 10.0, 5.0), profile),
    "ellipsoid 20, 6, 6": lambda profile: ellipsoid((20.0, 6.0, 6.0), profile),
}


def spread_directions(count: int) -> np.ndarray:
    """Return unit vectors (count, 3) on a golden spiral over the sphere."""
    index = np.arange(count) + 0.5
    height, turn = 1.0 - 2.0 * index / count, np.pi * (1.0 + np.sqrt(5.0)) * index
    across = np.sqrt(1.0 - height**2)
    return np.stack([across * np.cos(turn), height, across * np.sin(turn)], axis=1)


def tables(profile: Profile) -> tuple[Lut, Lut]:
    """Return the tables of ring and sphere."""
    made = [
        build_curvature_lut(
            profile, size=(512, 128), radius_mm=(0.5, 4000.0), kernel=kernel, energy_gain=False
        )
        for kernel in ("ring", "sphere")
    ]
    return made[0], made[1]


def errors(body: Body, made: tuple[Lut, Lut]) -> dict[str, float]:
    """Return the RMS difference of each of `MODELS` from the truth over area, lights and channels."""
    squares = dict.fromkeys(MODELS, 0.0)
    lights = spread_directions(LIGHT_COUNT)
    truths = body.diffused(np.maximum(body.normals @ lights.T, 0.0))
    for index, light in enumerate(lights):
        for name, value in body.shaded(light, *made).items():
            squares[name] += body.mean_square(value - truths[:, index]) / LIGHT_COUNT
    return {name: float(np.sqrt(square)) for name, square in squares.items()}


def scan(profile: Profile, cuts: int = 2) -> Body:
    """Return the scan, each edge halved twice: edges of about a millimetre carry red's 3 mm."""
    mesh = sk.load_mesh(DATA / "lps" / "LeePerrySmith.glb", unit_mm=50.35)
    points, faces, normals = mesh.positions_mm, mesh.faces, mesh.normals
    for _ in range(cuts):
        points, faces, found = trimesh.remesh.subdivide(
            points, faces, vertex_attributes={"normals": normals}
        )
        normals = found["normals"]
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    return Body(np.asarray(points), np.asarray(faces), normals, profile)


def scan_light(body: Body, light: np.ndarray, made: tuple[Lut, Lut]) -> dict[str, np.ndarray]:
    """Return (V, 3) of the truth, of `MODELS` and of 2014 on the scan, shadows included.

    The truth diffuses light whose shadow is as sharp as the map; the others know only the wide filter.
    """
    skin = Skin.of(body.profile, SkinParams())
    mesh = Mesh.checked(body.positions, body.faces, unit_mm=1.0, normals=body.normals)
    shadows = render_shadow_map(DirectionalLight(light, 1.0), mesh)
    lights = np.broadcast_to(light, body.normals.shape)
    at = (body.positions, body.normals, lights, body.curvature)
    cosine = body.normals @ light
    sharp = shadows.shadow_filter(*at, SHARP_FILTER_MM)
    truth = body.diffused(np.maximum(cosine, 0.0) * sharp)
    width = skin.params.shadow_filter_width_mm
    wide = shadows.shadow_filter(*at, width)
    narrow = shadow.sharpened_shadow(wide, skin.params.shadow_sharpening)[:, None]
    edge = shadow.diffused_shadow(skin.shadow, wide, cosine, width)
    old = classic.direct(
        skin.classic_curvature, body.normals, body.normals, lights, body.curvature
    ) * shadow.diffused_shadow(skin.classic_shadow, wide, cosine, width)
    models = body.shaded(light, *made)
    lit = {name: value * (narrow if name == "lambert" else edge) for name, value in models.items()}
    return {"truth": truth, "classic (2014)": old, **lit}


def draw(body: Body, found: dict[str, np.ndarray]) -> None:
    """Write docs/images/three_tiers.png: the light, and below it how far it is from the truth."""
    size = (300, 380)
    low, high = body.positions.min(axis=0), body.positions.max(axis=0)
    centre = 0.5 * (low + high) + [0.0, 0.14, 0.0] * (high - low)
    camera = Camera.orbit(centre, 1300.0, yaw_deg=-20.0, vertical_fov_deg=12.0)
    matrix = camera.view_projection(size[0] / size[1])
    clip = body.positions @ matrix[:, :3].T + matrix[:, 3]
    pieces = rasterize(clip, body.faces, size, (0.5, 0.5))
    corners = body.faces[pieces.face]

    def pictured(values: np.ndarray) -> np.ndarray:
        picture = np.full((size[0] * size[1], 3), 0.02)
        picture[pieces.pixel] = np.einsum("nc,ncd->nd", pieces.barycentric, values[corners])
        return picture.reshape(size[1], size[0], 3)

    shown = ["truth", "lambert", "classic (2014)", "scalar sphere", "tensor", "diffused normals"]
    lights = [srgb_from_linear(pictured(found[name])) for name in shown]
    maps = [pictured(0.5 + ERROR_SCALE * (found[name] - found["truth"])) for name in shown]
    rows = [
        side_by_side(lights, shown),
        side_by_side([np.clip(each, 0.0, 1.0) for each in maps], [""] * len(shown)),
    ]
    write_png(ROOT / "docs" / "images" / "three_tiers.png", np.concatenate(rows))


def main() -> None:
    """Print the tables and draw the picture."""
    profile = Profile.preset("skin-deon2007")
    made = tables(profile)
    print("| body | " + " | ".join(MODELS) + " |\n|---|" + "---|" * len(MODELS))
    for name, build in BODIES.items():
        found = errors(build(profile), made)
        print(f"| {name} | " + " | ".join(f"{found[model]:.4f}" for model in MODELS) + " |")
    body = scan(profile)
    light = np.array(SCAN_LIGHT) / np.linalg.norm(SCAN_LIGHT)
    seen = scan_light(body, light, made)
    print("\n| scan with shadows | RMS |\n|---|---|")
    for name, value in seen.items():
        if name != "truth":
            print(f"| {name} | {np.sqrt(body.mean_square(value - seen['truth'])):.4f} |")
    draw(body, seen)


if __name__ == "__main__":
    main()
