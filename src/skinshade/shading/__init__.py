"""The lighting model: NumPy functions, which specify it, beside their twins for shaders.

A term of the model has one name in every layer: `normals`, `direct`, `energy`, `view_factor`, `shadow`,
`ambient`, `deep_scatter`, `specular`, `coat`, `image_light`, `tonemap`, `eye`, `eye_light`, `eye_lids`, and
`classic` for the formulas of 2014. The file ``<term>.py`` holds NumPy functions, which compute in float64.
The file ``<term>.slang`` holds the same functions for shaders; ``generated`` holds their translations into
other languages. `pixel` defines the inputs of a pixel, `compose` evaluates all terms, `lobes` selects the
specular lobes, `tables` builds lookup tables, and `skin` combines the profile, the parameters and the tables
of a material.

Arrays broadcast over leading axes. Directions are unit vectors that point away from the surface. A white
Lambert surface that faces a light of irradiance π has radiance 1.
"""
