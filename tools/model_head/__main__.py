"""Model the built-in head: ``python tools/model_head -o src/skinshade/heads/assets/head.glb``."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np

if not __package__:
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from model_head.glb import write_glb
from model_head.head import gradient, head
from model_head.layout import unwrap
from model_head.mesh import evaluate, largest_component, polygonise, remesh, unit
from model_head.regions import regions


def main() -> None:
    """Build the head and write it."""
    parser = argparse.ArgumentParser(prog="model_head", description="Model the built-in head.")
    parser.add_argument("-o", "--output", type=Path, required=True, help="the .glb to write")
    parser.add_argument("--step-mm", type=float, default=0.8, help="cell size of marching cubes")
    parser.add_argument("--edge-scale", type=float, default=0.86, help="factor of edge lengths")
    options = parser.parse_args()
    vertices, faces = largest_component(*polygonise(head, options.step_mm))
    vertices, faces = remesh(vertices, faces, head, gradient, options.edge_scale)
    flat = unwrap(vertices, faces)
    normals = unit(evaluate(gradient, vertices))
    weights = regions(vertices, normals)
    size = write_glb(
        options.output,
        (vertices[flat.source] * 1e-3).astype(np.float32),
        normals[flat.source].astype(np.float32),
        flat.uv.astype(np.float32),
        np.rint(weights[flat.source] * 255.0).astype(np.uint8),
        flat.faces,
    )
    print(
        f"{options.output}: {len(vertices)} vertices ({len(flat.source)} with seams), "
        f"{len(faces)} triangles, {size} bytes"
    )


if __name__ == "__main__":
    main()
