"""``skinshade render``: pictures of a head."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .._core.choice import Choice
from .._core.errors import ArgumentError
from .._core.limits import limit_range
from ..params.choices import AmbientForm
from ..rendering import Backend, Renderer, open_renderer, save_image
from ..rendering.api import prepare_backend
from ..rendering.images import check_image_path
from ..rendering.settings import RenderSettings, check_size
from ..rendering.tone import display_values
from ..scene import Camera, Scene
from .compare import parse_variant, side_by_side
from .limits import LimitOptions
from .options import expand_options
from .picture import ShadingOptions
from .progress import terminal_progress
from .scene import LightOptions, MaterialOptions, ModelOptions, build_scene
from .terminal import echo, printable
from .timings import timing_report
from .values import check_output, parse_size

__all__ = ["render_command"]


class TimingForm(Choice):
    """Form of the report of pass times."""

    TABLE = "table"
    JSON = "json"


@expand_options
def render_command(
    *,
    model: ModelOptions,
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", callback=check_output, help="PNG, or EXR with linear light."
        ),
    ] = Path("skin.png"),
    size: Annotated[
        str, typer.Option(help="WIDTHxHEIGHT in pixels; with --compare, of every picture.")
    ] = "1280x720",
    samples: Annotated[int, typer.Option(help="Samples per pixel, 1..256.")] = 4,
    backend: Annotated[
        Backend,
        typer.Option(
            help="gpu also accepts software drivers; auto is a hardware GPU, else the CPU."
        ),
    ] = Backend.AUTO,
    adapter: Annotated[
        str | None, typer.Option(help="Part of the GPU's name; see skinshade doctor.")
    ] = None,
    ambient: Annotated[
        AmbientForm,
        typer.Option(help="Ambient light at the vertices: of the sky, or of its harmonics."),
    ] = AmbientForm.STATIC,
    compare: Annotated[
        str | None,
        typer.Option(help="Pictures side by side, such as lambert,classic,transfer,transfer+deep."),
    ] = None,
    turntable: Annotated[
        int, typer.Option(help="Number of frames of a turn around the head; every frame is a file.")
    ] = 0,
    timings: Annotated[
        TimingForm | None, typer.Option(help="Report the time of every pass on the GPU.")
    ] = None,
    shading: ShadingOptions,
    light: LightOptions,
    material: MaterialOptions,
    limits: LimitOptions,
) -> None:
    """Draw a head, as PNG or EXR."""
    with limits.in_force() as most:
        settings = shading.settings()
        extent = parse_size(size)
        check_size(extent, samples)
        check_image_path(output, (".png",) if compare else (".png", ".exr"))
        if not 0 <= turntable <= most.frames:
            allowed = limit_range("frames", 0, turntable)
            raise ArgumentError(f"--turntable is {turntable}; it must be {allowed}")
        variants = [parse_variant(text, settings) for text in compare.split(",")] if compare else []
        prepare_backend(backend, adapter)
        scene = build_scene(model, material, light)
        _report_parts(scene)
        with terminal_progress() as progress:
            renderer = open_renderer(
                scene, backend, progress=progress, adapter=adapter, ambient=ambient
            )
            if variants:
                _draw_compared(renderer, scene, extent, samples, variants, output)
            elif turntable:
                _draw_turntable(renderer, scene, extent, samples, settings, turntable, output)
            else:
                _draw(renderer, scene.camera, extent, samples, settings, output)
                echo(f"{output}: {extent[0]}×{extent[1]}, drawn on {renderer.device_name}")
        if timings is not None:
            echo(timing_report(renderer, as_json=timings == TimingForm.JSON))


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
