"""Charts of the texture coordinates: where the head is cut, and the starting point of flattening.

The charts are the head (cut along the back up to the crown), the front and the back of each ear, and the
underside of the bust. Flattening starts from Tutte's embedding and minimizes the symmetric Dirichlet
energy, whose barrier prevents flipped triangles. Rest triangles are enlarged on the face, which so gets
more texels.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.sparse.linalg import spsolve

from .ear import ear, frame, to_ear
from .fields import Array, ramp
from .head import rest_of_head
from .mesh import Faces, face_normals, unit

HEAD, EAR_FRONT, EAR_BACK, BASE = 0, 1, 3, 5  # ear charts: left (+X); add 1 for right


def _neighbours(faces: Faces) -> Faces:
    """Return pairs ``(E, 2)`` of faces that share an edge."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(faces)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    e, o = edges[order], owner[order]
    same = np.all(e[1:] == e[:-1], axis=1)
    return np.stack([o[:-1][same], o[1:][same]], axis=1)


def label_faces(vertices: Array, faces: Faces) -> Faces:
    """Return the chart number ``(F,)`` of every face; every chart is connected."""
    middle = vertices[faces].mean(axis=1)
    normal = unit(face_normals(vertices, faces))
    pairs = _neighbours(faces)
    n = len(faces)
    ring = csr_matrix(
        (np.ones(2 * len(pairs)), (pairs.ravel(), pairs[:, ::-1].ravel())), shape=(n, n)
    )

    def soften(value: Array, rounds: int) -> Array:
        for _ in range(rounds):
            value = 0.4 * value + 0.2 * np.asarray(ring @ value)
        return value

    e = to_ear(middle)
    lean = np.abs(ear(middle)) - np.abs(rest_of_head(middle))
    bowl = (np.hypot((e[:, 0] - 7.0) / 11.0, (e[:, 1] + 2.0) / 16.0) < 1.0) & (e[:, 2] > -16.0)
    side = np.abs(middle[:, 0]) > 62.0
    facing = normal * np.where(middle[:, :1] < 0.0, [-1.0, 1.0, 1.0], [1.0, 1.0, 1.0])
    out_of_plane = facing @ frame()[2]
    own = np.where(bowl & (out_of_plane > -0.2), -2.0, np.clip(lean, -2.0, 2.0))
    own = np.where(side, own, 2.0)
    is_ear = soften(own, 4) < -0.15
    turned = soften(out_of_plane, 4) < -0.12
    label = np.zeros(n, dtype=np.int64)
    right = (middle[:, 0] < 0.0).astype(np.int64)
    label[is_ear & ~turned] = (EAR_FRONT + right)[is_ear & ~turned]
    label[is_ear & turned] = (EAR_BACK + right)[is_ear & turned]
    under = soften(np.where(middle[:, 1] < -150.0, normal[:, 1], 1.0), 3) < -0.55
    label[under] = BASE
    return _connected(label, pairs)


def _connected(label: Faces, pairs: Faces) -> Faces:
    """Return the labels after every island has joined the chart around it."""
    n = len(label)
    for _ in range(8):
        same = pairs[label[pairs[:, 0]] == label[pairs[:, 1]]]
        graph = csr_matrix((np.ones(len(same)), (same[:, 0], same[:, 1])), shape=(n, n))
        count, piece = connected_components(graph, directed=False)
        size = np.bincount(piece)
        chart_of = np.zeros(count, dtype=np.int64)
        chart_of[piece] = label
        biggest = np.zeros(count, dtype=bool)
        for chart in np.unique(chart_of):
            members = np.flatnonzero(chart_of == chart)
            biggest[members[np.argmax(size[members])]] = True
        if biggest.all():
            return label
        votes = np.zeros((count, 6))
        for a, b in ((0, 1), (1, 0)):
            face, neighbour = pairs[:, a], pairs[:, b]
            crossing = piece[face] != piece[neighbour]
            np.add.at(votes, (piece[face[crossing]], label[neighbour[crossing]]), 1.0)
        votes[np.arange(count), chart_of] = -1.0
        island = ~biggest[piece]
        label = np.where(island, np.argmax(votes, axis=1)[piece], label)
    return label


def boundary_loops(faces: Faces) -> list[Faces]:
    """Return the closed loops of boundary vertices, longest first, oriented as the faces are."""
    half = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    directed = {(int(a), int(b)) for a, b in half}
    successors: dict[int, list[int]] = {}
    for a, b in sorted(directed):
        if (b, a) not in directed:
            successors.setdefault(a, []).append(b)
    loops = []
    while successors:
        start = min(successors)
        loop = [start]
        while True:
            targets = successors[loop[-1]]
            step = targets.pop()
            if not targets:
                del successors[loop[-1]]
            if step == start:
                break
            loop.append(step)
        loops.append(np.array(loop))
    return sorted(loops, key=len, reverse=True)


def cut_up_the_back(vertices: Array, faces: Faces) -> tuple[Faces, Faces]:
    """Cut a chart along the midline of the back, from its lower rim to the crown.

    Returns
    -------
    faces, source
        The faces with new vertex numbers, and the original vertex of every number.
    """
    rim = np.concatenate(boundary_loops(faces))
    low = rim[vertices[rim, 1] < -90.0]
    start = low[np.argmax(-vertices[low, 2] - 3.0 * np.abs(vertices[low, 0]))]
    end = np.argmin(np.linalg.norm(vertices - np.array([0.0, 114.0, 2.0]), axis=1))
    edges = np.unique(np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
    off = np.abs(a[:, 0]) + np.abs(b[:, 0]) + 50.0 * ((a[:, 2] > 20.0) | (b[:, 2] > 20.0))
    on_rim = np.isin(edges, rim).any(axis=1) & ~np.isin(edges, [start]).any(axis=1)
    cost = np.linalg.norm(a - b, axis=1) * (1.0 + 0.15 * off + 1e3 * on_rim)
    n = len(vertices)
    graph = coo_matrix((cost, (edges[:, 0], edges[:, 1])), shape=(n, n)).tocsr()
    _, before = dijkstra(graph, directed=False, indices=np.array([start]), return_predecessors=True)
    path = [int(end)]
    while path[-1] != start:
        path.append(int(before[0, path[-1]]))
    path.reverse()
    # Faces to the left of the path get copies of its vertices.
    new_faces = faces.copy()
    source = list(range(n))
    around: dict[int, list[int]] = {}
    for number, face in enumerate(faces):
        for v in face:
            around.setdefault(int(v), []).append(number)
    on_path = {frozenset(e) for e in pairwise(path)}
    for k, v in enumerate(path[:-1]):
        fan = around[v]
        following = path[k + 1]
        # the face to the left of the directed edge from v to the next vertex
        seed = next(
            t
            for t in fan
            if any(faces[t][i] == v and faces[t][(i + 1) % 3] == following for i in range(3))
        )
        chosen, queue = {seed}, [seed]
        while queue:
            t = queue.pop()
            for u in fan:
                if u in chosen:
                    continue
                shared = set(map(int, faces[t])) & set(map(int, faces[u]))
                if len(shared) == 2 and v in shared and frozenset(shared) not in on_path:
                    chosen.add(u)
                    queue.append(u)
        fresh = len(source)
        source.append(v)
        for t in chosen:
            new_faces[t][faces[t] == v] = fresh
    return new_faces, np.array(source)


def texel_scale(p: Array) -> Array:
    """Return the enlargement of the texture at points ``(N, 3)``: 1.6 on the face, 0.8 at the back."""
    front = ramp(p[:, 2], -10.0, 70.0) * ramp(p[:, 1], -150.0, -112.0) * ramp(p[:, 1], 115.0, 60.0)
    return np.asarray(0.78 + 0.85 * front)


def close_holes(p: Array, faces: Faces) -> tuple[Array, Faces]:
    """Return points and faces with all but the longest boundary closed by cones.

    A closed hole cannot fold over in the flat chart. The tip of a cone is 12 mm away from the middle of
    the hole, so that the cone's area keeps the flat hole wide enough for the padding.
    """
    tips, extra = [], []
    for loop in boundary_loops(faces)[1:]:
        middle = p[loop].mean(axis=0)
        tips.append(middle + np.array([np.sign(middle[0]) * 12.0, 0.0, 0.0]))
        hub = np.full(len(loop), len(p) + len(tips) - 1)
        extra.append(np.stack([np.roll(loop, -1), loop, hub], axis=1))
    if not extra:
        return p, faces
    return np.concatenate([p, np.array(tips)]), np.concatenate([faces, *extra])


def tutte(faces: Faces, count: int) -> Array:
    """Return the harmonic embedding ``(count, 2)`` of a disc into the unit circle."""
    i, j = faces[:, [0, 1, 2]].ravel(), faces[:, [1, 2, 0]].ravel()
    pairs = np.unique(np.sort(np.stack([i, j], axis=1), axis=1), axis=0)
    i, j = pairs.ravel(), pairs[:, ::-1].ravel()
    links = csr_matrix((np.ones(len(i)), (i, j)), shape=(count, count))
    outer = boundary_loops(faces)[0]
    angle = 2.0 * np.pi * np.arange(len(outer)) / len(outer)
    uv = np.zeros((count, 2))
    uv[outer] = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    free = np.setdiff1d(np.arange(count), outer)
    degree = np.asarray(links.sum(axis=1)).ravel()
    lap = csr_matrix((degree, (range(count), range(count)))) - links
    uv[free] = np.asarray(spsolve(lap[free][:, free].tocsc(), -(lap[free][:, outer] @ uv[outer])))
    return uv
