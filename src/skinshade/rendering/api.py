"""Functions that open a renderer and draw a picture."""

from __future__ import annotations

from contextlib import suppress

from .._core.errors import BackendError
from .._core.progress import Progress, silent
from ..params.choices import AmbientForm
from ..scene import Scene
from .backend import Renderer
from .cpu.renderer import CpuRenderer
from .fallback import FallbackRenderer
from .images import RenderedImage
from .settings import Backend, RenderSettings, check_size
from .tone import tone_of

__all__ = ["open_renderer", "prepare_backend", "render"]


def open_renderer(
    scene: Scene,
    backend: str = Backend.AUTO,
    *,
    progress: Progress = silent,
    adapter: str | None = None,
    ambient: str = AmbientForm.STATIC,
) -> Renderer:
    """Open a renderer, which prepares a scene once and draws it many times.

    Parameters
    ----------
    scene
        The scene to draw.
    backend
        ``cpu``; ``gpu``, a hardware or software adapter; or ``auto``, a hardware GPU if there is one, else
        the CPU. With ``auto``, the CPU also continues when the GPU fails.
    progress
        Called with the name of the work and the fraction that is done.
    adapter
        Part of the GPU's name. With it, ``auto`` also accepts software adapters, and raises if no adapter
        has this name.
    ambient
        Ambient light at the vertices: ``static``, from the sky itself, or ``order-2`` or ``order-4``, from
        its harmonics, as an engine draws it under a sky that turns.

    Raises
    ------
    ArgumentError, BackendError
        If the backend is unknown or not available.

    Examples
    --------
    >>> import skinshade as sk
    >>> scene = sk.head_scene(sk.builtin_head())
    >>> renderer = sk.open_renderer(scene, "cpu")
    >>> renderer.draw_display(scene.camera, (64, 36), 1, sk.RenderSettings()).shape
    (36, 64, 3)
    """
    choice, form = Backend.of(backend, "backend"), AmbientForm.of(ambient, "ambient")
    if choice == Backend.CPU:
        return CpuRenderer(scene, progress, form)
    requested = choice == Backend.GPU or adapter is not None
    try:
        renderer = _gpu_renderer(scene, progress, adapter, form, software=requested)
    except BackendError:
        if requested:
            raise
        return CpuRenderer(scene, progress, form)
    if choice == Backend.GPU:
        return renderer
    return FallbackRenderer(renderer, lambda: CpuRenderer(scene, progress, form))


def prepare_backend(backend: str = Backend.AUTO, adapter: str | None = None) -> None:
    """Start to load the driver of the backend that `open_renderer` opens with the same arguments.

    It is loaded in a thread, so that a scene can be loaded at the same time. Errors are those of
    `open_renderer`.
    """
    choice = Backend.of(backend, "backend")
    if choice == Backend.CPU:
        return
    with suppress(ImportError):
        from ..gpu.device import open_device_ahead

        open_device_ahead(adapter, software=choice == Backend.GPU or adapter is not None)


def render(
    scene: Scene,
    *,
    size: tuple[int, int] = (1280, 720),
    backend: str = Backend.AUTO,
    samples: int = 4,
    settings: RenderSettings | None = None,
    progress: Progress = silent,
    ambient: str = AmbientForm.STATIC,
) -> RenderedImage:
    """Draw a scene.

    Parameters
    ----------
    scene
        The scene to draw.
    size
        (width, height) in pixels, 1..16384 each.
    backend
        ``auto``, ``gpu`` or ``cpu``; see `open_renderer`.
    samples
        Samples per pixel, 1..256.
    settings
        Settings of the picture; the defaults of `RenderSettings` if None.
    progress
        Called with the name of the work and the fraction that is done.
    ambient
        Ambient light at the vertices; see `open_renderer`.

    Returns
    -------
    (H, W, 4) float32
        Linear Rec.709 light over the background, before exposure and tone curve; the last channel is
        coverage. Notebooks show the image as a picture; `save_image` writes it to a file.

    Raises
    ------
    ArgumentError, BackendError
        If a value is out of range, or the backend is not available.

    Examples
    --------
    >>> import skinshade as sk
    >>> image = sk.render(sk.head_scene(sk.builtin_head()), size=(64, 36), samples=1)
    >>> image.shape, image.dtype
    ((36, 64, 4), dtype('float32'))
    """
    check_size(size, samples)
    settings = settings or RenderSettings()
    renderer = open_renderer(scene, backend, progress=progress, ambient=ambient)
    image = renderer.draw(scene.camera, size, samples, settings)
    return RenderedImage.of(image, *tone_of(scene, settings))


def _gpu_renderer(
    scene: Scene, progress: Progress, adapter: str | None, ambient: AmbientForm, *, software: bool
) -> Renderer:
    try:
        from .gpu.renderer import GpuRenderer
    except ImportError as error:
        raise BackendError(f"backend gpu: wgpu cannot be loaded ({error}); use cpu") from None
    return GpuRenderer(scene, progress, adapter, software, ambient)
