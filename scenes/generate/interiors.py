"""The scenes after "Metropolis Photon Sampling": two rooms, a lantern, a box; and a keyhole. Metres."""

import functools
import math

import furniture as f
from carving import carved, circle, polygon
from meshes import Mesh, arc, lathe, moulding, rounded_box, tube
from pictures import landscape, wood, woven_rug


PICTURES = {
    "oak": lambda: wood((0.42, 0.27, 0.15), (0.76, 0.57, 0.37), 1),
    "walnut": lambda: wood((0.22, 0.13, 0.08), (0.47, 0.30, 0.19), 5),
    "hills": lambda: landscape(20),
    "valley": lambda: landscape(32),
    "rug": lambda: woven_rug((0.46, 0.13, 0.12), (0.16, 0.17, 0.27), (0.80, 0.70, 0.52)),
}


@functools.lru_cache(None)
def picture(name):
    return PICTURES[name]()


def textures(*names):
    return {f"{name}.png": picture(name) for name in names or PICTURES}


def room_path(x0, x1, z0, z1):
    """The foot of a room's walls, with the room on its left."""
    return [(x1, 0, z0), (x0, 0, z0), (x0, 0, z1), (x1, 0, z1)]


def shell(x0, x1, z0, z1, height, walls, boards="oak", above="ceiling"):
    """Floor boards, ceiling, and those of the walls -x, +x, -z, +z that are whole, seen from inside."""
    parts = f.floor_boards(x0, x1, z0, z1, f"{x0} {z0}", boards)
    quads = {
        "-x": ((x0, 0, z1), (x0, 0, z0), (x0, height, z0), (x0, height, z1)),
        "+x": ((x1, 0, z0), (x1, 0, z1), (x1, height, z1), (x1, height, z0)),
        "-z": ((x0, 0, z0), (x1, 0, z0), (x1, height, z0), (x0, height, z0)),
        "+z": ((x1, 0, z1), (x0, 0, z1), (x0, height, z1), (x1, height, z1)),
    }
    for side, material in walls.items():
        wall = Mesh()
        wall.quad(*quads[side])
        parts.add(material, wall)
    ceiling = Mesh()
    ceiling.quad((x0, height, z0), (x1, height, z0), (x1, height, z1), (x0, height, z1))
    parts.add(above, ceiling)
    parts.place(f.cornice(room_path(x0, x1, z0, z1), height))
    return parts


def rooms():
    """A living room in front; behind a wall of 5 cm a dark dining room with all lamps but one. The double
    door between them stands ajar, by the angle of its left leaf: a hand's breadth of light."""
    left, right, front, wall, top = -2.6, 2.6, 2.3, -2.0, 2.5
    thick, far = 0.05, -5.6
    door_x, door_w, door_h, ajar = 1.4, 1.3, 2.08, 10
    behind = wall - thick
    parts = shell(left, right, wall, front, top, {"-x": "plaster", "+x": "plaster", "+z": "plaster"})
    parts.place(shell(left, right, far, behind, top, {side: "olive" for side in ("-x", "+x", "-z")},
                      "walnut", "olive"))
    parts.place(f.wall_with_door(left - door_x, right - door_x, top, door_w, door_h, thick,
                                 "plaster", "olive"), (door_x, 0, wall - 0.5 * thick))
    a, b = door_x - 0.5 * door_w, door_x + 0.5 * door_w
    leaf = f.door(0.5 * door_w - 0.005, door_h - 0.01, paint="walnut")
    parts.place(leaf, (b - 0.003, 0.006, wall + 0.024))
    parts.place(leaf, (a + 0.003, 0.006, wall + 0.024), 180 - ajar)
    casing = 0.075
    parts.place(f.skirting([(a - casing, 0, wall), (left, 0, wall), (left, 0, front), (right, 0, front),
                            (right, 0, wall), (b + casing, 0, wall)]))
    parts.place(f.skirting([(b + casing, 0, behind), (right, 0, behind), (right, 0, far), (left, 0, far),
                            (left, 0, behind), (a - casing, 0, behind)]))

    # The living room.
    parts.place(f.bookcase(0.95, 1.95, 0.3, 5, 40), (-2.08, 0, wall + 0.17))
    parts.place(f.sofa(1.9), (-0.42, 0, wall + 0.52))
    parts.place(f.rug(1.6, 2.4), (-0.45, 0, -0.3), 90)
    parts.place(f.table(1.05, 0.58, 0.42, 4, "walnut"), (-0.4, 0.014, -0.35))
    parts.place(f.bowl(0.13), (-0.62, 0.434, -0.32))
    for i, (color, turn) in enumerate((("book-navy", 12), ("book-cream", -4), ("book-red", 21))):
        tome = rounded_box((0.27 - 0.025 * i, 0.03, 0.2 - 0.02 * i), 0.004, 2)
        parts.add(color, tome, (-0.12, 0.449 + 0.03 * i, -0.38), turn)
    parts.place(f.sofa(0.98, "fabric-green"), (-1.95, 0, 0.1), 72)
    parts.place(f.floor_lamp(), (-1.5, 0, wall + 0.3))
    parts.place(f.picture(0.78, 0.58, "hills"), (-0.72, 1.58, wall))
    parts.place(f.picture(0.5, 0.58, "valley"), (0.1, 1.58, wall))
    parts.place(f.chair(), (2.2, 0, -0.55), -62)
    parts.place(f.picture(0.9, 0.64, "valley", "brass"), (right, 1.55, -0.5), -90)

    # The dining room.
    parts.place(f.table(1.9, 0.95, 0.75, 6, "walnut"), (0.2, 0, -3.95))
    for x in (-0.3, 0.65):
        parts.place(f.chair(), (x, 0, -4.55))
        parts.place(f.chair(), (x, 0, -3.32), 180)
    parts.place(f.chair(), (1.42, 0, -3.9), -100)
    parts.place(f.bowl(0.17), (0.3, 0.75, -3.95))
    parts.place(f.vase(0.34), (1.0, 0.75, -4.0))
    parts.place(f.picture(1.3, 0.9, "hills"), (1.75, 1.5, far))
    parts.place(f.bookcase(1.2, 0.95, 0.36, 2, 90, "walnut"), (-1.6, 0, far + 0.2))
    for x in (0.2, 0.8):
        parts.add("brass", lathe([(0.005, 1.72), (0.005, top)], 10), (x, 0, -3.95))
        cap = lathe([(0.03, 1.66), (0.03, 1.69), (0.012, 1.72), (0.005, 1.73)], 20)
        parts.add("brass", cap, (x, 0, -3.95))
        parts.add("brass", lathe([(0, top - 0.02), (0.05, top - 0.02), (0.05, top)], 24), (x, 0, -3.95))
    return {**parts.files("rooms"), **textures()}


PUMPKIN, SHELL = 0.18, 0.021  # Largest radius and thickness of the shell.


def face(x, y):
    """Eyes, nose and a toothed mouth, around (0, 0) in degrees of longitude and latitude."""
    eyes = min(polygon((s * 22 - 11, 9), (s * 22 + 11, 9), (s * 19, 28))(x, y) for s in (-1, 1))
    nose = polygon((-5, -2), (5, -2), (0, 7))(x, y)
    smile = max(circle(0, 22, 50)(x, y), -circle(0, 42, 56)(x, y))
    teeth = min(polygon((cx - 4, cy - 5), (cx + 4, cy - 5), (cx + 4, cy + 5), (cx - 4, cy + 5))(x, y)
                for cx, cy in ((-13, -10), (13, -10), (0, -26)))
    return min(eyes, nose, max(smile, -teeth))


def star_holes(x, y):
    """A rosette of round holes."""
    holes = [circle(0, 0, 6)]
    holes += [circle(14 * math.cos(i * math.pi / 3), 14 * math.sin(i * math.pi / 3), 4.2)
              for i in range(6)]
    return min(hole(x, y) for hole in holes)


def pumpkin():
    def surface(inset):
        def point(u, v):
            phi, theta = 2 * math.pi * u, math.pi * (0.02 + 0.96 * v)
            groove = 1 - abs(math.cos(5 * phi))
            radius = PUMPKIN * (1 - 0.085 * groove ** 1.7 * math.sin(theta)) - inset
            ring = math.sin(theta)
            dimple = 0.3 * math.exp(-(ring / 0.36) ** 2)
            height = -math.cos(theta) * (0.84 - dimple)
            return (radius * ring * math.sin(phi), radius * height, radius * ring * math.cos(phi))
        return point

    def opening(u, v):
        longitude = (360 * u + 180) % 360 - 180
        latitude = 180 * (0.02 + 0.96 * v) - 90
        holes = [face(longitude, latitude)] if abs(longitude) < 60 else [1]
        for center in (72, 108, 144, 180, -144, -108, -72):
            x = (longitude - center + 180) % 360 - 180
            if abs(x) < 20:
                holes.append(star_holes(x, latitude - (8 if center % 72 else -8)))
        return min(holes)

    return carved(surface(0), surface(SHELL), opening, 180, 80)


def lantern():
    """A carved pumpkin with a small flame in it, on a table in a room that has no other light."""
    left, right, back, front, top = -1.5, 1.5, -1.25, 2.1, 2.3
    base = 0.75
    parts = shell(left, right, back, front, top, {side: "plaster" for side in ("-x", "+x", "-z", "+z")})
    parts.place(f.skirting(room_path(left, right, back, front)))
    parts.place(f.table(1.3, 0.8, base, 5), (0, 0, 0.02))

    skin, flesh = pumpkin()
    low = base - min(position[1] for position, _, _ in skin.vertices)
    parts.add("pumpkin", skin, (0, low, 0), 14)
    parts.add("flesh", flesh, (0, low, 0), 14)
    crown = low + 0.54 * PUMPKIN
    bend = [(0, crown - 0.02, 0), (0, crown + 0.03, 0), (0.005, crown + 0.055, 0.005),
            (0.018, crown + 0.075, 0.012)]
    parts.add("stem", tube(bend, 0.018, 9))
    parts.add("stem", lathe([(0.04, crown - 0.02), (0.03, crown - 0.002), (0.017, crown + 0.016)], 12))
    parts.add("stem", lathe([(0.018, 0), (0, 0.003)], 9), (0.018, crown + 0.074, 0.012))
    wax = [(0, 0.026), (0.02, 0.026), (0.02, 0.082), (0.016, 0.086), (0, 0.083)]
    parts.add("wax", lathe(wax, 24), (0, base, 0))

    parts.place(f.chair(), (-0.86, 0, -0.12), 70)
    parts.place(f.chair(), (0.62, 0, -0.66), -24)
    parts.place(f.picture(0.62, 0.48, "hills"), (-0.55, 1.5, back))
    parts.place(f.bookcase(0.75, 1.42, 0.26, 4, 12, "walnut"), (1.06, 0, back + 0.15))
    parts.place(f.vase(0.3), (0.9, 1.45, back + 0.15))
    parts.place(f.bowl(0.12), (1.22, 1.45, back + 0.16))
    parts.place(f.bowl(0.1), (-0.42, base, 0.12))
    for i, (color, turn) in enumerate((("book-red", 24), ("book-cream", 12))):
        tome = rounded_box((0.22, 0.034, 0.16), 0.005, 2)
        parts.add(color, tome, (0.44, base + 0.017 + 0.034 * i, 0.12), turn)
    apple = [(0, 0.006), (0.014, 0), (0.026, 0.008)] + arc((0.012, 0.032), 0.026, -50, 75, 8)
    apple += [(0.006, 0.05), (0, 0.047)]
    for x, z in ((-0.45, 0.13), (-0.39, 0.11)):
        parts.add("apple", lathe(apple, 24, 80), (x, base + 0.03, z))
    return {**parts.files("lantern"), **textures("oak", "walnut", "hills")}


def keyhole():
    """A room whose only light comes through the keyhole of its door, from a lamp in the corridor."""
    left, right, back, front, top, thick = -1.4, 1.3, -1.6, 2.3, 2.4, 0.1
    door_z, door_w, door_h = -0.35, 0.84, 2.05
    parts = shell(left, right, back, front, top, {side: "plaster" for side in ("+x", "-z", "+z")})
    parts.place(shell(left - thick - 1.1, left - thick, back, 1.2, top,
                      {side: "corridor" for side in ("-x", "-z", "+z")}))
    wall = f.wall_with_door(door_z - front, door_z - back, top, door_w, door_h, thick,
                            "plaster", "corridor")
    parts.place(wall, (left - 0.5 * thick, 0, door_z), 90)
    leaf = f.door(door_w - 0.026, door_h - 0.016, with_lock=True)
    parts.place(leaf, (left - 0.5 * thick, 0.004, door_z - 0.5 * door_w + 0.013), 90)
    casing = 0.5 * door_w + 0.075
    foot = [(left, 0, door_z + casing), (left, 0, front), (right, 0, front), (right, 0, back),
            (left, 0, back), (left, 0, door_z - casing)]
    parts.place(f.skirting(foot))

    parts.place(f.bookcase(0.9, 1.9, 0.3, 5, 70), (-0.72, 0, back + 0.17))
    parts.place(f.picture(0.72, 0.54, "hills"), (0.42, 1.5, back))
    parts.place(f.sofa(0.98, "fabric-green"), (0.5, 0, back + 0.62), -18)
    parts.place(f.rug(1.3, 1.9), (0.1, 0, 0.1))
    parts.place(f.table(0.62, 0.36, 0.5, 3, "walnut"), (right - 0.2, 0, -0.3), 90)
    parts.place(f.vase(0.27), (right - 0.2, 0.5, -0.2))
    tome = rounded_box((0.2, 0.034, 0.15), 0.005, 2)
    parts.add("book-red", tome, (right - 0.2, 0.517, -0.46), 70)
    parts.place(f.picture(0.56, 0.7, "valley", "brass"), (right, 1.55, -0.4), -90)
    # The lamp's stand in the corridor.
    stand = [(0, 0), (0.13, 0), (0.13, 0.01), (0.02, 0.03), (0.009, 0.06), (0.009, 0.9),
             (0.02, 0.91), (0, 0.91)]
    parts.add("brass", lathe(stand, 24), (-1.67, 0, 0.03))
    return {**parts.files("keyhole"), **textures()}


def box():
    """The furnishings of a box 2.4 wide, 1.8 high and 2.4 deep whose right wall is a mirror."""
    left, right, back, front, top = -1.2, 1.2, -1.2, 1.2, 1.8
    parts = f.Parts()
    # A slim frame around the mirror: without an edge nobody would see where it is.
    width, depth = 0.03, 0.014
    for y0, y1, z0, z1 in ((0, top, back, back + width), (0, top, front - width, front),
                           (0, width, back, front), (top - width, top, back, front)):
        bar = rounded_box((depth, y1 - y0, z1 - z0), 0.004, 2)
        parts.add("bronze", bar, (right - 0.5 * depth, 0.5 * (y0 + y1), 0.5 * (z0 + z1)))
    # The lamp lies in a recess of the ceiling, behind a frame.
    x0, x1, z0, z1, deep, width = -0.14, 0.14, -0.19, 0.09, 0.02, 0.03
    frame = ([(width, 0)] + arc((width - 0.008, 0.004), 0.008, 0, 90)
             + arc((0.008, 0.004), 0.008, 90, 180) + [(0, -deep)])
    path = [(x1, top, z0), (x0, top, z0), (x0, top, z1), (x1, top, z1)]
    parts.add("bronze", moulding(path, (0, -1, 0), frame, closed=True))
    ceiling = Mesh()
    for a, b, c, d in ((left, x0, back, front), (x1, right, back, front),
                       (x0, x1, back, z0), (x0, x1, z1, front)):
        ceiling.quad((a, top, c), (b, top, c), (b, top, d), (a, top, d))
    parts.add("white", ceiling)
    # A drum under the mirror ball, with a groove.
    drum = [(0, 0)] + arc((0.328, 0.012), 0.012, -90, 0, 4)
    drum += [(0.34, 0.03), (0.325, 0.034), (0.325, 0.05), (0.34, 0.054)]
    drum += arc((0.328, 0.158), 0.012, 0, 90, 4) + [(0, 0.17)]
    parts.add("white", lathe(drum, 96), (-0.42, 0, -0.5))
    return parts.files("box")


FILES = {"rooms": rooms, "lantern": lantern, "keyhole": keyhole, "box": box}
