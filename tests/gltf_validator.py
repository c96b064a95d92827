"""What Khronos' glTF validator says of files: errors and warnings, by code and place."""

from __future__ import annotations

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

from gpu_device import absent, tool_or_skip

MODULE = Path(sys.prefix, "lib", "gltf-validator", "node_modules", "gltf-validator")
"""Where tools/gltf_validator_tool.py puts it."""
SEVERE = {0: "error", 1: "warning"}


def complaints(*files: Path) -> list[Counter[str]]:
    """Return how often each error and warning is told of each file; hints do not count."""
    node = tool_or_skip("node")
    if not MODULE.is_dir():
        absent("Khronos' glTF validator is not installed; see tools/gltf_validator_tool.py")
    script = Path(__file__).with_suffix(".js")
    ended = subprocess.run(
        [node, str(script), str(MODULE)],
        input=json.dumps([str(file) for file in files]),
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    assert ended.returncode == 0, ended.stderr
    return [_severe(report) for report in json.loads(ended.stdout)]


def _severe(report: dict[str, object]) -> Counter[str]:
    if "failure" in report:
        return Counter([f"error: {report['failure']}"])
    return Counter(
        f"{SEVERE[each['severity']]}: {each['code']}"
        for each in report["issues"]["messages"]
        if each["severity"] in SEVERE
    )


def assert_valid(*files: Path) -> None:
    """Every file is without an error and without a warning."""
    told = complaints(*files)
    found = {file.name: dict(each) for file, each in zip(files, told, strict=True) if each}
    assert not found, str(found)
