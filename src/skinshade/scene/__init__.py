"""Scenes: camera, lights, environment and material, and their description in JSON."""

from .camera import Camera
from .environment import Environment
from .json import load_scene
from .lights import DirectionalLight, Light, SpotLight
from .material import Material
from .part import Part
from .scene import Scene
from .sun import split_sun

__all__ = [
    "Camera",
    "DirectionalLight",
    "Environment",
    "Light",
    "Material",
    "Part",
    "Scene",
    "SpotLight",
    "load_scene",
    "split_sun",
]
