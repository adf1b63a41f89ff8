"""Shells with openings cut through them: the lantern and the lock of a door."""

import functools

from meshes import Mesh, add, cross, mul, normalize, sub


def polygon(*corners):
    """Distance-like function of a convex polygon, corners counter-clockwise; negative inside."""
    edges = []
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        normal = normalize((y1 - y0, x0 - x1))
        edges.append((normal, normal[0] * x0 + normal[1] * y0))
    return lambda x, y: max(n[0] * x + n[1] * y - d for n, d in edges)


def circle(cx, cy, radius):
    return lambda x, y: ((x - cx) ** 2 + (y - cy) ** 2) ** 0.5 - radius


def carved(outer, inner, opening, columns, rows):
    """The shell between two surfaces without its openings: the mesh outside, and the one inside.

    `outer` and `inner` map (u, v) in the unit square to points, ∂u × ∂v points outwards;
    `opening(u, v)` is negative where the shell is cut away. The cuts' sides belong to the inside.
    """
    outer, inner, opening = (functools.lru_cache(None)(f) for f in (outer, inner, opening))
    crossings = {}

    def crossing(a, b):
        """Where `opening` changes its sign between two grid points, by bisection."""
        key = (min(a, b), max(a, b))
        if key not in crossings:
            low, high = key
            for _ in range(16):
                middle = mul(add(low, high), 0.5)
                if (opening(*middle) < 0) == (opening(*key[0]) < 0):
                    low = middle
                else:
                    high = middle
            crossings[key] = mul(add(low, high), 0.5)
        return crossings[key]

    def clip(corners):
        """The part of a triangle that stays, and the edge that cuts it, with what stays on its left."""
        part, cut = [], []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            stays = opening(*a) >= 0
            if stays:
                part.append(a)
            if stays != (opening(*b) >= 0):
                part.append(crossing(a, b))
                cut.insert(0 if stays else 1, part[-1])
        return part, cut

    outside, inside = Mesh(), Mesh()
    cuts = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = (((i + di) / columns, (j + dj) / rows)
                          for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)))
            for corners in ((a, b, c), (a, c, d)):
                part, cut = clip(corners)
                _fan(outside, [_vertex(outside, outer, 1, p) for p in part])
                _fan(inside, [_vertex(inside, inner, -1, p) for p in reversed(part)])
                if cut:
                    cuts.append(cut)
    _append_sides(inside, outer, inner, cuts)
    return outside, inside


def _vertex(mesh, surface, side, at):
    return mesh.vertex(surface(*at), mul(_normal(surface, at), side), at)


def _normal(surface, at):
    """By central differences."""
    (u, v), step = at, 1e-4
    return normalize(cross(sub(surface(u + step, v), surface(u - step, v)),
                           sub(surface(u, v + step), surface(u, v - step))))


def _fan(mesh, indices):
    for b, c in zip(indices[1:], indices[2:]):
        mesh.triangle(indices[0], b, c)


def _append_sides(mesh, outer, inner, cuts):
    normals = {}
    for p, q in cuts:
        if p == q:
            continue
        side = normalize(cross(sub(outer(*q), outer(*p)), _normal(outer, p)))
        for end in (p, q):
            normals[end] = add(normals.get(end, (0, 0, 0)), side)
    for p, q in cuts:
        if p == q:
            continue
        a, b, c, d = (mesh.vertex(surface(*end), normalize(normals[end]), end)
                      for surface, end in ((outer, p), (inner, p), (inner, q), (outer, q)))
        mesh.triangle(a, b, c)
        mesh.triangle(a, c, d)
