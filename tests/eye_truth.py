"""Ray tracer of an eye with both surfaces of the cornea, which shares no code with the model.

The front is a spline between a conic and a sphere, the back a conic; directions are refracted by Snell's law
with angles, reflectances follow from Fresnel's amplitudes, and light on the iris is counted photon by photon.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicHermiteSpline

RNG_SEED = 5
FATES = ("reflected", "limbus", "inside", "recess", "iris")
"""Ends of the light that falls on the cornea."""


@dataclass(frozen=True)
class TrueEye:
    """Shape and indices of an eye, mm, in the frame of the model."""

    sclera: float = 12.0
    limbus: float = 5.9
    blend: float = 0.6
    radius: float = 7.8
    asphericity: float = -0.26
    back_radius: float = 6.4
    back_asphericity: float = -0.60
    thickness: float = 0.5
    depth: float = 3.55
    slope: float = 0.08
    rim: float = 6.0
    tears: float = 1.337
    stroma: float = 1.376
    aqueous: float = 1.336

    @property
    def apex(self):
        return np.sqrt(self.sclera**2 - self.limbus**2) + conic(
            self.limbus, self.radius, self.asphericity
        )

    def front(self, r):
        """Return height and slope dz/dr of the front."""
        inner, outer = self.limbus - self.blend, self.limbus + self.blend
        step = 1e-6

        def cap(x):
            return self.apex - conic(x, self.radius, self.asphericity)

        def ball(x):
            return np.sqrt(self.sclera**2 - x**2)

        ends = [cap(inner), ball(outer)]
        slopes = [
            (f(x + step) - f(x - step)) / (2 * step) for f, x in ((cap, inner), (ball, outer))
        ]
        spline = CubicHermiteSpline([inner, outer], ends, slopes)
        r = np.asarray(r, dtype=float)
        inside, beyond = np.minimum(r, inner), np.clip(r, outer, 0.999 * self.sclera)
        q, radius = 1.0 + self.asphericity, self.radius
        cap_slope = -inside / np.sqrt(radius**2 - q * inside**2)
        middle = np.clip(r, inner, outer)
        height = np.where(r < inner, cap(inside), np.where(r < outer, spline(middle), ball(beyond)))
        slope = np.where(
            r < inner,
            cap_slope,
            np.where(r < outer, spline(middle, 1), -beyond / ball(beyond)),
        )
        return height, slope

    def surface(self, x, y):
        """Return points and unit normals (n, 3) of the front above x, y (n,)."""
        r = np.hypot(x, y)
        height, slope = self.front(r)
        along = slope / np.maximum(r, 1e-12)
        return np.stack([x, y, height], axis=-1), unit(
            np.stack([-along * x, -along * y, np.ones_like(r)], -1)
        )

    def opacity(self, r):
        t = np.clip((r - self.limbus + self.blend) / (2 * self.blend), 0, 1)
        return t * t * (3 - 2 * t)

    def traced(self, x, y, outward):
        """Return hits (n, 3) on the cone's surface, transmittance (n,) and cosine (n,) at the front.

        `outward` (n, 3) are unit vectors to a light or viewer. Rays that do not arrive are NaN.
        """
        point, normal = self.surface(x, y)
        cosine = np.sum(normal * outward, -1)
        with np.errstate(invalid="ignore"):
            passed = 1 - reflectance(cosine, 1.0, self.tears)
            in_tears, bent = snell(-outward, normal, 1.0, self.tears)
            passed = passed * (1 - reflectance(bent, self.tears, self.stroma))
            ray, _ = snell(in_tears, normal, self.tears, self.stroma)
            point = met(
                point, ray, self.apex - self.thickness, self.back_radius, self.back_asphericity
            )
            depth = self.apex - self.thickness - point[:, 2]
            gradient = (1 + self.back_asphericity) * depth - self.back_radius
            normal = unit(np.stack([-point[:, 0], -point[:, 1], gradient], -1)) * -1.0
            passed = passed * (
                1 - reflectance(-np.sum(normal * ray, -1), self.stroma, self.aqueous)
            )
            ray, _ = snell(ray, normal, self.stroma, self.aqueous)
            hit = self.on_cone(point, ray)
        passed = np.where((cosine > 0) & np.isfinite(hit).all(-1), passed, np.nan)
        return np.where(np.isfinite(passed)[:, None], hit, np.nan), passed, cosine

    def on_cone(self, point, ray):
        """Return the points (n, 3) of the cone on rays, by bisection of the height above it."""
        low, high = np.zeros(len(point)), np.full(len(point), 40.0)

        def above(t):
            p = point + t[:, None] * ray
            return p[:, 2] - (self.apex - self.depth - self.slope * np.hypot(p[:, 0], p[:, 1]))

        meets = above(high) < 0
        for _ in range(44):
            middle = 0.5 * (low + high)
            over = above(middle) > 0
            low, high = np.where(over, middle, low), np.where(over, high, middle)
        return np.where(meets[:, None], point + low[:, None] * ray, np.nan)

    def hidden_by_sclera(self, point, outward):
        along = np.sum(point * outward, -1)
        return (along < 0) & (np.sum(point * point, -1) - along**2 < self.sclera**2)

    def with_cornea(self, radius, asphericity, thickness, aqueous=1.336):
        """Return an eye with another back surface."""
        return replace(
            self,
            back_radius=radius,
            back_asphericity=asphericity,
            thickness=thickness,
            aqueous=aqueous,
        )


def conic(r, radius, asphericity):
    return (radius - np.sqrt(radius**2 - (1 + asphericity) * r**2)) / (1 + asphericity)


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def snell(ray, normal, before, after):
    """Return refracted directions (n, 3), NaN after total reflection, and cosines (n,) behind the surface."""
    c = -np.sum(ray * normal, -1)
    tangent = ray + c[:, None] * normal
    tangent = tangent * (before / after)
    size2 = np.sum(tangent * tangent, -1)
    inside = np.sqrt(np.where(size2 < 1, 1 - size2, np.nan))
    return tangent - inside[:, None] * normal, inside


def reflectance(cosine, before, after):
    """Return Fresnel's reflectance of unpolarised light from the angles on both sides."""
    first = np.arccos(np.clip(cosine, 0, 1))
    second = np.arcsin(np.clip(before / after * np.sin(first), -1, 1))
    ratio_s = before * np.cos(first) - after * np.cos(second)
    ratio_s /= before * np.cos(first) + after * np.cos(second)
    ratio_p = after * np.cos(first) - before * np.cos(second)
    ratio_p /= after * np.cos(first) + before * np.cos(second)
    return (ratio_s**2 + ratio_p**2) / 2


def met(point, ray, apex, radius, asphericity):
    """Return the points (n, 3) of a conic on rays from above it, by Newton's method."""
    t = np.zeros(len(point))
    for _ in range(8):
        p = point + t[:, None] * ray
        depth = apex - p[:, 2]
        value = p[:, 0] ** 2 + p[:, 1] ** 2 - 2 * radius * depth + (1 + asphericity) * depth**2
        change = 2 * (p[:, 0] * ray[:, 0] + p[:, 1] * ray[:, 1]) + 2 * radius * ray[:, 2]
        change -= 2 * (1 + asphericity) * depth * ray[:, 2]
        t = t - value / change
    return point + t[:, None] * ray


def tilted(angle_deg, count=1):
    """Return unit vectors (count, 3) at an angle to the gaze, towards +x."""
    a = np.radians(angle_deg)
    return np.tile([np.sin(a), 0.0, np.cos(a)], (count, 1))


def cornea_grid(eye, outer, side):
    """Return x, y of a grid over the disk of a radius, and the area of its cells, mm²."""
    line = (np.arange(side) + 0.5) / side * 2 * outer - outer
    x, y = (g.ravel() for g in np.meshgrid(line, line))
    inside = np.hypot(x, y) < outer
    return x[inside], y[inside], (2 * outer / side) ** 2


def parallel_view(eye, angle_deg, side=60):
    """Return points, normals, view, true hits, and weights of a view of the cornea within the limbus."""
    x, y, area = cornea_grid(eye, eye.limbus, side)
    view = tilted(angle_deg, len(x))
    hit, _, cosine = eye.traced(x, y, view)
    point, normal = eye.surface(x, y)
    used = np.isfinite(hit).all(-1) & (np.hypot(hit[:, 0], hit[:, 1]) < eye.rim)
    weight = np.where(used, np.maximum(cosine, 0) / normal[:, 2] * area, 0)
    return point[used], normal[used], view[used], hit[used], weight[used]


def photons(eye, angle_deg, count, seed=RNG_SEED, lamp_deg=3.0):
    """Return hits (n, 3), entries (n, 2) and flux (n,) of photons that reach the cone, from a round lamp.

    The irradiance of a surface that faces the lamp is 1 per mm². The last value is the flux by `FATES`.
    """
    rng = np.random.default_rng(seed)
    outer = eye.limbus + eye.blend
    r, phi = outer * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    x, y = r * np.cos(phi), r * np.sin(phi)
    polar, turn = np.radians(lamp_deg) * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    centre, side = tilted(angle_deg)[0], tilted(angle_deg + 90.0)[0]
    light = unit(
        centre
        + np.tan(polar)[:, None]
        * (np.cos(turn)[:, None] * side + np.sin(turn)[:, None] * [0, 1, 0])
    )
    hit, passed, cosine = eye.traced(x, y, light)
    point, normal = eye.surface(x, y)
    arriving = np.where(cosine > 0, cosine, 0) / normal[:, 2] * np.pi * outer**2 / count
    arriving = np.where(eye.hidden_by_sclera(point, light), 0, arriving)
    passed = np.where(np.isfinite(passed), passed, 0)
    opacity = eye.opacity(r)
    flux = arriving * passed * (1 - opacity)
    on_iris = np.hypot(hit[:, 0], hit[:, 1]) <= eye.rim
    front = 1 - reflectance(np.clip(cosine, 0, 1), 1.0, eye.tears)
    sums = {
        "reflected": np.sum(arriving * (1 - front)),
        "limbus": np.sum(arriving * front * opacity),
        "inside": np.sum(arriving * (front - passed) * (1 - opacity)),
        "recess": np.sum(flux[~on_iris]),
        "iris": np.sum(flux[on_iris]),
    }
    used = flux > 0
    return hit[used], np.stack([x, y], -1)[used], flux[used], sums, np.sum(arriving)


def irradiance_in_bins(eye, angle_deg, count, side=0.5, seed=RNG_SEED):
    """Return centres (n, 2) of square bins of the iris and the irradiance (n,) on the cone in them."""
    hit, _, flux, _, _ = photons(eye, angle_deg, count, seed)
    edges = np.arange(-6.0, 6.0 + side / 2, side)
    # Both halves are equal: y counts by its size.
    sums, _, _ = np.histogram2d(
        hit[:, 0], np.abs(hit[:, 1]), [edges, edges[edges >= -1e-9]], weights=flux
    )
    centres = 0.5 * (edges[1:] + edges[:-1])
    x, y = np.meshgrid(centres, centres[centres > 0], indexing="ij")
    values = sums / (2 * side * side * np.sqrt(1 + eye.slope**2))
    r = np.hypot(x, y)
    used = (r > 1.0) & (r < 5.5)
    return np.stack([x[used], y[used]], -1), values[used]


def newton_irradiance(eye, target, light):
    """Return the irradiance (n,) of a distant point on points (n, 2) of the iris, and the entries (n, 2).

    Newton's method finds where light towards the target enters; the flux is spread by the Jacobian.
    """
    p = 0.75 * np.array(target, dtype=float)
    lights = np.tile(light, (len(p), 1))
    step = 1e-4

    def hit(q):
        return eye.traced(q[:, 0], q[:, 1], lights)[0][:, :2]

    def jacobian(q):
        columns = [(hit(q + d) - hit(q - d)) / (2 * step) for d in np.eye(2) * step]
        return np.stack(columns, axis=-1)

    for _ in range(12):
        move = np.linalg.solve(jacobian(p), (target - hit(p))[..., None])[..., 0]
        p = p + move * np.minimum(
            1.0, 1.0 / np.maximum(np.linalg.norm(move, axis=-1, keepdims=True), 1e-12)
        )
    _, passed, cosine = eye.traced(p[:, 0], p[:, 1], lights)
    _, normal = eye.surface(p[:, 0], p[:, 1])
    spread = np.abs(np.linalg.det(jacobian(p))) * np.sqrt(1 + eye.slope**2)
    open_share = 1 - eye.opacity(np.hypot(p[:, 0], p[:, 1]))
    error = np.linalg.norm(hit(p) - target, axis=-1)
    value = passed * open_share * cosine / normal[:, 2] / spread
    return np.where(error < 1e-6, value, np.nan), p
