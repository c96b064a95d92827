"""Heads: the built-in head, models on disk, and public scans that are downloaded on request."""

from .builtin import builtin_head
from .downloads import SCANS, fetch_scan
from .head import Head
from .models import load_head
from .portrait import head_scene

__all__ = ["SCANS", "Head", "builtin_head", "fetch_scan", "head_scene", "load_head"]
