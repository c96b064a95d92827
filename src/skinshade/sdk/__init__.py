"""Shader package for engines: functions, constant blocks, tables, C header and a guide in one folder."""

from .export import export_shaders
from .languages import LANGUAGES, Language

__all__ = ["LANGUAGES", "Language", "export_shaders"]
