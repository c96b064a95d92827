"""``python -m codegen``: write ``src/skinshade/shading/generated`` and the generated files of ``docs``."""

from .build import write

for name in write():
    print(f"wrote {name}")
