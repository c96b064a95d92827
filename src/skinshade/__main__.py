"""``python -m skinshade``."""

from .cli.app import main

main()
