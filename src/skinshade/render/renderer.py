"""What a backend is, and the one call that makes a picture."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, Protocol, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from .._core.arrays import FloatArray, ImageArray
from .._core.errors import ArgumentError, BackendError
from .._core.progress import Progress, silent
from ..scene import Camera, Scene
from ..shading.compose import TERMS, ShadingMode, Tier
from ..shading.tonemap import ToneMap, tonemap
from .cpu.shadow_map import ShadowFilter

__all__ = [
    "DEBUG_VIEWS",
    "TERM_VIEWS",
    "Backend",
    "RenderSettings",
    "Renderer",
    "display",
    "open_renderer",
    "render",
]

Picture = TypeVar("Picture")
Backend = Literal["auto", "gpu", "cpu"]
Antialiasing = Literal["supersampling", "multisampling"]
SHADINGS: tuple[ShadingMode, ...] = get_args(ShadingMode)
TIERS: tuple[Tier, ...] = get_args(Tier)
SHADOW_FILTERS: tuple[ShadowFilter, ...] = get_args(ShadowFilter)
TAP_COUNTS = (0, 8, 32)
"""Of deep scatter; 0 is off."""
MULTISAMPLES = 4
"""Samples a pixel with ``multisampling``."""

GEOMETRY_VIEWS = ("normal", "blurred-normal", "curvature", "thickness", "shadow", "albedo")
TERM_VIEWS = {term.replace("_", "-"): term for term in TERMS}
DEBUG_VIEWS = (*GEOMETRY_VIEWS, *TERM_VIEWS)
"""What can be looked at alone; curvature ±0.2/mm (blue concave, red convex), thickness 0..30 mm."""


@dataclass(frozen=True)
class RenderSettings:
    """How to shade.

    Attributes
    ----------
    shading
        ``transfer`` (default), ``classic`` (2014) or ``lambert`` (no scattering).
    tier
        Geometry that ``transfer`` uses: ``scalar``, ``tensor`` or ``diffused-normals``.
    deep_scatter_taps
        0 (off), 8 or 32.
    normal_fetches
        Of the normal map: 3 (sharp and two blurs) or 2 (sharp and one).
    shadow_filter
        ``percentage-closer`` or ``variance``, both as wide.
    antialiasing
        ``supersampling`` shades every sample; with ``multisampling`` a GPU shades once a pixel, filters
        maps along its footprint, and finds edges from 4 samples (the CPU shades those 4).
    debug_view
        One of `DEBUG_VIEWS`, or None for the picture.
    seed
        Moves the samples within the pixels.
    """

    shading: ShadingMode = "transfer"
    tier: Tier = "diffused-normals"
    deep_scatter_taps: int = 8
    normal_fetches: int = 3
    shadow_filter: ShadowFilter = "percentage-closer"
    antialiasing: Antialiasing = "supersampling"
    debug_view: str | None = None
    seed: int = 0

    def __post_init__(self) -> None:
        for name, value, allowed in (
            ("shading", self.shading, SHADINGS),
            ("tier", self.tier, TIERS),
            ("deep_scatter_taps", self.deep_scatter_taps, TAP_COUNTS),
            ("normal_fetches", self.normal_fetches, (2, 3)),
            ("shadow_filter", self.shadow_filter, SHADOW_FILTERS),
            ("antialiasing", self.antialiasing, get_args(Antialiasing)),
            ("debug_view", self.debug_view, (None, *DEBUG_VIEWS)),
        ):
            if value not in allowed:
                choices = ", ".join(str(choice) for choice in allowed if choice is not None)
                raise ArgumentError(f"{name} is {value!r}; it must be one of {choices}")
        if self.seed < 0:
            raise ArgumentError(f"seed is {self.seed}; it must not be negative")

    @property
    def thickness_taps(self) -> int:
        """Taps that are looked at: nothing comes through a surface without scattering."""
        return 0 if self.shading == "lambert" else self.deep_scatter_taps


class Renderer(Protocol):
    """A scene made ready: what does not depend on the camera is computed once.

    Attributes
    ----------
    scene
        What is drawn.
    """

    scene: Scene

    @property
    def place(self) -> str:
        """What draws it, for a person to read."""

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Time of every pass so far on the device itself, ms, by its name; empty where none can be had."""

    def draw_each(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Return (H, W, 4) linear light and coverage for each way, which share the first one's seed."""

    def draw(
        self, camera: Camera, size: tuple[int, int], samples: int, way: RenderSettings
    ) -> ImageArray:
        """Return (H, W, 4) linear light and coverage."""
        return self.draw_each(camera, size, samples, [way])[0]

    def draw_shown(
        self, camera: Camera, size: tuple[int, int], samples: int, way: RenderSettings
    ) -> NDArray[np.uint8]:
        """Return (H, W, 3) display values in eight bits, through the scene's tone curve."""
        picture = self.draw(camera, size, samples, way)
        shown: NDArray[np.uint8] = np.rint(display(picture, self.scene, way) * 255.0).astype(
            np.uint8
        )
        return shown


def open_renderer(
    scene: Scene,
    backend: Backend = "auto",
    progress: Progress = silent,
    adapter: str | None = None,
) -> Renderer:
    """Make a scene ready to be drawn many times.

    Parameters
    ----------
    scene
        What is drawn.
    backend
        ``cpu``; ``gpu``, be it in software; ``auto`` for a GPU that is hardware or was named, or else
        the CPU.
    progress
        Called with what is being done and how far it is.
    adapter
        Part of the name of the GPU.

    Raises
    ------
    BackendError
        If the backend asked for is not there.
    """
    if backend not in get_args(Backend):
        raise ArgumentError(f"backend is {backend!r}; it must be auto, gpu or cpu")
    from .cpu.renderer import CpuRenderer

    if backend == "cpu":
        return CpuRenderer(scene, progress)
    try:
        software = backend == "gpu" or adapter is not None
        found = _gpu_renderer(scene, progress, adapter, software)
    except BackendError:
        if backend == "gpu" or adapter is not None:
            raise
        return CpuRenderer(scene, progress)
    if backend == "gpu":
        return found
    return WithFallback(found, lambda: CpuRenderer(scene, progress))


class WithFallback(Renderer):
    """A renderer, and another for when its device is lost or out of memory.

    Parameters
    ----------
    first
        Draws as long as it can.
    then
        Makes the one that draws from there on.
    """

    def __init__(self, first: Renderer, then: Callable[[], Renderer]) -> None:
        self._now, self._then = first, then
        self.scene = first.scene

    @property
    def place(self) -> str:
        """What draws now."""
        return self._now.place

    @property
    def timings_ms(self) -> dict[str, list[float]]:
        """Of what draws now."""
        return self._now.timings_ms

    def draw_each(
        self,
        camera: Camera,
        size: tuple[int, int],
        samples: int,
        ways: Sequence[RenderSettings],
    ) -> list[ImageArray]:
        """Return a picture for each way."""
        return self._drawn(lambda now: now.draw_each(camera, size, samples, ways))

    def draw_shown(
        self, camera: Camera, size: tuple[int, int], samples: int, way: RenderSettings
    ) -> NDArray[np.uint8]:
        """Return display values."""
        return self._drawn(lambda now: now.draw_shown(camera, size, samples, way))

    def _drawn(self, work: Callable[[Renderer], Picture]) -> Picture:
        try:
            return work(self._now)
        except BackendError:
            self._now = self._then()
            return work(self._now)


def _gpu_renderer(
    scene: Scene, progress: Progress, adapter: str | None, software: bool
) -> Renderer:
    try:
        from .gpu.renderer import GpuRenderer
    except ImportError as error:
        raise BackendError(f"backend gpu: wgpu cannot be loaded ({error}); use cpu") from None
    return GpuRenderer(scene, progress, adapter, software)


def render(
    scene: Scene,
    *,
    size: tuple[int, int] = (1280, 720),
    backend: Backend = "auto",
    samples: int = 4,
    settings: RenderSettings | None = None,
    progress: Progress = silent,
) -> ImageArray:
    """Draw a scene.

    Parameters
    ----------
    scene
        What is drawn.
    size
        (width, height), 1..16384 each.
    backend
        ``auto``, ``gpu`` or ``cpu``.
    samples
        Samples a pixel, 1..256.
    settings
        How to shade; `RenderSettings` by default.
    progress
        Called with what is being done and how far it is.

    Returns
    -------
    (H, W, 4) float32
        Linear Rec.709 light before exposure and tone mapping, over the background, and coverage.

    Raises
    ------
    ArgumentError, BackendError
        If the request is out of range, or the backend is not there.
    """
    width, height = size
    if not (1 <= width <= 16384 and 1 <= height <= 16384):
        raise ArgumentError(f"size is {width}×{height}; each side must be 1..16384 pixels")
    if not 1 <= samples <= 256:
        raise ArgumentError(f"samples is {samples}; it must be 1..256")
    renderer = open_renderer(scene, backend, progress)
    return renderer.draw(scene.camera, size, samples, settings or RenderSettings())


def display(image: ImageArray, scene: Scene, settings: RenderSettings) -> FloatArray:
    """Return display values (H, W, 3) of a rendered image: the scene's tone, none for geometry."""
    return tonemap(image[..., :3].astype(np.float64), *tone_of(scene, settings))


def tone_of(scene: Scene, settings: RenderSettings) -> tuple[ToneMap, float]:
    """Return the tone curve of a picture and its exposure: the scene's, none for geometry."""
    if settings.debug_view in GEOMETRY_VIEWS:
        return "srgb", 1.0
    return scene.tone, scene.exposure


def sample_offsets(samples: int, seed: int) -> list[tuple[float, float]]:
    """Points of a pixel by the additive recurrence R₂ [Roberts2018], turned by the seed."""
    if samples == 1:
        return [(0.5, 0.5)]
    start = np.random.default_rng(seed).random(2) if seed else np.array([0.5, 0.5])
    step = np.array([0.7548776662466927, 0.5698402909980532])  # 1/ρ, 1/ρ² of ρ³ = ρ + 1
    points = (start + step * np.arange(samples)[:, None]) % 1.0
    return [(float(x), float(y)) for x, y in points]
