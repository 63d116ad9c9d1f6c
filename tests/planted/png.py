"""PNG files of 16 bits as lists of numbers, read and written with what Python has."""
import struct
import zlib


def read(path):
    """(width, height, samples 0..65535 row by row, three a pixel)"""
    data = open(path, 'rb').read()
    at, idat, palette = 8, b'', None
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        at += 12 + size
        if kind == b'IHDR':
            width, height, depth, color, _, _, interlace = struct.unpack('>IIBBBBB', body)
        elif kind == b'IDAT':
            idat += body
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    assert depth in (8, 16) and not interlace
    unit = channels * depth // 8
    raw, stride, rows, previous = zlib.decompress(idat), width * unit, [], bytes(width * unit)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = line[i - unit] if i >= unit else 0
            b = previous[i]
            c = previous[i - unit] if i >= unit else 0
            if kind == 1:
                line[i] = (line[i] + a) & 255
            elif kind == 2:
                line[i] = (line[i] + b) & 255
            elif kind == 3:
                line[i] = (line[i] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
                line[i] = (line[i] + (a if pa <= pb and pa <= pc else b if pb <= pc else c)) & 255
        previous = bytes(line)
        values = struct.unpack(f'>{width * channels}H', previous) if depth == 16 else [257 * v for v in previous]
        for x in range(width):
            pixel = values[x * channels:(x + 1) * channels]
            rows.extend(pixel[:3] if channels >= 3 else [pixel[0]] * 3)
    return width, height, rows


def write(path, width, height, samples):
    raw = b''.join(b'\0' + struct.pack(f'>{3 * width}H', *samples[3 * width * y:3 * width * (y + 1)]) for y in range(height))
    chunk = lambda kind, body: struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    with open(path, 'wb') as out:
        out.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 16, 2, 0, 0, 0)) +
                  chunk(b'IDAT', zlib.compress(raw, 6)) + chunk(b'IEND', b''))
