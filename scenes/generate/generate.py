#!/usr/bin/env python3
"""Writes the meshes and pictures of our own scenes; the scene.xml files beside them are written by hand.

    scenes/generate/generate.py [FOLDER]     FOLDER takes the place of scenes/
"""

import math
import pathlib
import sys

import interiors
from meshes import Mesh, add, arc, dot, moulding, normalize, rounded_box
from pictures import png, radiance_hdr

UP, DOWN = (0, 1, 0), (0, -1, 0)


def default_scene():
    """The room of scenes/default: x -1.2..1.2, y 0..2, z -1.4..4.2; its right wall is the mirror."""
    left, right, back, front, top = -1.2, 1.2, -1.4, 4.2, 2.0

    skirting_path = [(right, 0, back), (left, 0, back), (left, 0, front), (right, 0, front)]
    skirting = [(0.018, 0), (0.018, 0.1)] + arc((0, 0.1), 0.018, 0, 90)[1:]
    cove_path = [add(p, (0, top, 0)) for p in reversed(skirting_path)]
    cove = arc((0.09, 0.09), 0.09, 270, 180)

    # The mirror wall stands in a slim frame with posts: without edges nobody would see where it is.
    mirror_frame = Mesh()
    width, depth = 0.032, 0.016
    posts = [(0, top, z, z + width) for z in (back, -0.15, 1.1, 2.35, front - width)]
    rails = [(y, y + width, back, front) for y in (0, top - width)]
    for y0, y1, z0, z1 in posts + rails:
        bar = rounded_box((depth, y1 - y0, z1 - z0), 0.004, 2)
        mirror_frame.append(bar, (right - depth / 2, (y0 + y1) / 2, (z0 + z1) / 2))

    # The light is a rectangle at the bottom of a shallow recess in the ceiling, behind a slim frame.
    x0, x1, z0, z1, depth, width = -0.35, 0.35, -0.6, 0.1, 0.03, 0.035
    frame_path = [(x1, top, z0), (x0, top, z0), (x0, top, z1), (x1, top, z1)]
    frame = ([(width, 0)] + arc((width - 0.008, 0.004), 0.008, 0, 90)
             + arc((0.008, 0.004), 0.008, 90, 180) + [(0, -depth)])
    ceiling = Mesh()
    for a, b, c, d in ((left, x0, back, front), (x1, right, back, front),
                       (x0, x1, back, z0), (x0, x1, z1, front)):
        ceiling.quad((a, top, c), (b, top, c), (b, top, d), (a, top, d))

    return {
        "skirting.obj": moulding(skirting_path, UP, skirting).obj("skirting board"),
        "cove.obj": moulding(cove_path, DOWN, cove).obj("cove between walls and ceiling"),
        "light-frame.obj": moulding(frame_path, DOWN, frame, closed=True).obj("frame of the light"),
        "mirror-frame.obj": mirror_frame.obj("frame of the mirror wall"),
        "ceiling.obj": ceiling.obj("ceiling with a hole for the light"),
        "plinth.obj": rounded_box((0.9, 0.32, 0.9), 0.02).obj("plinth of the mirror ball"),
    }


def cornell():
    """The Cornell box as measured (www.graphics.cornell.edu/online/box/data.html), in millimetres."""
    light = ((343, 227), (343, 332), (213, 332), (213, 227))
    back_z, height = 559.2, 548.8

    def mesh(*quads):
        result = Mesh()
        for quad in quads:
            result.quad(*quad)
        return result

    def block(top_outline, top):
        """Top and sides over an outline that is counter-clockwise seen from above."""
        result = mesh([(x, top, z) for x, z in top_outline])
        for (ax, az), (bx, bz) in zip(top_outline, top_outline[1:] + top_outline[:1]):
            result.quad((ax, 0, az), (bx, 0, bz), (bx, top, bz), (ax, top, az))
        return result

    ceiling = mesh(
        *[[(x, height, z) for x, z in corners] for corners in (
            ((556, 0), (556, back_z), (343, back_z), (343, 0)),
            ((213, 0), (213, back_z), (0, back_z), (0, 0)),
            ((343, 0), (343, 227), (213, 227), (213, 0)),
            ((343, 332), (343, back_z), (213, back_z), (213, 332)))])
    parts = {
        "floor": mesh([(552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2)]),
        "ceiling": ceiling,
        "back-wall": mesh([(549.6, 0, 559.2), (0, 0, 559.2), (0, 548.8, 559.2), (556, 548.8, 559.2)]),
        "right-wall": mesh([(0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2)]),
        "left-wall": mesh([(552.8, 0, 0), (549.6, 0, 559.2), (556, 548.8, 559.2), (556, 548.8, 0)]),
        "light": mesh([(x, height, z) for x, z in light]),
        "short-block": block([(130, 65), (82, 225), (240, 272), (290, 114)], 165),
        "tall-block": block([(423, 247), (265, 296), (314, 456), (472, 406)], 330),
    }
    return {f"{name}.obj": part.obj(name.replace("-", " ")) for name, part in parts.items()}


def egg_crate(u, v, waves=6, slope=0.7):
    """Normal of the height field sin·sin with `waves` bumps along each side, in a unit square."""
    x, y = 2 * math.pi * waves * u, 2 * math.pi * waves * v
    return normalize((-slope * math.cos(x) * math.sin(y), -slope * math.sin(x) * math.cos(y), 1))


def normal_map():
    size = 128

    def pixel(x, y):
        n = egg_crate((x + 0.5) / size, 1 - (y + 0.5) / size)
        return tuple(0.5 + 0.5 * c for c in n)

    return {"bumps.png": png(size, size, pixel)}


def textured_light():
    """Four colours in stripes, one corner marked so that a flipped texture shows."""
    stripes = ((0.95, 0.35, 0.2), (0.95, 0.85, 0.3), (0.3, 0.75, 0.5), (0.25, 0.45, 0.95))

    def pixel(x, y):
        if x < 16 and y < 16:
            return (1, 1, 1)
        return stripes[x * 4 // 64]

    return {"stripes.png": png(64, 64, pixel)}


def environment():
    """A blue sky over brown ground with a small bright sun, latitude-longitude."""
    width, height = 128, 64
    sun = normalize((0.6, 0.55, 0.6))

    def pixel(x, y):
        theta = math.pi * (y + 0.5) / height
        phi = 2 * math.pi * (x + 0.5) / width
        # Mitsuba's convention: the left edge looks along -z, a quarter to the right along +x.
        w = (math.sin(phi) * math.sin(theta), math.cos(theta), -math.cos(phi) * math.sin(theta))
        if w[1] < 0:
            return (0.12, 0.10, 0.08)
        if dot(w, sun) > math.cos(math.radians(5)):
            return (220.0, 190.0, 140.0)
        haze = (1 - w[1]) ** 3
        return tuple(a + (b - a) * haze for a, b in zip((0.18, 0.34, 0.75), (0.85, 0.9, 0.95)))

    return {"sky.hdr": radiance_hdr(width, height, pixel)}


FILES = {
    "default": default_scene,
    "cornell": cornell,
    "tests/envmap": environment,
    "tests/instances": lambda: {"rounded-box.ply": rounded_box((1, 1, 1), 0.15).ply("rounded box")},
    "tests/normal-map": normal_map,
    "tests/textured-light": textured_light,
    **interiors.FILES,
}


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent
    for folder, make in FILES.items():
        target = root / folder
        target.mkdir(parents=True, exist_ok=True)
        for name, data in make().items():
            (target / name).write_bytes(data)


if __name__ == "__main__":
    main()
