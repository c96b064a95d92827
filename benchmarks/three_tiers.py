"""Compare the three tiers of geometry with diffusion over the mesh (MODEL §2, §7).

Run as ``python benchmarks/three_tiers.py``. It prints two Markdown tables, for smooth bodies without
shadows and for the scan with shadows, and writes the light and the errors on the scan to
docs/images/three_tiers.png.
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
from skinshade.lut import Lut
from skinshade.mesh import Mesh, diffuse_on_mesh, mesh_curvature, mesh_curvature_tensor
from skinshade.mesh.curvature import tensor_to_world
from skinshade.mesh.topology import corner_areas
from skinshade.params import SkinParams
from skinshade.profile import Profile
from skinshade.rendering.prepare.light_view import LightView
from skinshade.rendering.prepare.rasterizer import rasterize
from skinshade.rendering.prepare.shadow_filter import PercentageCloserFilter
from skinshade.rendering.prepare.shadow_map import rasterize_shadow_map
from skinshade.scene import Camera, DirectionalLight
from skinshade.scene.images import write_png
from skinshade.shading import classic, direct, shadow
from skinshade.shading.normals import add_mesh_diffusion
from skinshade.shading.skin import Skin
from skinshade.shading.tables import build_curvature_lut
from skinshade.shading.tonemap import srgb_from_linear

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SKINSHADE_DATA", ROOT.parent / "shared" / "data"))
MODELS = ("lambert", "scalar ring", "scalar sphere", "tensor", "diffused normals")
SCAN_LIGHT = (-0.75, 0.45, 0.6)
SHARP_FILTER_MM = 1.5
"""Width of the exact shadow's filter: the narrowest that the texels of a shadow map allow."""
ERROR_SCALE = 4.0
"""Factor of the errors in the error maps: no error is grey, ±.125 is white or black."""
TOLERANCE = 1e-4
"""Tolerance of diffusion over a mesh: equal to the last digit of the tables."""
LIGHT_COUNT = 8
"""Number of lights, spread evenly, so that no body is lit along its axes alone."""
COLUMNS = ("truth", "lambert", "classic (2014)", "scalar sphere", "tensor", "diffused normals")
"""Columns of the picture."""


@dataclass(frozen=True)
class Body:
    """A mesh, lengths in mm, and the geometry that the tiers use at its vertices."""

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
        """(V, 3 channels, 3) normals diffused by the profile."""
        return self.diffuse(self.normals).swapaxes(1, 2)

    def diffuse(self, light: np.ndarray) -> np.ndarray:
        """Return the exact result (V, ..., 3): light (V, ...) diffused over the surface."""
        return diffuse_on_mesh(self.positions, self.faces, light, self.profile, tolerance=TOLERANCE)

    def mean_square(self, difference: np.ndarray) -> float:
        """Return the mean square over area and channels of a difference (V, 3)."""
        area = corner_areas(self.positions, self.faces, len(self.positions))
        return float(np.average(np.square(difference).mean(axis=1), weights=area))

    def shade(self, light: np.ndarray, ring: Lut, sphere: Lut) -> dict[str, np.ndarray]:
        """Return the light (V, 3) of each of `MODELS`, without shadow."""
        normals = np.repeat(self.normals[:, None], 3, axis=1)
        lights = np.broadcast_to(light, self.normals.shape)
        transfer, gain = self.profile.kernel.transfer, np.ones(3)
        directional, total = direct.directional_curvature(self.tensor, self.normals, lights)
        with_mesh = add_mesh_diffusion(normals, self.diffused_normals, self.normals)
        relief = direct.relief_length(transfer, normals, self.diffused_normals, total)
        magnitude = np.abs(self.curvature)
        lambert = np.maximum(self.normals @ light, 0.0)
        return {
            "lambert": np.repeat(lambert[:, None], 3, axis=1),
            "scalar ring": direct.direct_scalar(ring, normals, lights, magnitude, gain),
            "scalar sphere": direct.direct_scalar(sphere, normals, lights, magnitude, gain),
            "tensor": direct.direct_tensor(
                ring, transfer, normals, lights, directional, total, gain
            ),
            "diffused normals": direct.direct_diffused_normals(
                ring, transfer, with_mesh, relief, lights, directional, gain
            ),
        }


def torus(major_mm: float, minor_mm: float, profile: Profile) -> Body:
    """Return a torus with exact normals and edges of about half a millimetre."""
    around = int(2.0 * np.pi * (major_mm + minor_mm) / 0.5)
    mesh = trimesh.creation.torus(major_mm, minor_mm, around, int(2.0 * np.pi * minor_mm / 0.4))
    p = np.array(mesh.vertices)
    centre = p * [1.0, 1.0, 0.0]
    centre *= major_mm / np.linalg.norm(centre, axis=1, keepdims=True)
    return Body(p, np.array(mesh.faces), (p - centre) / minor_mm, profile)


def ellipsoid(axes_mm: tuple[float, float, float], profile: Profile) -> Body:
    """Return an ellipsoid with exact normals."""
    mesh = trimesh.creation.icosphere(subdivisions=5)
    unit = np.array(mesh.vertices)
    n = unit / axes_mm
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    return Body(unit * axes_mm, np.array(mesh.faces), n, profile)


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
    """Return the curvature tables for a ring and for a sphere."""
    ring, sphere = (
        build_curvature_lut(
            profile, size=(512, 128), radius_mm=(0.5, 4000.0), kernel=kernel, energy_gain=False
        )
        for kernel in ("ring", "sphere")
    )
    return ring, sphere


def errors(body: Body, luts: tuple[Lut, Lut]) -> dict[str, float]:
    """Return the RMS error of each of `MODELS` over area, lights and channels."""
    squares = dict.fromkeys(MODELS, 0.0)
    lights = spread_directions(LIGHT_COUNT)
    truths = body.diffuse(np.maximum(body.normals @ lights.T, 0.0))
    for index, light in enumerate(lights):
        for name, value in body.shade(light, *luts).items():
            squares[name] += body.mean_square(value - truths[:, index]) / LIGHT_COUNT
    return {name: float(np.sqrt(square)) for name, square in squares.items()}


def scan(profile: Profile, cuts: int = 2) -> Body:
    """Return the scan with every edge halved `cuts` times.

    After two cuts the edges are about a millimetre long, short enough for the 3 mm of red diffusion.
    """
    mesh = sk.load_mesh(DATA / "lps" / "LeePerrySmith.glb", unit_mm=50.35)
    points, faces, normals = mesh.positions_mm, mesh.faces, mesh.normals
    for _ in range(cuts):
        points, faces, attributes = trimesh.remesh.subdivide(
            points, faces, vertex_attributes={"normals": normals}
        )
        normals = attributes["normals"]
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    return Body(np.asarray(points), np.asarray(faces), normals, profile)


def scan_light(body: Body, light: np.ndarray, luts: tuple[Lut, Lut]) -> dict[str, np.ndarray]:
    """Return the light (V, 3) on the scan with shadows: exact, of `MODELS`, and of 2014.

    The exact result, ``truth``, diffuses light with a sharp shadow; the models only read the wide filter.
    """
    skin = Skin.of(body.profile, SkinParams(), luts=("shadow", "classic", "classic_shadow"))
    mesh = Mesh.checked(body.positions, body.faces, unit_mm=1.0, normals=body.normals)
    shadow_map = rasterize_shadow_map(LightView.of(DirectionalLight(light, 1.0), mesh), mesh)
    lights = np.broadcast_to(light, body.normals.shape)
    cosine = body.normals @ light

    def lit(width_mm: float) -> np.ndarray:
        wide_filter = PercentageCloserFilter.build(shadow_map, width_mm)
        return wide_filter.lit(body.positions, body.normals, lights, body.curvature)

    truth = body.diffuse(np.maximum(cosine, 0.0) * lit(SHARP_FILTER_MM))
    width = skin.params.shadow_filter_width_mm
    wide = lit(width)
    sharpened = shadow.sharpened_shadow(wide, skin.params.shadow_sharpening)[:, None]
    diffused = shadow.diffused_shadow(skin.lut("shadow"), wide, cosine, width)
    classic_light = classic.direct(
        skin.lut("classic"), body.normals, body.normals, lights, body.curvature
    )
    classic_light *= shadow.diffused_shadow(skin.lut("classic_shadow"), wide, cosine, width)
    models = {
        name: value * (sharpened if name == "lambert" else diffused)
        for name, value in body.shade(light, *luts).items()
    }
    return {"truth": truth, "classic (2014)": classic_light, **models}


def draw(body: Body, light: dict[str, np.ndarray]) -> None:
    """Write docs/images/three_tiers.png: the light of `COLUMNS`, and below it the error."""
    size = (300, 380)
    low, high = body.positions.min(axis=0), body.positions.max(axis=0)
    centre = 0.5 * (low + high) + [0.0, 0.14, 0.0] * (high - low)
    camera = Camera.orbit(centre, 1300.0, yaw_deg=-20.0, vertical_fov_deg=12.0)
    matrix = camera.view_projection(size[0] / size[1])
    clip = body.positions @ matrix[:, :3].T + matrix[:, 3]
    fragments = rasterize(clip, body.faces, size, (0.5, 0.5))
    corners = body.faces[fragments.face]

    def picture(values: np.ndarray) -> np.ndarray:
        pixels = np.full((size[0] * size[1], 3), 0.02)
        pixels[fragments.pixel] = np.einsum("nc,ncd->nd", fragments.barycentric, values[corners])
        return pixels.reshape(size[1], size[0], 3)

    pictures = [srgb_from_linear(picture(light[name])) for name in COLUMNS]
    differences = [picture(0.5 + ERROR_SCALE * (light[name] - light["truth"])) for name in COLUMNS]
    error_maps = [np.clip(difference, 0.0, 1.0) for difference in differences]
    rows = [side_by_side(pictures, list(COLUMNS)), side_by_side(error_maps, [""] * len(COLUMNS))]
    write_png(ROOT / "docs" / "images" / "three_tiers.png", np.concatenate(rows))


def main() -> None:
    """Print the tables and draw the picture."""
    profile = Profile.preset("skin-deon2007")
    luts = tables(profile)
    print("| body | " + " | ".join(MODELS) + " |\n|---|" + "---|" * len(MODELS))
    for name, build in BODIES.items():
        rms = errors(build(profile), luts)
        cells = " | ".join(f"{rms[model]:.4f}" for model in MODELS)
        print(f"| {name} | {cells} |", flush=True)
    body = scan(profile)
    direction = np.array(SCAN_LIGHT) / np.linalg.norm(SCAN_LIGHT)
    light = scan_light(body, direction, luts)
    print("\n| scan with shadows | RMS |\n|---|---|")
    for name, value in light.items():
        if name != "truth":
            print(f"| {name} | {np.sqrt(body.mean_square(value - light['truth'])):.4f} |")
    draw(body, light)


if __name__ == "__main__":
    main()
