"""Errors and warnings of Khronos' glTF validator, by code."""

from __future__ import annotations

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

from gpu_device import absent, tool_or_skip

MODULE = Path(sys.prefix, "lib", "gltf-validator", "node_modules", "gltf-validator")
"""Folder into which tools/gltf_validator_tool.py installs the validator."""
SEVERITIES = {0: "error", 1: "warning"}


def validator_messages(*files: Path) -> list[Counter[str]]:
    """Return the number of errors and warnings of each file, by code; hints do not count."""
    node = tool_or_skip("node")
    if not MODULE.is_dir():
        absent("Khronos' glTF validator is not installed; see tools/gltf_validator_tool.py")
    script = Path(__file__).with_suffix(".js")
    process = subprocess.run(
        [node, str(script), str(MODULE)],
        input=json.dumps([str(file) for file in files]),
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
        check=False,
    )
    assert process.returncode == 0, process.stderr
    return [_severe(report) for report in json.loads(process.stdout)]


def _severe(report: dict[str, object]) -> Counter[str]:
    if "failure" in report:
        return Counter([f"error: {report['failure']}"])
    return Counter(
        f"{SEVERITIES[message['severity']]}: {message['code']}"
        for message in report["issues"]["messages"]
        if message["severity"] in SEVERITIES
    )


def assert_valid(*files: Path) -> None:
    """Assert that no file has an error or a warning."""
    counts = zip(files, validator_messages(*files), strict=True)
    faults = {file.name: dict(messages) for file, messages in counts if messages}
    assert not faults, str(faults)
