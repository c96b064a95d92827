"""``python -m skinshade.codegen``: make ``shaders/generated`` anew."""

from .build import write

for name in write():
    print(f"wrote {name}")
