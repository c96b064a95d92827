"""The one tree of exceptions.

::

    SkinshadeError                     exit code 1
    ├── InputError                     exit code 2: the input or the request is at fault
    │   ├── ArgumentError              a value out of its range or shape (also a ValueError)
    │   │   └── UnitError              a length whose unit is unknown or absurd
    │   ├── FileError                  a file that is missing, unreadable or corrupt
    │   │   ├── MeshFileError
    │   │   ├── ImageFileError
    │   │   ├── LutFileError
    │   │   └── SceneFileError
    │   ├── MeshError                  a mesh that no repair can make usable
    │   ├── ShaderError                a user's shader that cannot be bound
    │   └── OutputError                a place that cannot be written
    ├── BackendError                   no device to render with, or it was lost
    ├── DependencyError                an optional library that is not installed (also an ImportError)
    ├── DownloadError                  an asset that could not be fetched, or has a wrong hash
    └── CompilerError                  a shader source that cannot be translated; at build time only

A message names the file or the argument, the index and the value at fault, and what to do.
"""

__all__ = [
    "ArgumentError",
    "BackendError",
    "CompilerError",
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
    "UnitError",
    "UnitWarning",
]


class SkinshadeError(Exception):
    """The root of everything that skinshade raises on purpose."""

    exit_code = 1


class InputError(SkinshadeError):
    """The input or the request is at fault."""

    exit_code = 2


class ArgumentError(InputError, ValueError):
    """A value has a wrong shape, type or range."""


class UnitError(ArgumentError):
    """A length has no known unit, or one that cannot be meant."""


class FileError(InputError):
    """A file is missing, unreadable or corrupt."""


class MeshFileError(FileError):
    """A mesh file cannot be read as what its name says it is."""


class ImageFileError(FileError):
    """An image file cannot be read as what its name says it is."""


class LutFileError(FileError):
    """A lookup table's file lacks its table or the description of its axes."""


class SceneFileError(FileError):
    """A scene description lacks a field or has one of a wrong type."""


class MeshError(InputError):
    """A mesh that no documented repair can make usable."""


class ShaderError(InputError):
    """A user's shader declares something of ours otherwise than it is, or lacks it."""


class OutputError(InputError):
    """A file or folder that cannot be written."""


class BackendError(SkinshadeError):
    """There is no device to render with, or it was lost."""


class DependencyError(SkinshadeError, ImportError):
    """An optional library is not installed."""


class DownloadError(SkinshadeError):
    """An asset could not be fetched, or is not the one that was promised."""


class CompilerError(SkinshadeError):
    """The shader compiler is not there, or refused a source; at build time only."""


class UnitWarning(UserWarning):
    """A unit that a file's standard prescribes makes the object implausibly large or small."""
