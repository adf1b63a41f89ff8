"""Furniture and joinery in metres: each piece stands on y = 0 around the origin and faces +z."""

import math
import random

from carving import carved, circle, polygon
from meshes import (Mesh, add, arc, block, chamfered_box, cushion, lathe, moulding, rounded_box, tube,
                    turned)

UP = (0, 1, 0)


class Parts(dict):
    """Meshes by the name of their material."""

    def add(self, material, mesh, at=(0, 0, 0), turn=0):
        """Turns a mesh about the y axis by degrees, then moves it."""
        self.setdefault(material, Mesh()).append(turned(mesh, 1, turn) if turn else mesh, at)

    def place(self, parts, at=(0, 0, 0), turn=0):
        for material, mesh in parts.items():
            self.add(material, mesh, at, turn)

    def files(self, scene):
        return {f"{name}.ply": mesh.ply(f"{name} of {scene}") for name, mesh in self.items()}


def timber(size, radius=0.004, seed=0):
    """A bar with broken edges whose uv are metres of wood: u along the grain, v across it."""
    along = max(range(3), key=lambda axis: size[axis])
    across = [axis for axis in range(3) if axis != along]
    pick = random.Random(f"{size}{seed}")
    du, dv = pick.random(), pick.random()
    return chamfered_box(size, radius).mapped(lambda p, n, uv: (
        p, n, (p[along] + du, p[across[0]] + p[across[1]] + dv)))


def leg(height, foot, head):
    """A turned, tapering leg."""
    profile = [(0, 0), (foot * 0.8, 0), (foot, 0.004), (head, height * 0.86), (head * 0.85, height * 0.9),
               (head, height * 0.93), (head, height)]
    return lathe(profile, 12).mapped(lambda p, n, uv: (p, n, (uv[1], 0.1 * uv[0])))


def chair(wood="walnut", seat="linen"):
    parts = Parts()
    for x in (-0.18, 0.18):
        parts.add(wood, leg(0.43, 0.012, 0.02), (x, 0, 0.18))
        parts.add(wood, leg(0.43, 0.012, 0.02), (x, 0, -0.18))
        post = turned(timber((0.034, 0.5, 0.026), 0.008, x), 0, -9)
        parts.add(wood, post, (x, 0.66, -0.225))
        parts.add(wood, timber((0.018, 0.028, 0.34), 0.004), (x, 0.2, 0))
    parts.add(wood, timber((0.36, 0.024, 0.018), 0.004), (0, 0.2, 0))
    for z in (-0.18, 0.18):
        parts.add(wood, timber((0.36, 0.05, 0.02), 0.004), (0, 0.4, z))
    parts.add(wood, timber((0.43, 0.02, 0.43), 0.008), (0, 0.435, 0))
    parts.add(seat, cushion((0.42, 0.06, 0.42), 6, 6), (0, 0.465, 0))
    for y, height in ((0.62, 0.035), (0.74, 0.035), (0.875, 0.075)):
        rail = turned(timber((0.38, height, 0.018), 0.006, y), 0, -9)
        parts.add(wood, rail, (0, y, -0.225 - (y - 0.66) * math.tan(math.radians(9))))
    return parts


def table(length, width, height, boards=4, wood="oak"):
    parts = Parts()
    step = width / boards
    for i in range(boards):
        board = timber((length, 0.032, step - 0.001), 0.003, i)
        parts.add(wood, board, (0, height - 0.016, (i + 0.5) * step - 0.5 * width))
    x, z = 0.5 * length - 0.09, 0.5 * width - 0.08
    for side in (-1, 1):
        parts.add(wood, timber((2 * x, 0.085, 0.022), 0.003), (0, height - 0.0745, side * z))
        parts.add(wood, timber((0.022, 0.085, 2 * z), 0.003), (side * x, height - 0.0745, 0))
        for other in (-1, 1):
            at = (side * x, 0, other * z)
            parts.add(wood, timber((0.066, 0.14, 0.066), 0.006), add(at, (0, height - 0.102, 0)))
            parts.add(wood, leg(height - 0.165, 0.018, 0.032), at)
    return parts


def sofa(length, fabric="fabric-blue", pillow="ochre", wood="walnut"):
    parts = Parts()
    inner = length - 0.36
    parts.add(fabric, cushion((length - 0.1, 0.24, 0.8), 14), (0, 0.24, 0))
    parts.add(fabric, turned(cushion((length - 0.1, 0.66, 0.2), 9), 0, -7), (0, 0.49, -0.36))
    for side in (-1, 1):
        parts.add(fabric, cushion((0.19, 0.47, 0.86), 7), (side * (0.5 * length - 0.095), 0.375, 0.01))
        for z in (-0.3, 0.3):
            parts.add(wood, leg(0.14, 0.014, 0.022), (side * (0.5 * length - 0.12), 0, z))
    count = max(1, round(inner / 0.65))
    for i in range(count):
        x = ((i + 0.5) / count - 0.5) * inner
        parts.add(fabric, cushion((inner / count - 0.006, 0.17, 0.68), 6), (x, 0.41, 0.07))
        back = turned(cushion((inner / count - 0.012, 0.44, 0.17), 5), 0, -14)
        parts.add(fabric, back, (x, 0.66, -0.2))
    if count > 1:
        for side, tilt in ((-1, 24), (1, -20)):
            soft = turned(turned(cushion((0.42, 0.42, 0.15), 3.2), 2, 8 * side), 0, -24)
            parts.add(pillow, soft, (side * (0.5 * inner - 0.24), 0.66, -0.06), tilt)
    return parts


def books(length, height, seed, colors=("book-red", "book-green", "book-cream", "book-navy")):
    """A row of books that stand from -length/2 to length/2, their spines at z = 0, with gaps."""
    pick = random.Random(seed)
    parts = Parts()
    x = -0.5 * length
    while True:
        width, tall = 0.018 + 0.03 * pick.random(), height * (0.66 + 0.3 * pick.random())
        deep, color = 0.13 + 0.05 * pick.random(), colors[int(len(colors) * pick.random() ** 1.3)]
        gap = pick.random() < 0.07
        if x + width > 0.5 * length:
            return parts
        spine = chamfered_box((width - 0.001, tall, deep), 0.004)
        if gap and x + width + 0.3 * tall < 0.5 * length:  # The last one of a group leans.
            parts.add(color, turned(spine, 2, 14),
                      (x + 0.5 * width + 0.12 * tall, 0.485 * tall + 0.12 * width, -0.5 * deep - 0.01))
            x += width + 0.25 * tall
        else:
            parts.add(color, spine, (x + 0.5 * width, 0.5 * tall, -0.5 * deep - 0.02 * pick.random()))
            x += width


def bookcase(width, height, depth, shelves, seed, wood="oak"):
    parts = Parts()
    board = 0.026
    for side in (-1, 1):
        parts.add(wood, timber((board, height, depth), 0.003, side),
                  (side * 0.5 * (width - board), 0.5 * height, 0))
    parts.add(wood, timber((width + 0.03, 0.03, depth + 0.02), 0.006), (0, height + 0.015, 0.005))
    inner = width - 2 * board
    parts.add(wood, timber((inner, height, 0.012), 0.002), (0, 0.5 * height, 0.01 - 0.5 * depth))
    parts.add(wood, timber((inner, 0.07, 0.02), 0.003), (0, 0.035, 0.5 * depth - 0.02))
    step = (height - 0.07) / shelves
    for i in range(shelves):
        y = 0.07 + i * step
        parts.add(wood, timber((inner, 0.022, depth - 0.03), 0.003, i), (0, y + 0.011, 0.01))
        row = books(inner - 0.02, step - 0.03, seed + i)
        parts.place(row, (0, y + 0.022, 0.5 * depth - 0.045))
    return parts


def vase(height=0.3, material="ceramic"):
    r = 0.3 * height
    outside = [(0, 0), (0.5 * r, 0), (0.55 * r, 0.01 * height)]
    outside += [(r * (0.55 + 0.45 * math.sin(math.pi * (0.06 + t) ** 0.8)), height * (0.01 + 0.8 * t))
                for t in (i / 16 for i in range(1, 17))]
    neck = outside[-1][0]
    outside += [(neck * 0.92, 0.86 * height), (neck * 0.95, 0.93 * height), (neck * 1.25, height)]
    inside = [(neck * 1.17, height), (neck * 0.85, 0.93 * height), (neck * 0.82, 0.8 * height),
              (0.4 * r, 0.3 * height), (0, 0.3 * height)]
    return Parts({material: lathe(outside + inside, 32)})


def bowl(radius=0.14, material="ceramic"):
    outside = [(0, 0), (0.4 * radius, 0), (0.4 * radius, 0.08 * radius)]
    outside += [(radius * math.sin(t), radius * (0.08 + 0.55 * (1 - math.cos(t)) / (1 - math.cos(1.35))))
                for t in (0.42 + 0.1 * i for i in range(11))]
    rim_r, rim_y = outside[-1]
    inside = [(rim_r - 0.004, rim_y + 0.002), (rim_r - 0.008, rim_y - 0.001),
              (0.7 * radius, 0.25 * radius), (0.4 * radius, 0.14 * radius), (0, 0.12 * radius)]
    return Parts({material: lathe(outside + inside, 32)})


def floor_lamp(height=1.55, metal="brass", shade="lamp-shade"):
    parts = Parts()
    parts.add(metal, lathe([(0, 0), (0.14, 0)] + arc((0.132, 0.008), 0.008, 0, 90, 4)
                           + [(0.03, 0.024), (0.012, 0.05), (0.011, height - 0.3), (0.011, height - 0.02),
                              (0.016, height - 0.01), (0.012, height), (0, height + 0.004)]))
    parts.add(shade, lathe([(0.21, height - 0.3), (0.14, height)], 40))
    for y, r in ((height - 0.3, 0.21), (height, 0.14)):
        rim = [(r - 0.003, y - 0.005), (r + 0.003, y - 0.005), (r + 0.003, y + 0.005),
               (r - 0.003, y + 0.005)]
        parts.add("linen", lathe(rim, 40))
    return parts


def picture(width, height, canvas, frame="walnut"):
    """A framed picture on the wall z = 0, around the origin: canvas, white mount and frame."""
    parts = Parts()
    x, y = 0.5 * width, 0.5 * height
    path = [(x, -y, 0), (x, y, 0), (-x, y, 0), (-x, -y, 0)]
    profile = [(-0.03, 0), (-0.03, 0.018)] + arc((-0.024, 0.02), 0.006, 180, 90, 3) \
        + [(-0.012, 0.024), (-0.004, 0.016), (0, 0.014), (0, 0.004)]
    parts.add(frame, moulding(path, (0, 0, 1), profile[::-1], closed=True))
    mount = Mesh()
    mount.quad((-x, -y, 0.006), (x, -y, 0.006), (x, y, 0.006), (-x, y, 0.006))
    parts.add("paper", mount)
    x, y = x - 0.055, y - 0.055
    image = Mesh()
    image.quad((-x, -y, 0.007), (x, -y, 0.007), (x, y, 0.007), (-x, y, 0.007))
    parts.add(canvas, image)
    return parts


def door_handle(metal="brass"):
    """A lever on a rose; it stands on z = 0 and points to -x."""
    parts = Parts()
    rose = lathe([(0.026, 0), (0.026, 0.005)] + arc((0.022, 0.006), 0.004, 0, 90, 4)
                 + [(0.012, 0.012), (0.009, 0.02), (0.009, 0.05)], 24)
    parts.add(metal, turned(rose, 0, 90))
    bend = [(-x, 0, z) for x, z in arc((0.012, 0.042), 0.012, 180, 90, 6)]
    grip = [(0, 0, 0.03), *bend, (-0.06, 0, 0.056), (-0.105, -0.002, 0.056)]
    parts.add(metal, tube(grip, 0.0085, 14))
    knob = lathe([(0.0085, 0), (0.009, 0.01), (0.006, 0.017), (0, 0.019)], 14)
    parts.add(metal, turned(knob, 2, 90), (-0.104, -0.002, 0.056))
    return parts


def panel(width, height, depth):
    """A sunk door panel with an ogee around it, z = 0 at its middle, both faces."""
    x, y = 0.5 * width, 0.5 * height
    sides = Mesh()
    path = [(x, -y, 0), (x, y, 0), (-x, y, 0), (-x, -y, 0)]
    half = 0.5 * depth
    profile = [(0.034, 0.012), (0.02, half - 0.012), (0.008, half - 0.006), (0.004, half), (0, half)]
    face = moulding(path, (0, 0, 1), profile, closed=True)
    field = Mesh()
    x, y = x - 0.034, y - 0.034
    field.quad((-x, -y, 0.012), (x, -y, 0.012), (x, y, 0.012), (-x, y, 0.012))
    for mesh in (face, field):
        sides.append(mesh, (0, 0, 0))
        sides.append(turned(mesh, 1, 180), (0, 0, 0))
    return sides


KEYHOLE_RADIUS, KEYHOLE_FOOT = 0.010, -0.036  # The slot below the round hole ends at y = foot.


def keyhole(x, y):
    """Negative inside a keyhole whose round part lies around the origin; metres."""
    slot = polygon((-0.008, KEYHOLE_FOOT), (0.008, KEYHOLE_FOOT), (0.0045, 0), (-0.0045, 0))
    return min(circle(0, 0, KEYHOLE_RADIUS)(x, y), slot(x, y))


def lock(width, height, depth, paint):
    """A piece of a door with a keyhole through it, and its brass scutcheons."""
    def at(z):
        return lambda u, v: ((u - 0.5) * width, (v - 0.5) * height, z)

    def open_in(u, v):
        return keyhole((u - 0.5) * width, (v - 0.5) * height)

    parts = Parts()
    front, back = carved(at(0.5 * depth), at(-0.5 * depth), open_in, 35, 56)
    parts.add(paint, front)
    parts.add(paint, back)

    def scutcheon(z):
        return lambda u, v: ((u - 0.5) * 0.06, (v - 0.65) * 0.1, z)

    def oval_with_keyhole(u, v):
        x, y, _ = scutcheon(0)(u, v)
        return min(keyhole(x, y), 0.02 * (1 - (x / 0.025) ** 2 - ((y + 0.014) / 0.042) ** 2))

    front, back = carved(scutcheon(0.0025), scutcheon(0), oval_with_keyhole, 30, 50)
    for side in (0, 180):
        for mesh in (front, back):
            lifted = mesh.mapped(lambda p, n, uv: (add(p, (0, 0, 0.5 * depth)), n, uv))
            parts.add("brass", lifted, turn=side)
    return parts


def door(width=0.86, height=2.03, depth=0.04, paint="woodwork", with_lock=False):
    """A panelled leaf hinged at x = 0 that reaches to x = -width; its handles at 1.03 m."""
    parts = Parts()
    stile, rail = 0.11, 0.2
    middle = 0.5 * width
    rails = ((0, rail), (0.86, 0.86 + 0.18), (height - 0.12, height))
    for low, high in rails:
        bar = timber((width - 2 * stile, high - low, depth), 0.002)
        parts.add(paint, bar, (-middle, 0.5 * (low + high), 0))
    low, high = 0.86, 1.0
    parts.add(paint, timber((stile, height, depth), 0.002), (-0.5 * stile, 0.5 * height, 0))
    if with_lock:
        x0, x1 = -width, stile - width
        for bottom, top in ((0, low), (high, height)):
            parts.add(paint, block((x0, bottom, -0.5 * depth), (x1, top, 0.5 * depth)))
        for a, b in ((x0, x0 + 0.02), (x1 - 0.02, x1)):
            parts.add(paint, block((a, low, -0.5 * depth), (b, high, 0.5 * depth)))
        parts.place(lock(stile - 0.04, high - low, depth, paint),
                    (0.5 * stile - width, 0.5 * (low + high), 0))
    else:
        parts.add(paint, timber((stile, height, depth), 0.002), (0.5 * stile - width, 0.5 * height, 0))
    for (_, below), (above, _) in zip(rails, rails[1:]):
        for side in (-1, 1):
            wide = 0.5 * (width - 2 * stile - 0.09)
            parts.add(paint, panel(wide, above - below, depth),
                      (-middle + side * 0.5 * (wide + 0.09), 0.5 * (above + below), 0))
        parts.add(paint, timber((0.09, above - below, depth), 0.002), (-middle, 0.5 * (above + below), 0))
    at = (0.5 * stile - width, 1.03, 0)
    lever = door_handle()["brass"]
    mirrored = turned(lever, 0, 180)
    for grip, z in ((turned(lever, 2, 180), 0.5 * depth), (turned(mirrored, 2, 180), -0.5 * depth)):
        parts.add("brass", grip, add(at, (0, 0, z)))
    return parts


def wall_with_door(x0, x1, height, width, door_height, thickness, front, back, paint="woodwork"):
    """A wall along x from x0 to x1 around z = 0 with an opening around x = 0, its frame and sill."""
    parts = Parts()
    a, b, z = -0.5 * width, 0.5 * width, 0.5 * thickness
    for left, right, low in ((x0, a, 0), (b, x1, 0), (a, b, door_height)):
        corners = [(left, low), (right, low), (right, height), (left, height)]
        for material, at, order in ((front, z, corners), (back, -z, corners[::-1])):
            side = Mesh()
            side.quad(*((x, y, at) for x, y in order))
            parts.add(material, side)
    parts.add(paint, block((a, -0.01, -z), (b, 0.004, z)))
    parts.place(door_frame(width, door_height, thickness, paint))
    return parts


def door_frame(width, height, wall, paint="woodwork"):
    """Lining and architraves of an opening in a wall of thickness `wall` around z = 0."""
    parts = Parts()
    x = 0.5 * width
    path = [(x, 0, 0), (x, height, 0), (-x, height, 0), (-x, 0, 0)]
    outline = [(0, 0.014), (-0.008, 0.016), (-0.05, 0.02), (-0.062, 0.024),
               (-0.068, 0.022), (-0.07, 0.016), (-0.07, 0)]
    casing = moulding(path, (0, 0, 1), [(0.012, 0)] + [(0.012, 0.008)] + outline)
    for turn in (0, 180):
        front = casing.mapped(lambda p, n, uv: (add(p, (0, 0, 0.5 * wall)), n, uv))
        parts.add(paint, front, turn=turn)
    for side in (-1, 1):
        jamb = block((-0.012, 0, -0.5 * wall), (0.012, height, 0.5 * wall))
        parts.add(paint, jamb, (side * x, 0, 0))
    parts.add(paint, block((-x, height - 0.012, -0.5 * wall), (x, height + 0.012, 0.5 * wall)))
    return parts


def floor_boards(x0, x1, z0, z1, seed, wood="oak", width=0.145):
    """Boards along z with chamfered edges and staggered joints; their faces are at y = 0."""
    pick = random.Random(seed)
    mesh = Mesh()
    gap, chamfer = 0.0008, 0.0025
    count = math.ceil((x1 - x0) / width)
    for i in range(count):
        a, b = x0 + i * width + gap, min(x0 + (i + 1) * width, x1) - gap
        z = z0 - 1.8 * pick.random()
        while z < z1:
            near, far = max(z, z0), min(z + 1.8, z1)
            z += 1.8
            du, dv = pick.random(), pick.random()
            part = Mesh()
            section = [(a, -chamfer), (a + chamfer, 0), (b - chamfer, 0), (b, -chamfer)]
            for (p, y), (q, h) in zip(section, section[1:]):
                part.quad((p, y, far - gap), (q, h, far - gap), (q, h, near + gap), (p, y, near + gap))
            mesh.append(part.mapped(lambda p, n, uv: (p, n, (p[2] + du, p[0] - a + dv))), (0, 0, 0))
    gaps = Mesh()
    gaps.quad((x0, -0.003, z1), (x1, -0.003, z1), (x1, -0.003, z0), (x0, -0.003, z0))
    return Parts({wood: mesh, "gaps": gaps})


def skirting(path, paint="woodwork"):
    """A board along walls; the room is on the left of the path."""
    profile = [(0.016, 0), (0.016, 0.085), (0.013, 0.097), (0.008, 0.103), (0.006, 0.112), (0, 0.114)]
    return Parts({paint: moulding(path, UP, profile)})


def cornice(path, height, paint="ceiling"):
    """A cove under the ceiling around a room; the room is on the left of the path seen from below."""
    cove = [(0.1, 0), (0.1, 0.012)] + arc((0.095, 0.095), 0.083, 270, 180) + [(0.012, 0.1), (0, 0.1)]
    path = [(x, height, z) for x, _, z in reversed(path)]
    return Parts({paint: moulding(path, (0, -1, 0), cove, closed=True)})


def rug(width, length, fabric="rug"):
    soft = rounded_box((width, 0.016, length), 0.007, 2)
    return Parts({fabric: soft.mapped(lambda p, n, uv: (
        add(p, (0, 0.008, 0)), n, (p[0] / width + 0.5, 0.5 - p[2] / length)))})
