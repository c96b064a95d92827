"""The renderer on a GPU, built on `skinshade.gpu` as an outside engine would be."""
