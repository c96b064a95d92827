"""Tree of exceptions.

::

    SkinshadeError                     exit code 1
    ├── InputError                     exit code 2: the input or the request is at fault
    │   ├── ArgumentError              a value of a wrong type, shape or range (also a ValueError)
    │   │   └── UnitError              a unit of length that is unknown or implausible
    │   ├── FileError                  a file that is missing, unreadable or corrupt
    │   │   ├── MeshFileError
    │   │   ├── ImageFileError
    │   │   ├── LutFileError
    │   │   └── SceneFileError
    │   ├── MeshError                  a mesh that no repair can make usable
    │   ├── ShaderError                a user's shader that does not match the library
    │   └── OutputError                a file or folder that cannot be written
    ├── BackendError                   no device to render with, or a lost one
    ├── DependencyError                an optional library that is not installed (also an ImportError)
    └── DownloadError                  an asset that could not be downloaded, or has a wrong hash

A message names the file or the argument, the index and the value at fault, and what to do. Parts of it come
from files: characters that are unsafe to display become escapes, and a long message loses its middle.
"""

from .text import printable, shortened

__all__ = [
    "ArgumentError",
    "AssetWarning",
    "BackendError",
    "DependencyError",
    "DownloadError",
    "FileError",
    "ImageFileError",
    "InputError",
    "LutFileError",
    "MeshError",
    "MeshFileError",
    "OutputError",
    "SceneFileError",
    "ShaderError",
    "SkinshadeError",
    "SkinshadeWarning",
    "UnitError",
    "UnitWarning",
]

LONGEST_MESSAGE = 1000
"""Most characters of a message: about ten lines of a terminal."""


def _displayable(message: str, longest: int, keep: str = "") -> str:
    text = printable(shortened(str(message), longest), keep)
    return shortened(text, longest)  # replacements are longer than the characters


class SkinshadeError(Exception):
    """Base class of all errors that skinshade raises.

    Parameters
    ----------
    message
        Text to display.
    """

    exit_code = 1
    longest_message = LONGEST_MESSAGE
    line_breaks = ""
    """Unsafe characters that stay in a message."""

    def __init__(self, message: str = "") -> None:
        super().__init__(_displayable(message, self.longest_message, self.line_breaks))


class InputError(SkinshadeError):
    """The input or the request is at fault."""

    exit_code = 2


class ArgumentError(InputError, ValueError):
    """A value has a wrong shape, type or range."""


class UnitError(ArgumentError):
    """A unit of length is unknown or implausible."""


class FileError(InputError):
    """A file is missing, unreadable or corrupt."""


class MeshFileError(FileError):
    """A mesh file is missing or damaged, or has another format than its suffix says."""


class ImageFileError(FileError):
    """An image file is missing or damaged, or has another format than its suffix says."""


class LutFileError(FileError):
    """The file of a lookup table is missing or damaged, or lacks the description of its axes."""


class SceneFileError(FileError):
    """A scene file is missing or does not follow the schema."""


class MeshError(InputError):
    """A mesh is unusable, and no documented repair applies."""


class ShaderError(InputError):
    """A user's shader does not compile, or its declarations differ from the library's."""

    longest_message = 100_000  # the log of a compiler
    line_breaks = "\n\t"


class OutputError(InputError):
    """A file or folder cannot be written."""


class BackendError(SkinshadeError):
    """No device to render with is available, or the device was lost."""


class DependencyError(SkinshadeError, ImportError):
    """An optional library is not installed."""


class DownloadError(SkinshadeError):
    """An asset could not be downloaded, or its hash is wrong."""


class SkinshadeWarning(UserWarning):
    """Base class of all warnings of skinshade, which the program prints.

    Parameters
    ----------
    message
        Text to display.
    """

    def __init__(self, message: str = "") -> None:
        super().__init__(_displayable(message, LONGEST_MESSAGE))


class AssetWarning(SkinshadeWarning):
    """A part of an asset cannot be used, and the result is made without it."""


class UnitWarning(SkinshadeWarning):
    """The unit of a file makes the object implausibly large or small."""
