"""Build hook: compiles the native kernels into the wheel, or next to their sources for editable installs.

Where nothing compiles them, the package is installed without them and uses NumPy. Environment variables:
``SKINSHADE_WHEEL_TARGET`` cross-compiles for a target of tools/native_library.py, and
``SKINSHADE_REQUIRE_NATIVE=1`` turns a failure into an error.
"""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


def _tool(root: str) -> ModuleType:
    """Return tools/native_library.py as a module."""
    path = Path(root) / "tools" / "native_library.py"
    spec = importlib.util.spec_from_file_location("native_library", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    spec.loader.exec_module(module)
    return module


class NativeKernels(BuildHookInterface[Any]):
    """Hook of hatchling that adds the library to a wheel."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        """Return the compiler package where the system has no C compiler."""
        if self.target_name != "wheel":
            return []
        tool = _tool(self.root)
        needed = tool.system_compiler() is None or os.environ.get(tool.WHEEL_TARGET)
        return [tool.ZIG_REQUIREMENT] if needed else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the library before a wheel is built."""
        if self.target_name != "wheel":
            return
        tool = _tool(self.root)
        name = os.environ.get(tool.WHEEL_TARGET)
        folder = tool.sources_module().FOLDER
        self._scratch = None if version == "editable" else tempfile.mkdtemp()
        try:
            library, tag = tool.build_for_wheel(name, Path(self._scratch or folder))
        except (tool.NoCompilerError, subprocess.CalledProcessError, OSError) as error:
            if os.environ.get("SKINSHADE_REQUIRE_NATIVE") == "1":
                raise
            detail = getattr(error, "stderr", None) or error
            self.app.display_warning(f"skinshade is built without compiled kernels: {detail}")
            return
        if version == "editable":
            return
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{tag}"
        build_data["force_include"][str(library)] = f"skinshade/_core/native/{library.name}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove the intermediate folder."""
        if getattr(self, "_scratch", None):
            shutil.rmtree(self._scratch, ignore_errors=True)
