"""Run the tests with the lowest version of every dependency that pyproject.toml allows.

Run as ``python tools/lowest_versions.py FOLDER [pytest arguments]``; a virtual environment is created in
FOLDER. Libraries for the tests alone have their newest versions.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
REQUIREMENT = re.compile(r"^([\w.-]+)>=([\w.]+)")


def lowest(requirements: list[str]) -> list[str]:
    """Return every requirement with a lower bound, pinned to this bound."""
    matches = [REQUIREMENT.match(requirement) for requirement in requirements]
    return [f"{match[1]}=={match[2]}" for match in matches if match]


def main() -> None:
    """Create the environment and run the tests; exit with the code of pytest."""
    folder, *arguments = sys.argv[1:]
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    venv.create(folder, with_pip=True, clear=True)
    scripts = Path(folder).resolve() / ("Scripts" if sys.platform == "win32" else "bin")
    constraints = Path(folder) / "constraints.txt"
    constraints.write_text("\n".join(lowest(project["dependencies"])) + "\n", encoding="utf-8")
    pip = [str(scripts / "python"), "-P", "-m", "pip", "install", "--quiet"]
    options = ["--disable-pip-version-check", "--constraint", str(constraints)]
    subprocess.run([*pip, *options, "--editable", f"{ROOT}[dev]"], check=True)
    command = [str(scripts / "python"), "-m", "pytest", "-n", "auto", *arguments]
    sys.exit(subprocess.run(command, cwd=ROOT).returncode)


if __name__ == "__main__":
    main()
