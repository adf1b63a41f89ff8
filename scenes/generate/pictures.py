"""Writers for the two picture formats that our scenes use. Standard library only."""

import math
import random
import struct
import zlib


def png(width, height, pixel):
    """8-bit RGB PNG; pixel(x, y) gives three values in 0..1 as they are stored, top row first."""
    rows = bytearray()
    for y in range(height):
        rows.append(0)  # filter: none
        for x in range(width):
            rows += bytes(min(255, max(0, round(255 * c))) for c in pixel(x, y))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def radiance_hdr(width, height, pixel):
    """Radiance RGBE without run lengths; pixel(x, y) gives linear radiance, top row first."""
    body = bytearray()
    for y in range(height):
        for x in range(width):
            color = pixel(x, y)
            largest = max(color)
            if largest < 1e-32:
                body += bytes(4)
                continue
            mantissa, exponent = math.frexp(largest)
            scale = mantissa * 256 / largest
            body += bytes([*(min(255, int(c * scale)) for c in color), exponent + 128])
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n"
    return header.encode() + bytes(body)


def periodic_noise(seed, columns, rows):
    """Smooth noise in -1..1 over the unit torus, with `columns` × `rows` random values."""
    pick = random.Random(seed)
    values = [[2 * pick.random() - 1 for _ in range(columns)] for _ in range(rows)]

    def noise(u, v):
        x, y = u * columns, v * rows
        i, j = math.floor(x), math.floor(y)
        s, t = x - i, y - j
        s, t = s * s * (3 - 2 * s), t * t * (3 - 2 * t)
        low, high = values[j % rows], values[(j + 1) % rows]
        i, k = i % columns, (i + 1) % columns
        return (low[i] * (1 - s) + low[k] * s) * (1 - t) + (high[i] * (1 - s) + high[k] * s) * t

    return noise


def wood(dark, light, seed, size=256):
    """Grain along u; repeats without a seam. Colours as they are stored (sRGB)."""
    broad, fine = periodic_noise(seed, 3, 14), periodic_noise(seed + 1, 6, 50)
    pores, bend = periodic_noise(seed + 2, 24, 128), periodic_noise(seed + 3, 4, 3)

    def pixel(x, y):
        u, v = x / size, y / size
        v += 0.02 * bend(u, v)
        tone = 0.5 + 0.35 * broad(u, v) + 0.22 * fine(u, v) + 0.16 * min(0, pores(u, v))
        tone = min(1, max(0, tone))
        return tuple(a + (b - a) * tone for a, b in zip(dark, light))

    return png(size, size, pixel)


def landscape(seed, width=192, height=128):
    """A painting of hills under an evening sky."""
    ridges = [periodic_noise(seed + i, 4 + 2 * i, 1) for i in range(5)]
    strokes = periodic_noise(seed + 9, 60, 70)
    tint = random.Random(seed).random()

    def pixel(x, y):
        u, v = x / width, y / height
        color = (0.85 - 0.5 * (0.6 - v), 0.72 - 0.15 * v, 0.52 + 0.25 * (0.5 - v))
        for i, ridge in enumerate(ridges):
            if v > 0.38 + 0.13 * i + 0.11 * ridge(u, 0):
                depth = i / 4
                color = (0.52 - 0.34 * depth + 0.1 * tint, 0.56 - 0.3 * depth, 0.6 - 0.46 * depth)
        return tuple(c + 0.05 * strokes(u, v) for c in color)

    return png(width, height, pixel)


def woven_rug(ground, border, thread, width=160, height=240):
    """Borders around a field of lozenges."""
    weave = periodic_noise(7, 80, 120)

    def pixel(x, y):
        edge = min(x, y, width - 1 - x, height - 1 - y)
        if edge < 3 or 18 <= edge < 21:
            color = thread
        elif edge < 18:
            color = thread if (x // 6 + y // 6) % 4 == 0 and 6 < edge < 14 else border
        else:
            u, v = (x - width / 2) / 40, (y - height / 2) / 40
            lozenge = abs((u % 1) - 0.5) + abs((v % 1) - 0.5)
            color = thread if 0.2 < lozenge < 0.25 else border if lozenge < 0.12 else ground
        return tuple(c * (1 + 0.09 * weave(x / width, y / height)) for c in color)

    return png(width, height, pixel)
