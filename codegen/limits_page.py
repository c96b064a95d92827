"""Page of all limits: name, default, unit and meaning."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from itertools import groupby

from skinshade._core.arrays import LARGEST_LIGHT, LARGEST_POSITION, LARGEST_RADIANCE
from skinshade._core.limits import GREATEST, LimitMeaning, Limits
from skinshade.scene.camera import LEAST_DISTANCE_MM, LEAST_RELATIVE_DISTANCE
from skinshade.scene.lights import LARGEST_AT_1_MM
from skinshade.scene.material import ALBEDO_RANGE, MAP_RANGES, RADIUS_RANGE_MM
from skinshade.scene.scene import LARGEST_CURVATURE_PER_MM, LARGEST_UV

__all__ = ["limits_page"]


def _span(ends: tuple[float, float]) -> str:
    return f"{ends[0]:g} to {ends[1]:g}"


def _map_range(name: str, channel: int = 0) -> str:
    return _span(MAP_RANGES[name][channel])


HEAD = """# Limits

Generated from `skinshade.Limits` and the constants of `scene/` by `python -m codegen`. A file or request
beyond a limit is refused before memory is allocated or long work begins. The error names the limit and its
value, and says how to raise it:

```sh
skinshade render head.glb --limit image_pixels=600000000 --limit lights=100
skinshade bake assets/ -o baked/ --jobs 4 --limit triangles=200000000
```

In Python, `with skinshade.use_limits(image_pixels=600_000_000):` applies other limits to its body, in the same
thread and in asynchronous tasks that it starts. A thread that the body starts has the default limits. The jobs
of `skinshade bake` carry their limits to other processes and machines. `skinshade.limits()` returns the limits
that apply.

An image of *n* bytes may have `image_free_pixels` + `image_pixels_per_byte` · *n* pixels, and `image_pixels`
at most. A flat 4096×4096 image is accepted at any file size, and so is every PNG file with 8 bits per channel
and no palette up to 16384×16384, because its compression never exceeds the factor. Bitmaps of one bit, and flat
images in lossless WebP, compress more and are refused well above 4096×4096. The rule for the accessors of glTF
documents has the same form.

Reading an image takes little more memory than its result: an 8192×8192 map in PNG, 8 bits per channel, takes
0.8 GiB, and the result 0.75 GiB, as linear light in float32.

"""
RANGES = f"""
## Ranges of a scene

Values outside these ranges are errors too. Light, its factors and materials multiply; within the ranges, the
products are finite in single precision, and no picture contains NaN or infinity.

| value | range |
|---|---|
| positions of meshes, cameras and lights | ±{LARGEST_POSITION:g} mm |
| distance of a camera or spot light to its target | {LEAST_DISTANCE_MM:g} mm or more, and \
{LEAST_RELATIVE_DISTANCE:g} of the greatest coordinate or more |
| irradiance of a light, radiance of the background | 0 to {LARGEST_LIGHT:g} |
| irradiance of a spot light at 1 mm | up to {LARGEST_AT_1_MM:g} |
| radiance of an environment | 0 to {LARGEST_RADIANCE:g} |
| scale of an environment, exposure | 0 to {LARGEST_LIGHT:g} |
| texture coordinates | ±{LARGEST_UV:g} |
| baked curvature and shape operator | ±{LARGEST_CURVATURE_PER_MM:g} /mm |
| albedo and deep scatter maps | {_map_range("albedo")}; physical values are 0 to 1 |
| specular map | factor on the reflectance {_map_range("specular")}, gloss {_map_range("specular", 1)} |
| albedo of a diffusion profile | {_span(ALBEDO_RANGE)} |
| root mean square radius of a scaled profile | {_span(RADIUS_RANGE_MM)} mm |

`skinshade.SkinParams` lists the ranges of the other parameters of a material.
"""


def limits_page() -> str:
    """Return the page as Markdown."""
    lines = [HEAD]
    for group, rows in groupby(_rows(), key=lambda row: row[2].group):
        lines += [f"## {group}", "", "| limit | default | unit | meaning |", "|---|---|---|---|"]
        for name, value, meaning in rows:
            about = meaning.about
            if meaning.greatest < GREATEST:
                about += f" It can be raised to {meaning.greatest}."
            lines.append(f"| `{name}` | {_number(value)} | {meaning.unit} | {about} |")
        lines.append("")
    return "\n".join(lines).rstrip() + "\n" + RANGES


def _rows() -> Iterator[tuple[str, int, LimitMeaning]]:
    defaults = Limits()
    for entry in fields(Limits):
        yield entry.name, getattr(defaults, entry.name), entry.metadata["meaning"]


def _number(value: int) -> str:
    """Return a whole number, as a power of two where it is a large one."""
    exponent = value.bit_length() - 1
    return f"2^{exponent} = {value}" if value == 2**exponent and value > 1000 else str(value)
