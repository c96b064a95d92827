"""Pictures of scenes, by whichever backend there is.

The package bears the name of its one verb, and is called like it: ``skinshade.render(scene)``. Python
binds a submodule to its name in the parent, so a function of that name could not live beside it.
"""

import inspect
import sys
from types import ModuleType

from .renderer import DEBUG_VIEWS, RenderSettings, render

__all__ = ["DEBUG_VIEWS", "RenderSettings", "render"]


class _CallablePackage(ModuleType):
    __call__ = staticmethod(render)
    __signature__ = inspect.signature(render)


sys.modules[__name__].__class__ = _CallablePackage
