"""The specification: every term of the skin model as pure functions of arrays, float64.

One file a term, under the name that the term bears in every shading language:
`normals`, `direct`, `shadow`, `ambient`, `deep_scatter`, `specular`, `image_light`, `tonemap`, `classic`
(the formulas of 2014), and `compose`, the whole pixel. Arrays broadcast over leading axes; directions
are unit vectors that point away from the surface; light is radiance, in units in which a white Lambert
surface that faces a light of irradiance π has radiance 1.
"""
