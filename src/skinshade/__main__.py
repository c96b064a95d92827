"""``python -m skinshade``."""

import sys

# Python puts the current folder first, where any file could have the name of a module.
if not sys.flags.safe_path:
    del sys.path[0]

from .cli import main

main()
