"""PLY files with any elements, properties and format, from Python values."""

import numpy as np

PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"}
PLY_TYPES |= {"int8": "i1", "int16": "i2", "int32": "i4", "int64": "i8"}
PLY_TYPES |= {"uint8": "u1", "uint16": "u2", "uint32": "u4", "uint64": "u8"}
PLY_TYPES |= {"float": "f4", "double": "f8", "float32": "f4", "float64": "f8"}
LITTLE, BIG = "binary_little_endian", "binary_big_endian"
POSITION = ["float x", "float y", "float z"]
INDICES = ["list uchar int vertex_indices"]


def ply_bytes(elements, form="ascii", comments=(), line_end="\n"):
    """Return the bytes of a PLY file.

    Parameters
    ----------
    elements
        Properties and rows by the name of the element. A property is text such as ``float x`` or ``list
        uchar int vertex_indices``; a row has a number or a sequence for every property.
    form
        Name of the format.
    comments
        Comments of the header.
    line_end
        Line end of the header, and of the rows of text.
    """
    header = ["ply", f"format {form} 1.0", *(f"comment {comment}" for comment in comments)]
    body = []
    for name, (properties, rows) in elements.items():
        header.append(f"element {name} {len(rows)}")
        header += [f"property {entry}" for entry in properties]
        for row in rows:
            values = []
            for entry, value in zip(properties, row, strict=True):
                *types, _ = entry.removeprefix("list ").split()
                if entry.startswith("list "):
                    values.append((types[0], len(value)))
                    value = list(value)
                else:
                    value = [value]
                values += [(types[-1], number) for number in value]
            body.append(_row(values, form, line_end))
    return line_end.join([*header, "end_header", ""]).encode() + b"".join(body)


def _row(values, form, line_end):
    if form == "ascii":
        return (" ".join(f"{number!r}" for _, number in values) + line_end).encode()
    order = ">" if form == BIG else "<"
    return b"".join(
        np.array(number, order + PLY_TYPES[type_]).tobytes() for type_, number in values
    )
