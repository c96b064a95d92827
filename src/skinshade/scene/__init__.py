"""What is drawn: camera, lights, environment, material, and the files that describe them."""

from .camera import Camera
from .environment import Environment
from .lights import DirectionalLight, Light, SpotLight
from .material import Material
from .scene import Scene, load_scene

__all__ = [
    "Camera",
    "DirectionalLight",
    "Environment",
    "Light",
    "Material",
    "Scene",
    "SpotLight",
    "load_scene",
]
