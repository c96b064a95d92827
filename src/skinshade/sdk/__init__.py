"""The shader package for engines: library, constant blocks, tables, C header and a guide, in one folder."""

from .export import LANGUAGES, export_shaders

__all__ = ["LANGUAGES", "export_shaders"]
