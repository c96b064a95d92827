"""Pictures that ``skinshade render`` draws."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from .._core.errors import ArgumentError
from .._core.limits import Limits, limit_range
from ..params.choices import AmbientForm
from ..rendering import Backend, Renderer, open_renderer, save_image
from ..rendering.api import prepare_backend
from ..rendering.images import check_image_path
from ..rendering.settings import RenderSettings, check_size
from ..rendering.tone import display_values
from ..scene import Camera, Scene
from .compare import parse_variant, side_by_side
from .picture import ShadingOptions
from .progress import terminal_progress
from .scene import build_scene
from .scene_options import LightOptions, MaterialOptions, ModelOptions
from .terminal import echo, printable
from .values import parse_size

__all__ = ["Request", "draw_pictures"]


@dataclass(frozen=True)
class Request:
    """Options of ``skinshade render`` besides those of the scene and of the shading.

    Attributes
    ----------
    output
        File of the picture.
    size
        WIDTHxHEIGHT in pixels.
    samples
        Samples per pixel.
    backend, adapter
        Device that draws, and part of the GPU's name.
    ambient
        Form of the ambient light at the vertices.
    compare
        Pictures side by side, separated by commas; None for one picture.
    turntable
        Number of frames of a turn; 0 for one picture.
    """

    output: Path
    size: str
    samples: int
    backend: Backend
    adapter: str | None
    ambient: AmbientForm
    compare: str | None
    turntable: int


def draw_pictures(
    request: Request,
    most: Limits,
    shading: ShadingOptions,
    model: ModelOptions,
    material: MaterialOptions,
    light: LightOptions,
) -> Renderer:
    """Draw the pictures of a request, print the names of their files, and return the renderer.

    Raises
    ------
    SkinshadeError
        If a value or a file cannot be used, or the backend is not available.
    """
    settings = shading.settings()
    output, samples, compare = request.output, request.samples, request.compare
    extent = parse_size(request.size)
    check_size(extent, samples)
    check_image_path(output, (".png",) if compare else (".png", ".exr"))
    if not 0 <= request.turntable <= most.frames:
        allowed = limit_range("frames", 0, request.turntable)
        raise ArgumentError(f"--turntable is {request.turntable}; it must be {allowed}")
    variants = [parse_variant(text, settings) for text in compare.split(",")] if compare else []
    prepare_backend(request.backend, request.adapter)
    scene = build_scene(model, material, light)
    _report_parts(scene)
    with terminal_progress() as progress:
        renderer = open_renderer(
            scene,
            request.backend,
            progress=progress,
            adapter=request.adapter,
            ambient=request.ambient,
        )
        if variants:
            _draw_compared(renderer, scene, extent, samples, variants, output)
        elif request.turntable:
            _draw_turntable(renderer, scene, extent, samples, settings, request.turntable, output)
        else:
            _draw(renderer, scene.camera, extent, samples, settings, output)
            echo(f"{output}: {extent[0]}×{extent[1]}, drawn on {renderer.device_name}")
    return renderer


def _report_parts(scene: Scene) -> None:
    """Print which materials are drawn as skin, if the model has several."""
    if not scene.parts:
        return
    skin = [scene.material.name, *(part.name for part in scene.parts if part.is_skin)]
    others = [part.name for part in scene.parts if not part.is_skin]
    echo(f"materials with scattering: {printable(', '.join(skin))}")
    echo(f"materials without scattering: {printable(', '.join(others) or 'none')}")


def _draw(
    renderer: Renderer,
    camera: Camera,
    size: tuple[int, int],
    samples: int,
    settings: RenderSettings,
    output: Path,
) -> None:
    if output.suffix.lower() == ".exr":
        save_image(output, renderer.draw(camera, size, samples, settings))
    else:
        save_image(output, renderer.draw_display(camera, size, samples, settings))


def _draw_compared(
    renderer: Renderer,
    scene: Scene,
    size: tuple[int, int],
    samples: int,
    variants: list[tuple[str, RenderSettings]],
    output: Path,
) -> None:
    settings = [variant for _, variant in variants]
    images = renderer.draw_many(scene.camera, size, samples, settings)
    pictures = [
        display_values(image, scene, variant)
        for image, variant in zip(images, settings, strict=True)
    ]
    save_image(output, side_by_side(pictures, [label for label, _ in variants]))
    echo(
        f"{output}: {len(pictures)} pictures of {size[0]}×{size[1]}, drawn on {renderer.device_name}"
    )


def _draw_turntable(
    renderer: Renderer,
    scene: Scene,
    size: tuple[int, int],
    samples: int,
    settings: RenderSettings,
    frames: int,
    output: Path,
) -> None:
    digits = len(str(frames - 1))
    for frame in range(frames):
        camera = scene.camera.orbited(360.0 * frame / frames)
        path = output.with_stem(f"{output.stem}-{frame:0{digits}d}")
        _draw(renderer, camera, size, samples, settings, path)
    echo(
        f"{output.with_stem(output.stem + '-*')}: {frames} frames, drawn on {renderer.device_name}"
    )
