"""Writers for the two picture formats that our scenes use. Standard library only."""

import math
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
