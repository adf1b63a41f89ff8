"""Triangle meshes and the few ways in which our scenes make them. Standard library only."""

import math
import struct


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def mul(a, s):
    return tuple(x * s for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalize(a):
    return mul(a, 1 / math.sqrt(dot(a, a)))


class Mesh:
    """Vertices are (position, normal, uv); triangles index them, counter-clockwise seen from outside."""

    def __init__(self):
        self.vertices = []
        self.triangles = []
        self._index_of = {}

    def vertex(self, position, normal, uv=(0, 0)):
        # `+ 0.0` turns a rounded -0.0 into 0.0, so that equal vertices are written equally.
        key = tuple(tuple(round(x, 6) + 0.0 for x in part) for part in (position, normal, uv))
        if key not in self._index_of:
            self._index_of[key] = len(self.vertices)
            self.vertices.append(key)
        return self._index_of[key]

    def triangle(self, a, b, c):
        if len({a, b, c}) == 3:
            self.triangles.append((a, b, c))

    def grid(self, rows):
        """Quads between rows of vertex indices."""
        for lower, upper in zip(rows, rows[1:]):
            for i in range(len(lower) - 1):
                self.triangle(lower[i], lower[i + 1], upper[i + 1])
                self.triangle(lower[i], upper[i + 1], upper[i])

    def quad(self, a, b, c, d):
        """Flat quadrilateral, counter-clockwise seen from outside; uv runs from a to c."""
        normal = normalize(cross(sub(b, a), sub(d, a)))
        corners = [self.vertex(p, normal, uv)
                   for p, uv in zip((a, b, c, d), ((0, 0), (1, 0), (1, 1), (0, 1)))]
        self.triangle(corners[0], corners[1], corners[2])
        self.triangle(corners[0], corners[2], corners[3])

    def append(self, other, offset):
        """Adds a copy of another mesh, moved by `offset`."""
        indices = [self.vertex(add(p, offset), n, uv) for p, n, uv in other.vertices]
        for triangle in other.triangles:
            self.triangle(*(indices[i] for i in triangle))

    def obj(self, comment):
        lines = [f"# {comment}"]
        lines += ["v {:g} {:g} {:g}".format(*p) for p, _, _ in self.vertices]
        lines += ["vt {:g} {:g}".format(*uv) for _, _, uv in self.vertices]
        lines += ["vn {:g} {:g} {:g}".format(*n) for _, n, _ in self.vertices]
        lines += ["f " + " ".join(f"{i + 1}/{i + 1}/{i + 1}" for i in t) for t in self.triangles]
        return ("\n".join(lines) + "\n").encode()

    def ply(self, comment):
        header = ["ply", "format binary_little_endian 1.0", f"comment {comment}",
                  f"element vertex {len(self.vertices)}"]
        header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz", "u", "v")]
        header += [f"element face {len(self.triangles)}", "property list uchar int vertex_indices",
                   "end_header", ""]
        body = b"".join(struct.pack("<8f", *p, *n, *uv) for p, n, uv in self.vertices)
        body += b"".join(struct.pack("<B3i", 3, *t) for t in self.triangles)
        return "\n".join(header).encode() + body


def rounded_box(size, radius, segments=4):
    """Axis-aligned box around the origin whose edges and corners are rounded.

    Each face is a patch of a cube-sphere; the patch is cut along its middle lines, and the parts are
    moved apart until the box has its size. uv runs over each face.
    """
    mesh = Mesh()
    inner = [0.5 * s - radius for s in size]
    angles = [(-1, -math.pi / 4 * (1 - i / segments)) for i in range(segments + 1)]
    angles += [(1, math.pi / 4 * i / segments) for i in range(segments + 1)]
    for axis in range(3):
        for sign in (-1, 1):
            u_axis, v_axis = (axis + 1) % 3, (axis + 2) % 3
            rows = []
            for v_side, v_angle in angles:
                row = []
                for u_side, u_angle in angles:
                    direction = [0.0] * 3
                    direction[axis] = 1.0
                    direction[u_axis], direction[v_axis] = math.tan(u_angle), math.tan(v_angle)
                    direction = list(normalize(direction))
                    direction[axis] *= sign
                    position = [radius * d for d in direction]
                    position[axis] += sign * inner[axis]
                    position[u_axis] += u_side * inner[u_axis]
                    position[v_axis] += v_side * inner[v_axis]
                    uv = (position[u_axis] / size[u_axis] + 0.5, position[v_axis] / size[v_axis] + 0.5)
                    row.append(mesh.vertex(position, direction, uv))
                rows.append(row if sign > 0 else row[::-1])
            mesh.grid(rows)
    return mesh


def arc(center, radius, start, end, segments=8):
    """Profile points along a circle, angles in degrees."""
    points = []
    for i in range(segments + 1):
        angle = math.radians(start + (end - start) * i / segments)
        points.append((center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)))
    return points


def moulding(path, up, profile, closed=False, crease=40):
    """Sweeps a profile along a polyline in the plane with normal `up`, mitred at the corners.

    A profile point (a, b) lies at distance a to the left of the path (up × direction) and b along up.
    The profile's outside is on its right. Edges sharper than `crease` degrees stay sharp.
    """
    count = len(path)
    pairs = [(i, (i + 1) % count) for i in range(count if closed else count - 1)]
    lefts = [normalize(cross(up, sub(path[j], path[i]))) for i, j in pairs]

    def mitre(i):
        before = lefts[i - 1] if closed or i > 0 else lefts[0]
        after = lefts[i % len(lefts)] if closed or i < count - 1 else lefts[-1]
        return mul(add(before, after), 1 / (1 + dot(before, after)))

    def flat_normal(k):
        (a0, b0), (a1, b1) = profile[k], profile[k + 1]
        length = math.hypot(a1 - a0, b1 - b0)
        return ((b1 - b0) / length, -(a1 - a0) / length)

    flat = [flat_normal(k) for k in range(len(profile) - 1)]

    def normal_at(k, point):
        """Normal of profile segment k at profile point `point` (k or k + 1)."""
        other = k - 1 if point == k else k + 1
        if not 0 <= other < len(flat) or dot(flat[k], flat[other]) < math.cos(math.radians(crease)):
            return flat[k]
        return normalize(add(flat[k], flat[other]))

    mesh = Mesh()
    for (i, j), left in zip(pairs, lefts):
        length = math.sqrt(dot(sub(path[j], path[i]), sub(path[j], path[i])))
        for k in range(len(flat)):
            rows = []
            for point in (k, k + 1):
                a, b = profile[point]
                n = normal_at(k, point)
                normal = add(mul(left, n[0]), mul(up, n[1]))
                rows.append([mesh.vertex(add(path[corner], add(mul(mitre(corner), a), mul(up, b))),
                                         normal, (u, point / len(flat)))
                             for corner, u in ((j, length), (i, 0))])
            mesh.grid(rows)
    return mesh
