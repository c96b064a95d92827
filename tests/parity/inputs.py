"""Random and limiting values for every parameter of the shader library, by name."""

from __future__ import annotations

import numpy as np

from skinshade.params import EyeParams
from skinshade.params.eye import lid_plane
from skinshade.shading.eye import eye_height

COUNT = 512


def uniform(low, high, *ends):
    """Return a function that draws numbers between two bounds; bounds and `ends` are among them."""

    def draw(rng, shape=()):
        values = rng.uniform(low, high, (COUNT, *shape))
        limits = np.array([low, high, *ends])
        flat = values.reshape(COUNT, -1)
        flat[: limits.size] = limits[:, None]
        return values

    return draw


def rgb(low, high):
    return lambda rng: uniform(low, high)(rng, (3,))


def unit(rng):
    v = rng.normal(size=(COUNT, 3))
    v[:3] = np.eye(3)
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def channel_normals(rng):
    """Return three normals per row, shorter than 1 like averages; some have length 1, some 0."""
    v = np.stack([unit(rng) for _ in range(3)], axis=1)
    length = rng.uniform(0.05, 1.0, (COUNT, 3, 1))
    length[:4] = [[[1.0]] * 3, [[0.5]] * 3, [[1e-3]] * 3, [[0.0]] * 3]
    return v * length


def weights(rng):
    w = rng.dirichlet(np.ones(3), (COUNT, 3))
    w[0] = [[1.0, 0.0, 0.0]] * 3
    return w


def symmetric(rng):
    m = rng.normal(size=(COUNT, 3, 3)) * 0.1
    m[0] = 0.0
    return 0.5 * (m + m.swapaxes(1, 2))


def coefficients(rng):
    return np.tile(rng.normal(size=(3, 3)), (COUNT, 1, 1))


def projection(rng):
    """Return one projection for all rows: parallel or perspective, of a random hand and depth range."""
    near, far = 40.0, 2000.0
    hand = rng.choice([-1.0, 1.0])
    at_near, at_far = [(0.0, 1.0), (-1.0, 1.0), (1.0, 0.0)][rng.integers(3)]
    m = np.eye(4)
    if rng.integers(2):
        m[3] = [0.0, 0.0, hand, 0.0]
        slope = (at_far * far - at_near * near) / (far - near)
        m[2, 2], m[2, 3] = hand * slope, near * (at_near - slope)
    else:
        slope = (at_far - at_near) / (far - near)
        m[2, 2], m[2, 3] = hand * slope, at_near - slope * near
    return np.tile(m, (COUNT, 1, 1))


def light_projection(rng):
    """Return a projection that maps some 100 mm, 700 mm in front of a light, to the whole map."""
    m = projection(rng)
    m[:, :2] *= 8.0 if m[0, 3, 3] == 0.0 else 1.0 / 80.0
    return m


def light_view(rng):
    """Return the view of a light that is 700 mm from the origin, of either hand; one for all rows."""
    right, up, forward = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    m = np.eye(4)
    m[:3, :3] = right, up, rng.choice([-1.0, 1.0]) * forward
    m[2, 3] = rng.choice([-700.0, 700.0])
    return np.tile(m, (COUNT, 1, 1))


def sky_harmonics(rng):
    """Return harmonics that are within those of a visible sky, 0 for a hidden one."""
    values = rng.uniform(-0.3, 0.3, (COUNT, 3, 3))
    values[:, 0, 0] = rng.uniform(0.0, 0.282, COUNT)
    values[:4] = 0.0
    return values


def one_unit_for_all(rng):
    return np.tile(unit(rng)[-1], (COUNT, 1))


def one_for_all(low, high):
    return lambda rng: np.full(COUNT, rng.uniform(low, high))


def one_for_all_uv(rng):
    """Return the radius of a disk in a map whose texels need not be square."""
    return np.tile(rng.uniform(0.002, 0.05, 2), (COUNT, 1))


def footprint(rng):
    """Return changes of UV from 0 to the whole map."""
    along = 10.0 ** rng.uniform(-6.0, 0.0, (COUNT, 1)) * rng.normal(size=(COUNT, 2))
    along[0] = 0.0
    return along


EYE = EyeParams()


def eye_pack(pack, spread):
    """Return packs of parameters of eyes near the default."""
    return lambda rng: pack + rng.uniform(-1.0, 1.0, (COUNT, 4)) * spread


def on_eye(rng, widest=9.0):
    """Return points near the front of an eye, the apex among them."""
    r, phi = widest * np.sqrt(rng.random(COUNT)), rng.uniform(0.0, 2.0 * np.pi, COUNT)
    r[0] = 0.0
    z = eye_height(r, EYE.cornea, EYE.limbus) + rng.uniform(-0.05, 0.05, COUNT)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=1)


def on_cornea(rng):
    return on_eye(rng, 5.5)


def on_iris(rng):
    r, phi = rng.uniform(0.0, 6.5, COUNT), rng.uniform(0.0, 2.0 * np.pi, COUNT)
    r[0] = 0.0
    return np.stack([r * np.cos(phi), r * np.sin(phi), 9.4 - 0.08 * r], axis=1)


def forward(angle_deg, sign=1.0):
    """Return a function that draws unit vectors within an angle of the gaze, or of its opposite."""

    def draw(rng):
        z = rng.uniform(np.cos(np.radians(angle_deg)), 1.0, COUNT)
        z[0], phi = 1.0, rng.uniform(0.0, 2.0 * np.pi, COUNT)
        s = np.sqrt(1.0 - z * z)
        return np.stack([s * np.cos(phi), s * np.sin(phi), sign * z], axis=1)

    return draw


def lid(height_mm):
    return lambda rng: np.stack([lid_plane(height_mm * k) for k in rng.uniform(0.2, 1.2, COUNT)])


def near_pairs(rng):
    """Return unit vectors near +x, as a lamp and its reflection are."""
    v = np.array([1.0, 0.0, 0.0]) + rng.normal(size=(COUNT, 3)) * 0.1
    return v / np.linalg.norm(v, axis=1, keepdims=True)


def uniform_rows(low, high):
    return lambda rng: rng.uniform(low, high, (COUNT, len(low)))


VALUES = {
    "albedo": rgb(0.02, 0.95),
    "bias_mm": one_for_all(0.1, 5.0),
    "band_transfer": lambda rng: uniform(0.0, 1.2)(rng, (3, 3)),
    "blend": weights,
    "blue": rgb(0.0, 2.0),
    "blurred": unit,
    "contact": uniform(0.0, 1.0),
    "coat_reflectance": one_for_all(0.0, 0.2),
    "cosine": uniform(0.0, 1.0),
    "curvature_per_mm": uniform(-0.5, 0.5, 0.0),
    "depth": uniform(0.0, 0.97),
    "depth_mm": uniform(-150.0, 150.0),
    "direction": unit,
    "directional_per_mm": uniform(0.0, 0.5),
    "display": rgb(-0.1, 1.1),
    "face_normal": unit,
    "faces_light": lambda rng: rng.integers(0, 2, COUNT).astype(float),
    "fetched": channel_normals,
    "filter_width_mm": one_for_all(4.0, 20.0),
    "from_mesh": channel_normals,
    "from_texture": channel_normals,
    "gain": rgb(1.0, 1.6),
    "gloss": uniform(0.0, 1.0),
    "green": rgb(0.0, 2.0),
    "hardware_level": uniform(0.0, 6.0),
    "irradiance_behind": rgb(0.0, 2.0),
    "light": unit,
    "light_right": one_unit_for_all,
    "light_up": one_unit_for_all,
    "m": uniform(-1.0, 1.0, 0.0),
    "map_extent": lambda rng: 2.0 ** rng.integers(0, 14, (COUNT, 2)),
    "map_size": one_for_all(256.0, 4096.0),
    "mean_depth_mm": uniform(-150.0, 150.0, 0.0),
    "mean_square_depth_mm2": uniform(0.0, 3e4, 100.0),
    "mesh_normal": unit,
    "n_dot_l": uniform(-1.0, 1.0, 0.0),
    "n_dot_v": uniform(-1.0, 1.0, 0.0),
    "normal": unit,
    "normal_length": uniform(0.0, 1.0),
    "normals": channel_normals,
    "offset_mm": one_for_all(0.0, 2.0),
    "p": uniform(-0.5, 1.5, 0.0, 1.0),
    "position_mm": rgb(-300.0, 300.0),
    "power": uniform(0.1, 3e3, 1.0),
    "projection": projection,
    "pull": uniform(0.0, 0.8),
    "radius_mm": one_for_all(1.0, 8.0),
    "radiance_sh_blue": coefficients,
    "radiance_sh_green": coefficients,
    "radiance_sh_red": coefficients,
    "red": rgb(0.0, 2.0),
    "radius_uv": one_for_all_uv,
    "receiver_mm": uniform(50.0, 1500.0),
    "reflectance": uniform(0.0, 0.2),
    "relief_length": rgb(0.0, 1.0),
    "rms_radius_mm": rgb(0.1, 5.0),
    "roughness": uniform(0.0, 1.0),
    "s": uniform(0.0, 1.0),
    "shadow": rgb(0.0, 1.0),
    "share": uniform(0.0, 1.0),
    "shadow_filter": uniform(0.0, 1.0, 0.5),
    "sharp": unit,
    "sharpening": one_for_all(1.0, 12.0),
    "sigma_mm": uniform(0.0, 4.0),
    "sigma_per_mm": rgb(0.05, 3.0),
    "strength": one_for_all(0.0, 4.0),
    "tensor_world": symmetric,
    "ambient_transfer_blue": sky_harmonics,
    "ambient_transfer_green": sky_harmonics,
    "ambient_transfer_red": sky_harmonics,
    "taps": lambda rng: np.full(COUNT, rng.choice([8, 32])),
    "thickness_mm": uniform(0.0, 100.0),
    "to_light": unit,
    "total_per_mm": uniform(0.5, 1.0),
    "transmitted": rgb(0.0, 1.0),
    "uv": lambda rng: uniform(-0.05, 1.05)(rng, (2,)),
    "uv_along_x": footprint,
    "uv_along_y": footprint,
    "uv_scale_mm": one_for_all(100.0, 900.0),
    "view": unit,
    "cornea": eye_pack(EYE.cornea, (0.1, 0.3, 0.1, 0.03)),
    "cornea_asphericity": uniform(-0.8, 0.3, 0.0),
    "cornea_radius_mm": uniform(6.5, 10.0),
    "height_mm": uniform(0.0, 0.3),
    "hit_mm": on_iris,
    "index": uniform(1.1, 1.6),
    "iris": eye_pack(EYE.iris, (0.1, 0.25, 0.5, 1.0)),
    "iris_normal": forward(30.0),
    "iris_uv": uniform_rows((0.0, 0.0, 0.0, -1.0), (1.0, 1.0, 0.5, 1.0)),
    "lamp": uniform(0.001, 0.3),
    "lid": lid(4.2),
    "limbus": eye_pack(EYE.limbus, (0.3, 0.2, 0.3, 0.0)),
    "lower": lid(-5.6),
    "luminance": lambda rng: 10.0 ** rng.uniform(-8.0, 9.0, COUNT),
    "margin_mm": uniform(0.05, 0.5),
    "origin_mm": on_eye,
    "pupil_in_map": uniform(0.0, 0.9),
    "r_mm": uniform(0.0, 7.0),
    "reflected": near_pairs,
    "refraction_index": uniform(1.2, 1.6),
    "spread": uniform(0.002, 0.3),
    "upper": lid(4.2),
    "visibility": uniform(0.0, 1.0),
    "bounced": rgb(0.0, 1.0),
    "diffused": rgb(0.0, 1.0),
    "sky": rgb(0.0, 2.0),
    "through": rgb(0.0, 1.0),
    "sky_harmonics": sky_harmonics,
}
"""Functions that draw values, by the parameter's name, which has one meaning in the library."""

BY_FUNCTION = {
    ("skin_eye_cornea_hit", "direction"): forward(45.0, -1.0),
    ("skin_eye_cornea_hit", "origin_mm"): on_cornea,
    ("skin_eye_iris_hit", "iris"): eye_pack(EYE.iris, (0.1, 0.08, 0.5, 1.0)),
    ("skin_eye_iris_hit", "normal"): forward(40.0),
    ("skin_eye_iris_hit", "position_mm"): on_cornea,
    ("skin_eye_iris_hit", "view"): forward(75.0),
    ("skin_eye_iris_parallax", "direction"): forward(50.0, -1.0),
    ("skin_eye_light", "light"): forward(120.0),
    ("skin_eye_normal", "position_mm"): on_eye,
    ("skin_lamp_highlight", "light"): near_pairs,
    ("skin_lamp_highlight", "roughness"): uniform(0.01, 0.3),
    ("skin_lid_openness", "normal"): forward(50.0),
    ("skin_lid_openness", "position_mm"): on_eye,
    ("skin_lid_openness", "radius_mm"): one_for_all(13.5, 15.0),
    ("skin_lid_visibility", "direction"): forward(75.0),
    ("skin_lid_visibility", "position_mm"): on_eye,
    ("skin_lid_visibility", "radius_mm"): one_for_all(13.5, 15.0),
    ("skin_tear_normal", "height_mm"): uniform(0.2, 8.0),
    ("skin_tear_normal", "normal"): forward(50.0),
    ("skin_tear_normal", "position_mm"): on_eye,
    ("skin_contact_filter", "map_extent"): lambda rng: np.tile([128.0, 96.0], (COUNT, 1)),
    ("skin_contact_filter", "position_mm"): rgb(-60.0, 60.0),
    ("skin_contact_filter", "projection"): light_projection,
    ("skin_contact_filter", "view"): light_view,
    ("skin_energy_gain", "curvature_per_mm"): rgb(-0.5, 0.5),
    ("skin_bounced_visibility", "visibility"): rgb(0.0, 1.0),
    ("skin_filmic", "light"): rgb(0.0, 20.0),
    ("skin_light_coordinates", "view"): light_view,
    ("skin_shadow_filter", "map_extent"): lambda rng: np.tile([128.0, 96.0], (COUNT, 1)),
    ("skin_shadow_filter", "position_mm"): rgb(-60.0, 60.0),
    ("skin_shadow_filter", "projection"): light_projection,
    ("skin_shadow_filter", "taps"): lambda rng: np.full(COUNT, rng.choice([16, 48])),
    ("skin_shadow_filter", "view"): light_view,
    ("skin_srgb_from_linear", "light"): rgb(-0.1, 1.1),
}
"""Exceptions: parameters of another type or range under the same name."""


def drawn(signature, seed):
    """Return the values of one batch by name, rounded to float32, which shaders read."""
    rng = np.random.default_rng(seed)
    values = {}
    for parameter in signature.parameters:
        if parameter.kind not in ("lut", "tex2d"):
            draw = BY_FUNCTION.get((signature.name, parameter.name), VALUES[parameter.name])
            values[parameter.name] = draw(rng).astype(np.float32).astype(np.float64)
    return values
