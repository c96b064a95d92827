"""``skinshade render``: a picture of a head."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import typer

from .._core.errors import ArgumentError, OutputError
from .._core.units import parse_unit_mm
from ..profile import Profile
from ..render import DEBUG_VIEWS, RenderSettings
from ..render.renderer import Renderer, display, open_renderer
from ..scene import Camera, DirectionalLight, Environment, Scene, load_scene
from ..scene.heads import builtin_head, head_scene
from ..scene.heads import model as load_model
from ..scene.images import write_exr, write_png
from .compare import parse_variant, side_by_side
from .parse import numbers, size
from .progress import terminal_progress
from .timings import timing_report

__all__ = ["render_command"]


def render_command(
    model: Path = typer.Argument(
        None, help="GLB, glTF, OBJ, PLY, STL, or a scene in JSON; the built-in head without it."
    ),
    output: Path = typer.Option(
        Path("skin.png"), "--output", "-o", help="PNG, or EXR with linear light."
    ),
    picture_size: str = typer.Option(
        "1280x720", "--size", help="WIDTHxHEIGHT; of each picture with --compare."
    ),
    samples: int = typer.Option(4, help="Samples a pixel."),
    seed: int = typer.Option(0, help="Moves the samples; the same seed gives the same picture."),
    backend: str = typer.Option(
        "auto", help="cpu, gpu (be it in software), or auto: a hardware GPU, else the CPU."
    ),
    adapter: str = typer.Option(None, help="Part of the GPU's name; see skinshade doctor."),
    shading: str = typer.Option(
        "transfer", help="transfer, classic (2014) or lambert (no scattering)."
    ),
    no_sss: bool = typer.Option(False, "--no-sss", help="The same as --shading lambert."),
    tier: str = typer.Option(
        "diffused-normals", help="Geometry for transfer: scalar, tensor or diffused-normals."
    ),
    deep_scatter_taps: int = typer.Option(
        8, help="Light through thin parts: 0 (off), 8 or 32 taps."
    ),
    normal_fetches: int = typer.Option(
        3, help="Of the normal map: 3 (sharp and two blurs) or 2 (sharp and one)."
    ),
    shadow_filter: str = typer.Option(
        "percentage-closer", help="percentage-closer, or variance: both of one width in mm."
    ),
    antialiasing: str = typer.Option(
        "supersampling",
        help="supersampling, or multisampling: a GPU shades once a pixel and finds edges from 4 samples.",
    ),
    debug_view: str = typer.Option(None, help=f"One of {', '.join(DEBUG_VIEWS)}."),
    compare: str = typer.Option(
        None, help="Such as lambert,classic,transfer,transfer+deep: one labelled picture."
    ),
    turntable: int = typer.Option(
        0, help="Write this many frames of a turn, numbered, instead of one."
    ),
    unit_mm: str = typer.Option(
        None, help="Length of the model's unit in mm, or mm, cm, m, in, ft."
    ),
    albedo: Path = typer.Option(None, help="Colour map."),
    normal_map: Path = typer.Option(None, help="Tangent-space normal map, +y up."),
    flip_v: bool = typer.Option(False, "--flip-v", help="The model's v counts from below."),
    view: str = typer.Option(
        None, help="Camera: yaw,pitch in degrees around the head; 0,0 is in front."
    ),
    light: list[str] = typer.Option(
        None,
        help="yaw,pitch,intensity of a lamp; may be given again. For a scene in JSON, the name of its light.",
    ),
    env: Path = typer.Option(None, help="Equirectangular HDR that lights the head."),
    env_scale: float = typer.Option(1.0, help="Multiplies the environment."),
    show_env: bool = typer.Option(
        False, "--show-env", help="Show the environment behind the head."
    ),
    background: str = typer.Option(None, help="Linear r,g,b behind the head."),
    profile: str = typer.Option(None, help="Diffusion profile; see skinshade profile."),
    scatter_scale: float = typer.Option(None, help="Multiplies every length of the profile."),
    gloss: float = typer.Option(None, help="Of the specular lobe, 0..1."),
    normal_strength: float = typer.Option(
        None, help="Multiplies the slopes of the normal map, 0..2."
    ),
    deep_scatter_strength: float = typer.Option(None, help="Multiplies light through thin parts."),
    exposure: float = typer.Option(None, help="Multiplies light before tone mapping."),
    tone: str = typer.Option(None, help="filmic or srgb."),
    timings: str = typer.Option(None, help="table or json: time of every pass on the GPU."),
) -> None:
    """Draw a head, as PNG or EXR."""
    settings = RenderSettings(
        shading="lambert" if no_sss else shading,  # type: ignore[arg-type]  # checked by the class
        tier=tier,  # type: ignore[arg-type]  # checked by the class
        deep_scatter_taps=deep_scatter_taps,
        normal_fetches=normal_fetches,
        shadow_filter=shadow_filter,  # type: ignore[arg-type]  # checked by the class
        antialiasing=antialiasing,  # type: ignore[arg-type]  # checked by the class
        debug_view=debug_view,
        seed=seed,
    )
    extent = size(picture_size)
    _check(extent, samples, turntable, output, compare)
    if timings not in (None, "table", "json"):
        raise ArgumentError(f"--timings is {timings!r}; it must be table or json")
    variants = [parse_variant(word, settings) for word in compare.split(",")] if compare else []
    scene = _base_scene(model, unit_mm, albedo, normal_map, flip_v, light, view)
    scene = _relit(scene, light, env, env_scale, show_env, background, model)
    changes = {
        "scatter_scale": scatter_scale,
        "gloss": gloss,
        "normal_strength": normal_strength,
        "deep_scatter_strength": deep_scatter_strength,
    }
    scene = _retouched(scene, changes, profile, exposure, tone)
    with terminal_progress() as progress:
        renderer = open_renderer(scene, backend, progress, adapter)  # type: ignore[arg-type]  # checked there
        if variants:
            _draw_compared(renderer, scene, extent, samples, variants, output)
        elif turntable:
            _draw_turntable(renderer, scene, extent, samples, settings, turntable, output)
        else:
            _write(renderer, scene.camera, extent, samples, settings, output)
            typer.echo(f"{output}: {extent[0]}×{extent[1]}, drawn on {renderer.place}")
    if timings:
        typer.echo(timing_report(renderer, timings))


def _check(
    extent: tuple[int, int], samples: int, turntable: int, output: Path, compare: str
) -> None:
    if not all(1 <= side <= 16384 for side in extent):
        raise ArgumentError(f"--size is {extent[0]}x{extent[1]}; each side must be 1..16384")
    if not 1 <= samples <= 256:
        raise ArgumentError(f"--samples is {samples}; it must be 1..256")
    if not 0 <= turntable <= 3600:
        raise ArgumentError(f"--turntable is {turntable}; it must be 0..3600 frames")
    # Before minutes of work, not after.
    suffixes = (".png",) if compare else (".png", ".exr")
    if output.suffix.lower() not in suffixes:
        raise ArgumentError(
            f"{output}: suffix {output.suffix!r}; it must be {' or '.join(suffixes)}"
        )
    if not output.parent.is_dir():
        raise OutputError(f"{output}: there is no folder {output.parent}")


def _base_scene(
    model: Path | None,
    unit_mm: str | None,
    albedo: Path | None,
    normal_map: Path | None,
    flip_v: bool,
    light: list[str] | None,
    view: str | None,
) -> Scene:
    yaw, pitch = numbers(view, 2, "--view") if view else (28.0, 4.0)
    if model is not None and model.suffix.lower() == ".json":
        scene = load_scene(model, light=light[0] if light else "front")
        if view:
            around = head_scene(scene.mesh, scene.material, yaw_deg=yaw, pitch_deg=pitch)
            scene = replace(scene, camera=around.camera)
        return scene
    if model is None:
        mesh, material = builtin_head()
    else:
        mesh, material = load_model(
            model,
            unit_mm=None if unit_mm is None else parse_unit_mm(unit_mm),
            albedo=albedo,
            normal_map=normal_map,
            flip_v=flip_v,
        )
    return head_scene(mesh, material, yaw_deg=yaw, pitch_deg=pitch)


def _relit(
    scene: Scene,
    light: list[str] | None,
    env: Path | None,
    env_scale: float,
    show_env: bool,
    background: str | None,
    model: Path | None,
) -> Scene:
    named = model is not None and model.suffix.lower() == ".json"
    if light and not named:
        lamps = [numbers(each, 3, "--light") for each in light]
        scene = replace(scene, lights=tuple(DirectionalLight.from_angles(*lamp) for lamp in lamps))
    if env is not None:
        scene = replace(scene, environment=Environment.load(env, scale=env_scale, visible=show_env))
    elif scene.environment is not None:
        scaled = replace(
            scene.environment,
            scale=scene.environment.scale * env_scale,
            visible=scene.environment.visible or show_env,
        )
        scene = replace(scene, environment=scaled)
    if background:
        scene = replace(scene, background=np.array(numbers(background, 3, "--background")))
    return scene


def _retouched(
    scene: Scene,
    changes: dict[str, Any],
    profile: str | None,
    exposure: float | None,
    tone: str | None,
) -> Scene:
    scene = scene.with_params(
        **{name: value for name, value in changes.items() if value is not None}
    )
    if profile:
        material = replace(scene.material, profile=Profile.preset(profile))
        scene = replace(scene, material=material)
    if exposure is not None:
        if not 0.0 <= exposure <= 1e6:
            raise ArgumentError(f"--exposure is {exposure}; it must be 0..1e6")
        scene = replace(scene, exposure=exposure)
    if tone is not None:
        if tone not in ("filmic", "srgb"):
            raise ArgumentError(f"--tone is {tone!r}; it must be filmic or srgb")
        scene = replace(scene, tone="filmic" if tone == "filmic" else "srgb")
    return scene


def _write(
    renderer: Renderer,
    camera: Camera,
    extent: tuple[int, int],
    samples: int,
    settings: RenderSettings,
    output: Path,
) -> None:
    if output.suffix.lower() == ".exr":
        write_exr(output, renderer.draw(camera, extent, samples, settings))
    else:
        write_png(output, renderer.draw_shown(camera, extent, samples, settings))


def _draw_compared(
    renderer: Renderer,
    scene: Scene,
    extent: tuple[int, int],
    samples: int,
    variants: list[tuple[str, RenderSettings]],
    output: Path,
) -> None:
    ways = [chosen for _, chosen in variants]
    images = renderer.draw_each(scene.camera, extent, samples, ways)
    pictures = [display(image, scene, way) for image, way in zip(images, ways, strict=True)]
    write_png(output, side_by_side(pictures, [label for label, _ in variants]))
    typer.echo(
        f"{output}: {len(pictures)} pictures of {extent[0]}×{extent[1]}, drawn on {renderer.place}"
    )


def _draw_turntable(
    renderer: Renderer,
    scene: Scene,
    extent: tuple[int, int],
    samples: int,
    settings: RenderSettings,
    frames: int,
    output: Path,
) -> None:
    digits = len(str(frames - 1))
    for frame in range(frames):
        camera = scene.camera.orbited(360.0 * frame / frames)
        path = output.with_stem(f"{output.stem}-{frame:0{digits}d}")
        _write(renderer, camera, extent, samples, settings, path)
    typer.echo(
        f"{output.with_stem(output.stem + '-*')}: {frames} frames, drawn on {renderer.place}"
    )
