# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures made small: read as the program writes them, averaged down, written with few colours. Needs Python alone."""
import struct
import zlib


def chunks(data):
    """The chunks of a PNG file, one after the other: their names and what is in them."""
    at = 8
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        yield name, data[at + 8:at + 8 + size]
        at += 12 + size


def paeth(left, above, corner):
    """PNG's predictor of that name."""
    p = left + above - corner
    a, b, c = abs(p - left), abs(p - above), abs(p - corner)
    return left if a <= b and a <= c else above if b <= c else corner


def unfiltered(row, before, kind, step):
    """A row of bytes without its filter; `before` is the row above it."""
    if kind == 2:
        return bytearray((x + y) & 255 for x, y in zip(row, before))
    if kind:
        for i, x in enumerate(row):
            left = row[i - step] if i >= step else 0
            above = before[i]
            corner = before[i - step] if i >= step else 0
            guess = (left, above, (left + above) // 2, paeth(left, above, corner))[kind - 1]
            row[i] = (x + guess) & 255
    return row


def read(path):
    """Width, height and rows of (red, green, blue) of a PNG file of 8 bits a channel that is not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    compressed = b""
    for name, body in chunks(data):
        if name == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            if depth != 8 or colour not in (2, 6) or interlaced:
                raise ValueError(f"{path}: not a picture as the program writes it")
            step = 3 if colour == 2 else 4
        elif name == b"IDAT":
            compressed += body
    raw = zlib.decompress(compressed)
    rows, before = [], bytearray(width * step)
    for y in range(height):
        at = y * (width * step + 1)
        before = unfiltered(bytearray(raw[at + 1:at + 1 + width * step]), before, raw[at], step)
        rows.append([over_white(before[i:i + step]) for i in range(0, width * step, step)])
    return width, height, rows


def over_white(pixel):
    """A pixel on white paper."""
    if len(pixel) == 3:
        return tuple(pixel)
    alpha = pixel[3]
    return tuple((c * alpha + 255 * (255 - alpha)) // 255 for c in pixel[:3])


def averaged(rows, width):
    """The picture `width` pixels wide, each the mean of a block."""
    block = max(1, len(rows[0]) // width)
    result = []
    for y in range(0, len(rows) - block + 1, block):
        line = []
        for x in range(0, len(rows[0]) - block + 1, block):
            cells = [p for row in rows[y:y + block] for p in row[x:x + block]]
            line.append(tuple(sum(p[c] for p in cells) // len(cells) for c in range(3)))
        result.append(line)
    return result


def palette_of(rows, colours):
    """At most so many colours: boxes of the pixels' colours, the one with the most to gain halved at its median."""
    boxes = [[p for row in rows for p in row]]

    def spread(box):
        return max((max(p[c] for p in box) - min(p[c] for p in box), c) for c in range(3))

    while len(boxes) < colours:
        widest = max(range(len(boxes)), key=lambda i: (spread(boxes[i])[0] * len(boxes[i]) ** 0.5, -i))
        width, channel = spread(boxes[widest])
        if width == 0:
            break
        box = sorted(boxes.pop(widest), key=lambda p: p[channel])
        middle = len(box) // 2
        while middle > 0 and box[middle - 1][channel] == box[middle][channel]:
            middle -= 1
        if middle == 0:
            middle = next(i for i, p in enumerate(box) if p[channel] != box[0][channel])
        boxes += [box[:middle], box[middle:]]
    return sorted({tuple(sum(p[c] for p in box) // len(box) for c in range(3)) for box in boxes})


def write(path, rows, colours=16):
    """A PNG file with a palette of at most 16 colours, half a byte a pixel."""
    palette = palette_of(rows, colours)
    nearest = {}

    def index(pixel):
        if pixel not in nearest:
            far = [sum((a - b) ** 2 for a, b in zip(colour, pixel)) for colour in palette]
            nearest[pixel] = far.index(min(far))
        return nearest[pixel]

    raw = bytearray()
    for row in rows:
        line = [index(p) for p in row] + [0]
        raw.append(0)
        raw.extend(line[i] << 4 | line[i + 1] for i in range(0, len(row), 2))

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 4, 3, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
        file.write(chunk(b"PLTE", bytes(c for p in palette for c in p)))
        file.write(chunk(b"IDAT", zlib.compress(bytes(raw), 9)) + chunk(b"IEND", b""))


def make_small(source, target, width=200):
    """The picture of a file, so many pixels wide and without the line of text at its foot, in another file."""
    rows = averaged(read(source)[2], width)
    write(target, rows[:len(rows) * 23 // 25])
