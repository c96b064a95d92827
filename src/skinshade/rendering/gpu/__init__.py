"""The GPU backend, built on `skinshade.gpu` as an outside engine would be."""
