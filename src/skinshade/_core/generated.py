"""Reader of the generated shader texts, which are committed: no user needs the Slang compiler."""

from __future__ import annotations

from importlib.resources import files

__all__ = ["generated_text"]


def generated_text(name: str) -> str:
    """Return the text of a file in ``shading/generated``.

    Parameters
    ----------
    name
        File name, such as ``skin.wgsl``.
    """
    return files("skinshade").joinpath("shading", "generated", name).read_text(encoding="utf-8")
