"""Parameters of an eye, and the constants of its placement in a scene."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._core.arrays import FloatVector
from .._core.errors import ArgumentError
from .fields import checked_fields, number
from .packing import pack

__all__ = ["EyeParams", "EyePlaceParams", "lid_plane"]

WIDE = 1e30
"""Limit of values that have no natural range; finite in float32."""
STEEPEST = 0.98
"""Greatest share of the radius at which a surface is still used; at 1 its slope is infinite."""
CANTHUS_RADIUS_MM = 12.5
"""Distance of the corners of the lids from the axis; the lids slide on a ball of this radius."""
CANTHUS_DEPTH_MM = 4.5
"""Height of the corners of the lids in front of the centre of the eye."""
UPPER_LID_MM, LOWER_LID_MM = 4.2, -5.6
"""Heights of the lids' margins above the axis, eyes straight: the upper lid hides 1.7 mm of the iris, the
lower lid touches the limbus."""


@dataclass(frozen=True)
class EyeParams:
    """Geometry and appearance of an eye, besides its maps; ranges are checked.

    The frame of an eye has its origin in the centre of the sclera, z along the gaze and y up. The metadata
    of each field holds its `skinshade.params.fields.Meaning`: unit, range, source.

    Raises
    ------
    ArgumentError
        If a field lies outside its range, or the cornea, the sclera, the iris and the pupil do not fit
        each other.

    Examples
    --------
    >>> import skinshade as sk
    >>> eye = sk.EyeParams()
    >>> round(eye.apex_mm, 2)
    12.99
    """

    iris_uv: tuple[float, float, float, float] = number(
        (0.5, 0.5, 0.5, 0.0),
        "1",
        -16.0,
        16.0,
        "Centre of the iris in its map, its radius there, and turns counterclockwise.",
    )
    sclera_radius_mm: float = number(12.0, "mm", 8.0, 16.0, "Radius of the sclera.")
    limbus_radius_mm: float = number(
        5.9,
        "mm",
        4.0,
        8.0,
        "Radius of the limbus, where cornea and sclera meet; half the white-to-white distance.",
        "Rufer2005",
    )
    limbus_width_mm: float = number(
        0.6, "mm", 0.1, 1.5, "Half the width of the blend between cornea and sclera."
    )
    cornea_radius_mm: float = number(
        7.8, "mm", 6.0, 10.0, "Radius of curvature at the apex of the cornea.", "LeGrand1980"
    )
    cornea_asphericity: float = number(
        -0.26, "1", -0.8, 0.3, "Asphericity Q of the cornea; 0 for a sphere.", "Navarro1985"
    )
    refraction_index: float = number(
        1.340,
        "1",
        1.0,
        1.6,
        "Index of the one refracting surface that replaces both surfaces of the cornea.",
    )
    tear_index: float = number(1.337, "1", 1.0, 1.6, "Index of tears, which reflect.", "Craig1995")
    aqueous_index: float = number(
        1.336, "1", 1.0, 1.6, "Index of the aqueous humour.", "LiouBrennan1997"
    )
    iris_depth_mm: float = number(
        3.55, "mm", 1.0, 6.0, "Depth of the iris behind the apex of the cornea, on the axis."
    )
    iris_slope: float = number(
        0.08, "1", -0.3, 0.3, "Fall of the iris with the distance from the axis; 0 for a plane."
    )
    iris_radius_mm: float = number(6.0, "mm", 3.0, 8.0, "Outer radius of the iris.")
    pupil_radius_mm: float = number(2.0, "mm", 0.5, 4.5, "Radius of the pupil.", "MoonSpencer1944")
    pupil_in_map: float = number(
        0.33, "1", 0.0, 0.9, "Radius of the pupil in the map of the iris, over that of the iris."
    )
    virtual_cornea: float = number(
        0.0, "1", 0.0, 1.0, "1 for a mesh without a bulge: rays meet the cornea itself."
    )
    cornea_roughness_deg: float = number(
        0.4, "deg", 0.1, 10.0, "Angle by which the cornea widens a reflection."
    )
    sclera_roughness_deg: float = number(
        6.0, "deg", 1.0, 20.0, "Angle by which the sclera widens a reflection."
    )
    sclera_normal_strength: float = number(
        1.0, "1", 0.0, 2.0, "Factor on the slopes of the normal map of the sclera."
    )
    meniscus_height_mm: float = number(
        0.2, "mm", 0.0, 0.7, "Height of the tears on the margins of the lids.", "Doughty2002"
    )
    iris_height_mm: float = number(
        0.0, "mm", 0.0, 0.3, "Height of the relief of the iris at 1 in its map."
    )

    def __post_init__(self) -> None:
        checked_fields(self)
        q = 1.0 + self.cornea_asphericity
        if q * self.limbus_radius_mm**2 > (STEEPEST * self.cornea_radius_mm) ** 2:
            raise ArgumentError(
                f"limbus_radius_mm is {self.limbus_radius_mm:g}, but a cornea with cornea_radius_mm"
                f" {self.cornea_radius_mm:g} and cornea_asphericity {self.cornea_asphericity:g} is not"
                " that wide; use a smaller limbus or a larger radius"
            )
        outer = self.limbus_radius_mm + self.limbus_width_mm
        if outer > STEEPEST * self.sclera_radius_mm:
            raise ArgumentError(
                f"limbus_radius_mm + limbus_width_mm is {outer:g}, but sclera_radius_mm is"
                f" {self.sclera_radius_mm:g}; the limbus must lie on the sclera"
            )
        if self.pupil_radius_mm >= self.iris_radius_mm:
            raise ArgumentError(
                f"pupil_radius_mm is {self.pupil_radius_mm:g}; it must be less than iris_radius_mm,"
                f" {self.iris_radius_mm:g}"
            )
        rim = self.apex_mm - self.iris_depth_mm - self.iris_slope * self.iris_radius_mm
        if np.hypot(self.iris_radius_mm, rim) > self.sclera_radius_mm:
            raise ArgumentError(
                f"the rim of the iris, {self.iris_radius_mm:g} mm from the axis and {rim:g} mm in front"
                f" of the centre, lies outside the sclera, whose radius is {self.sclera_radius_mm:g} mm;"
                " use a smaller iris_radius_mm or a greater iris_depth_mm"
            )

    @property
    def apex_mm(self) -> float:
        """Distance of the apex of the cornea from the centre of the sclera, mm."""
        r, radius = self.limbus_radius_mm, self.cornea_radius_mm
        root = np.sqrt(1.0 - (1.0 + self.cornea_asphericity) * (r / radius) ** 2)
        sag = r**2 / (radius * (1.0 + root))
        return float(np.sqrt(self.sclera_radius_mm**2 - r**2) + sag)

    @property
    def cornea(self) -> FloatVector:
        """Argument ``cornea`` (4,) of the functions: apex and radius, mm; asphericity; index."""
        return np.array(
            [self.apex_mm, self.cornea_radius_mm, self.cornea_asphericity, self.refraction_index]
        )

    @property
    def limbus(self) -> FloatVector:
        """Argument ``limbus`` (4,) of the functions: radius, half width, radius of the sclera, mm; 0."""
        return np.array([self.limbus_radius_mm, self.limbus_width_mm, self.sclera_radius_mm, 0.0])

    @property
    def iris(self) -> FloatVector:
        """Argument ``iris`` (4,) of the functions: height of the tip of the cone, mm; slope; radii, mm.

        The radii are those of the iris and of the pupil.
        """
        tip = self.apex_mm - self.iris_depth_mm
        return np.array([tip, self.iris_slope, self.iris_radius_mm, self.pupil_radius_mm])

    def pack(self) -> bytes:
        """Return the bytes of ``EyeBlock`` in the layout of ``shading/generated/layout.json``."""
        return pack("EyeBlock", self)


def lid_plane(
    height_mm: float, canthus_depth_mm: float = CANTHUS_DEPTH_MM
) -> tuple[float, float, float, float]:
    """Return the plane n, D of a lid whose margin crosses the middle of the eye at a height.

    The lid covers points P with n·P > D. The plane passes through both corners of the lids.

    Parameters
    ----------
    height_mm
        Height of the margin above the axis, −12..12 mm; that of an upper lid is positive, that of a lower
        lid negative.
    canthus_depth_mm
        Height of the corners in front of the centre of the eye, 0..8 mm.

    Raises
    ------
    ArgumentError
        If a value lies outside its range.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.params.eye import lid_plane
    >>> np.round(lid_plane(4.2), 3)
    array([ 0.   ,  0.866, -0.5  , -2.25 ])
    """
    for name, value, low, high in (
        ("height_mm", height_mm, -12.0, 12.0),
        ("canthus_depth_mm", canthus_depth_mm, 0.0, 8.0),
    ):
        if not low <= value <= high:
            raise ArgumentError(f"{name} is {value}; it must lie in [{low:g}, {high:g}] mm")
    y = abs(height_mm)
    angle = np.arctan2(y, np.sqrt(CANTHUS_RADIUS_MM**2 - y**2) - canthus_depth_mm)
    up = np.cos(angle) if height_mm >= 0.0 else -np.cos(angle)
    return 0.0, float(up), float(-np.sin(angle)), float(-canthus_depth_mm * np.sin(angle))


@dataclass(frozen=True)
class EyePlaceParams:
    """Placement of an eye in a scene, its lids, and the axes of its tables."""

    eye_x: tuple[float, float, float, float] = number(
        (1.0, 0.0, 0.0, 0.0),
        "1",
        -WIDE,
        WIDE,
        "Row x of the matrix from the world to mm of the eye.",
    )
    eye_y: tuple[float, float, float, float] = number(
        (0.0, 1.0, 0.0, 0.0),
        "1",
        -WIDE,
        WIDE,
        "Row y of the matrix from the world to mm of the eye.",
    )
    eye_z: tuple[float, float, float, float] = number(
        (0.0, 0.0, 1.0, 0.0),
        "1",
        -WIDE,
        WIDE,
        "Row z of the matrix from the world to mm of the eye.",
    )
    lid_upper: tuple[float, float, float, float] = number(
        lid_plane(UPPER_LID_MM),
        "1",
        -100.0,
        100.0,
        "Plane n, D (mm) that the upper lid lies beyond.",
    )
    lid_lower: tuple[float, float, float, float] = number(
        lid_plane(LOWER_LID_MM),
        "1",
        -100.0,
        100.0,
        "Plane n, D (mm) that the lower lid lies beyond.",
    )
    lamp_axes: tuple[float, float, float, float] = number(
        (-6.0 * 32.0 / 31.0, 31.0 / 384.0, 0.0, 1.0 / 256.0),
        "1",
        -1e6,
        1e6,
        "Axes of the table of a lamp: low and 1/(high − low) of the columns, mm, then of the rows.",
    )
    surroundings_axes: tuple[float, float, float, float] = number(
        (-3.0 / 31.0, 31.0 / 192.0, -0.5, 0.5),
        "1",
        -1e6,
        1e6,
        "Axes of the table of the surroundings: low and 1/(high − low) of the columns, mm, then of the"
        " rows.",
    )
    lid_radiance: tuple[float, float, float] = number(
        (0.0, 0.0, 0.0), "1", 0.0, WIDE, "Radiance of the inner sides of the lids."
    )
    lid_radius_mm: float = number(
        14.2, "mm", 8.0, 30.0, "Radius of the ball whose surface is the outer side of the lids."
    )

    def __post_init__(self) -> None:
        checked_fields(self)

    def pack(self) -> bytes:
        """Return the bytes of ``EyePlaceBlock`` in the layout of ``shading/generated/layout.json``."""
        return pack("EyePlaceBlock", self)
