"""Enumerations that Python and shaders share: each member has a name, and a number in shaders.

Code generation writes the numbers into ``shading/generated/passes.slang``, so they are defined only here.
"""

from __future__ import annotations

from .._core.choice import Choice

__all__ = [
    "SHADER_CHOICES",
    "TERM_VIEWS",
    "AmbientForm",
    "Antialiasing",
    "Boundary",
    "MaterialMap",
    "PresentStage",
    "Shading",
    "ShadowFilter",
    "SpecularModel",
    "Tier",
    "ToneCurve",
    "View",
]


class Shading(Choice):
    """Lighting model: no scattering, the system of 2014, or the transfer model of skinshade."""

    LAMBERT = "lambert"
    CLASSIC = "classic"
    TRANSFER = "transfer"


class Tier(Choice):
    """Geometry that `Shading.TRANSFER` uses: mean curvature, shape operator, or diffused normals.

    Examples
    --------
    >>> from skinshade.params.choices import Tier
    >>> Tier.TENSOR == "tensor", Tier.TENSOR.number
    (True, 1)
    """

    SCALAR = "scalar"
    TENSOR = "tensor"
    DIFFUSED_NORMALS = "diffused-normals"


class AmbientForm(Choice):
    """Light of the sky at the vertices: that of the sky itself, or of its harmonics of order 2 or 4.

    Harmonics remain valid when the sky turns; order 2 has the 9 numbers that most engines have.
    """

    STATIC = "static"
    ORDER_2 = "order-2"
    ORDER_4 = "order-4"

    @property
    def order(self) -> int:
        """Greatest band of the harmonics of the sky that the form needs."""
        return 4 if self is AmbientForm.ORDER_4 else 2


class SpecularModel(Choice):
    """Specular lobes: one of GGX, two of GGX, or the two Blinn-Phong lobes that `Shading.CLASSIC` uses."""

    GGX = "ggx"
    GGX_TWO_LOBES = "ggx-two-lobes"
    BLINN_PHONG = "blinn-phong"


class Boundary(Choice):
    """Boundary through which scattered light leaves: a smooth one, or that of Blender's skin closure."""

    SMOOTH = "smooth"
    BLENDER_SKIN = "blender-skin"


class ShadowFilter(Choice):
    """Method of the wide shadow filter."""

    PERCENTAGE_CLOSER = "percentage-closer"
    VARIANCE = "variance"


class Antialiasing(Choice):
    """Antialiasing: shading of every sample (supersampling), or once per pixel (multisampling)."""

    SUPERSAMPLING = "supersampling"
    MULTISAMPLING = "multisampling"


class View(Choice):
    """Content of an image: the light, a property of the surface, or one term of the light."""

    PICTURE = "picture"
    NORMAL = "normal"
    BLURRED_NORMAL = "blurred-normal"
    CURVATURE = "curvature"
    THICKNESS = "thickness"
    SHADOW = "shadow"
    ALBEDO = "albedo"
    DIRECT = "direct"
    DEEP_SCATTER = "deep-scatter"
    SPECULAR = "specular"
    AMBIENT = "ambient"
    AMBIENT_DEEP_SCATTER = "ambient-deep-scatter"
    AMBIENT_SPECULAR = "ambient-specular"

    @property
    def is_term(self) -> bool:
        """Whether the view is one term of the light, as radiance."""
        return self in TERM_VIEWS

    @property
    def is_light(self) -> bool:
        """Whether the view is light, to which the scene's tone curve applies."""
        return self is View.PICTURE or self.is_term


TERM_VIEWS = {
    View.DIRECT: "direct",
    View.DEEP_SCATTER: "deep_scatter",
    View.SPECULAR: "specular",
    View.AMBIENT: "ambient",
    View.AMBIENT_DEEP_SCATTER: "ambient_deep_scatter",
    View.AMBIENT_SPECULAR: "ambient_specular",
}
"""Name in `skinshade.shading.compose.TERMS` of the term that each view shows."""


class MaterialMap(Choice):
    """Texture maps of a material."""

    ALBEDO = "albedo"
    SPECULAR = "specular"
    DEEP_SCATTER = "deep_scatter"
    NORMAL = "normal"

    @property
    def bit(self) -> int:
        """Bit of the map in the constant ``MAPS`` of the skin pass."""
        return 1 << self.number


class ToneCurve(Choice):
    """Curve from linear light to display values."""

    SRGB = "srgb"
    FILMIC = "filmic"


class PresentStage(Choice):
    """Step of the present pass: add a sample to the sum, or write the image in one of three encodings."""

    SUM = "sum"
    LINEAR = "linear"
    SRGB = "srgb"
    FILMIC = "filmic"


SHADER_CHOICES: dict[str, type[Choice]] = {
    "SHADING": Shading,
    "TIER": Tier,
    "SHADOW_FILTER": ShadowFilter,
    "SPECULAR": SpecularModel,
    "BOUNDARY": Boundary,
    "VIEW": View,
    "STAGE": PresentStage,
}
"""Enumerations whose numbers shaders use, by the prefix of the constants in shaders."""
