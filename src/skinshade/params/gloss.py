"""Gloss and roughness: two scales of the width of a specular lobe."""

from __future__ import annotations

import numpy as np

from .._core.arrays import FloatArray

__all__ = ["POWER_OCTAVES", "alpha_from_gloss", "gloss_from_roughness"]

POWER_OCTAVES = 13.0
"""Binary logarithm of the Blinn-Phong power at gloss 1: 2¹³ is about the sharpest highlight of an 8-bit gloss
map [Lagarde2011]."""


def gloss_from_roughness(roughness: FloatArray | float) -> FloatArray:
    """Return the gloss (...) whose lobe is as wide as the GGX lobe of a roughness r (...), 0..1.

    The Blinn-Phong power of this lobe is 2/r⁴ − 2 [Walter2007].

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.params.gloss import gloss_from_roughness
    >>> gloss_from_roughness(np.array([0.2, 0.45, 1.0])).round(3)
    array([0.791, 0.427, 0.   ])
    """
    power = 2.0 / np.maximum(np.asarray(roughness, dtype=np.float64), 1e-3) ** 4 - 2.0
    result: FloatArray = np.clip(np.log2(np.maximum(power, 1.0)) / POWER_OCTAVES, 0.0, 1.0)
    return result


def alpha_from_gloss(gloss: FloatArray) -> FloatArray:
    """Return α (...), the squared roughness of the GGX lobe as wide as that of a gloss (...), 0..1.

    With the Blinn-Phong power p = 2^(13·gloss), α² = 2/(p + 2) [Walter2007]: .816 at gloss 0, and .0156 at
    gloss 1. The function is the inverse of `gloss_from_roughness` between these roughnesses.

    Examples
    --------
    >>> import numpy as np
    >>> from skinshade.params.gloss import alpha_from_gloss, gloss_from_roughness
    >>> alpha_from_gloss(gloss_from_roughness(np.array([0.2, 0.45, 0.9]))).round(4)
    array([0.04  , 0.2025, 0.81  ])
    """
    result: FloatArray = np.sqrt(2.0 / (np.exp2(POWER_OCTAVES * gloss) + 2.0))
    return result
