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

    def mapped(self, change):
        """A copy whose vertices are change(position, normal, uv)."""
        result = Mesh()
        indices = [result.vertex(*change(*vertex)) for vertex in self.vertices]
        for triangle in self.triangles:
            result.triangle(*(indices[i] for i in triangle))
        return result

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


def turned(mesh, axis, degrees):
    """A copy of a mesh, turned about a coordinate axis (0, 1 or 2) by the right-hand rule."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    u, v = (axis + 1) % 3, (axis + 2) % 3

    def turn(p):
        q = list(p)
        q[u], q[v] = c * p[u] - s * p[v], s * p[u] + c * p[v]
        return tuple(q)

    return mesh.mapped(lambda position, normal, uv: (turn(position), turn(normal), uv))


def block(low, high):
    """Axis-aligned box with sharp edges, for what is built in."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    mesh = Mesh()
    mesh.quad((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1))
    mesh.quad((x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0))
    mesh.quad((x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1))
    mesh.quad((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0))
    mesh.quad((x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0))
    mesh.quad((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1))
    return mesh


def chamfered_box(size, radius):
    """Box around the origin with chamfered edges, whose normals make the chamfers look round."""
    half = [0.5 * s for s in size]
    mesh = Mesh()

    def corner(axis, signs):
        position = tuple(s * (h if i == axis else h - radius)
                         for i, (s, h) in enumerate(zip(signs, half)))
        return position, tuple(s if i == axis else 0 for i, s in enumerate(signs))

    def polygon(corners):
        (a, n), (b, m), (c, o) = corners[:3]
        if dot(cross(sub(b, a), sub(c, a)), add(add(n, m), o)) < 0:
            corners = corners[::-1]
        indices = [mesh.vertex(*c) for c in corners]
        for b, c in zip(indices[1:], indices[2:]):
            mesh.triangle(indices[0], b, c)

    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3

        def signs(a, b, c):
            return tuple({axis: a, first: b, second: c}[i] for i in range(3))

        for side in (-1, 1):
            polygon([corner(axis, signs(side, b, c)) for b, c in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
            for other in (-1, 1):
                polygon([corner(first, signs(-1, side, other)), corner(first, signs(1, side, other)),
                         corner(second, signs(1, side, other)), corner(second, signs(-1, side, other))])
    for x in (-1, 1):
        for y in (-1, 1):
            for z in (-1, 1):
                polygon([corner(axis, (x, y, z)) for axis in range(3)])
    return mesh


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


def profile_normals(profile, crease):
    """For each segment of a profile the normals at its two ends; the outside is on the right.

    Edges sharper than `crease` degrees stay sharp.
    """
    flat = []
    for (a0, b0), (a1, b1) in zip(profile, profile[1:]):
        length = math.hypot(a1 - a0, b1 - b0)
        flat.append(((b1 - b0) / length, -(a1 - a0) / length))

    def joined(k, other):
        if not 0 <= other < len(flat) or dot(flat[k], flat[other]) < math.cos(math.radians(crease)):
            return flat[k]
        return normalize(add(flat[k], flat[other]))

    return [(joined(k, k - 1), joined(k, k + 1)) for k in range(len(flat))]


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

    normals = profile_normals(profile, crease)
    mesh = Mesh()
    for (i, j), left in zip(pairs, lefts):
        length = math.sqrt(dot(sub(path[j], path[i]), sub(path[j], path[i])))
        for k, ends in enumerate(normals):
            rows = []
            for point, n in zip((k, k + 1), ends):
                a, b = profile[point]
                normal = add(mul(left, n[0]), mul(up, n[1]))
                rows.append([mesh.vertex(add(path[corner], add(mul(mitre(corner), a), mul(up, b))),
                                         normal, (u, point / len(normals)))
                             for corner, u in ((j, length), (i, 0))])
            mesh.grid(rows)
    return mesh


def lathe(profile, segments=32, crease=40):
    """Turns a profile of (radius, height) about the y axis; the outside is on its right."""
    mesh = Mesh()
    for k, ends in enumerate(profile_normals(profile, crease)):
        rows = []
        for (radius, y), n in zip(profile[k:k + 2], ends):
            row = []
            for j in range(segments + 1):
                phi = 2 * math.pi * j / segments
                x, z = math.sin(phi), math.cos(phi)
                if radius == 0:  # One vertex for the tip, so that no triangle is degenerate.
                    row.append(mesh.vertex((0, y, 0), (0, math.copysign(1, n[1]), 0)))
                else:
                    row.append(mesh.vertex((radius * x, y, radius * z), (n[0] * x, n[1], n[0] * z),
                                           (j / segments, y)))
            rows.append(row)
        mesh.grid(rows)
    return mesh


def tube(path, radius, segments=12):
    """A round bar along a polyline without sharp turns; its ends are open."""
    side = None
    rows = []
    mesh = Mesh()
    for i, center in enumerate(path):
        ahead = normalize(sub(path[min(i + 1, len(path) - 1)], path[max(i - 1, 0)]))
        if side is None:
            side = cross(ahead, (0, 1, 0) if abs(ahead[1]) < 0.9 else (1, 0, 0))
        side = normalize(sub(side, mul(ahead, dot(side, ahead))))
        other = cross(ahead, side)
        row = []
        for j in range(segments + 1):
            phi = 2 * math.pi * j / segments
            normal = add(mul(side, math.cos(phi)), mul(other, math.sin(phi)))
            row.append(mesh.vertex(add(center, mul(normal, radius)), normal, (j / segments, i)))
        rows.append(row)
    mesh.grid(rows)
    return mesh


def cushion(size, power=5, segments=7):
    """A box with bulging sides: the superellipsoid |2x/a|^p + |2y/b|^p + |2z/c|^p = 1."""
    half = [0.5 * s for s in size]

    def point(direction):
        scale = sum(abs(d) ** power for d in direction) ** (-1 / power)
        position = tuple(scale * d * h for d, h in zip(direction, half))
        normal = normalize(tuple(math.copysign(abs(p / h) ** (power - 1), p) / h
                                 for p, h in zip(position, half)))
        return position, normal

    mesh = Mesh()
    steps = [math.tan(math.pi / 4 * (2 * i / segments - 1)) for i in range(segments + 1)]
    for axis in range(3):
        for sign in (-1, 1):
            rows = []
            for v in steps:
                row = []
                for u in steps:
                    direction = [0.0] * 3
                    direction[axis], direction[(axis + 1) % 3], direction[(axis + 2) % 3] = sign, u, v
                    row.append(mesh.vertex(*point(direction)))
                rows.append(row if sign > 0 else row[::-1])
            mesh.grid(rows)
    return mesh
