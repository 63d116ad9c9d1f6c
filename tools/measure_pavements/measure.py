#!/usr/bin/env python3
"""Measures which edges and corners of each pavement are drawn, by asking POV-Ray; prints tracer/textures/patterns/pavement_flags.inc.

usage: tools/measure_pavements/measure.py > tracer/textures/patterns/pavement_flags.inc      (see README.md)
"""
import math
import os
import subprocess
import sys
import tempfile

H = math.sqrt(3) / 2
# sides -> per number of tiles: (number of patterns, columns, rows of one period)
PAVEMENTS = {
    3: [(1, 2, 2), (1, 2, 2), (1, 6, 6), (3, 4, 4), (4, 10, 10), (12, 12, 12)],
    4: [(1, 1, 1), (1, 2, 2), (2, 6, 6), (5, 4, 4), (12, 10, 10), (35, 12, 12)],
    6: [(1, 6, 2), (1, 6, 2), (3, 18, 6), (7, 24, 8), (22, 60, 20)],
}
SHIFT = 0.001
PREFIX = "#version 3.7;\n#fopen OUT \"out.txt\" write\n"

SQUARE_POINTS = [(SHIFT, 0.5), (1 - SHIFT, 0.5), (0.5, SHIFT), (0.5, 1 - SHIFT),  # edges: left, right, lower, upper
                 (SHIFT, SHIFT), (1 - SHIFT, SHIFT), (SHIFT, 1 - SHIFT), (1 - SHIFT, 1 - SHIFT)]  # corners

# Vertices of the local upright triangle: left, right, top; edge k lies opposite to vertex k.
VERTICES = [(0.0, 0.0), (1.0, 0.0), (0.5, H)]
CENTER = (0.5, H / 3)


def add(a, b, s=1.0):
    return (a[0] + s * b[0], a[1] + s * b[1])


def unit(a):
    n = math.hypot(*a)
    return (a[0] / n, a[1] / n)


def triangle_points():
    points = []
    for k in range(3):  # just inside the middle of the edge opposite to vertex k
        a, b = VERTICES[(k + 1) % 3], VERTICES[(k + 2) % 3]
        middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        points.append(add(middle, unit(add(CENTER, middle, -1)), SHIFT))
    for k in range(3):  # just inside each vertex
        points.append(add(VERTICES[k], unit(add(CENTER, VERTICES[k], -1)), SHIFT))
    return points


def sweep_point(k):
    """A point in the sector of vertex k, nearer to the edge towards vertex k+1 than to the other."""
    v, a, b = VERTICES[k], VERTICES[(k + 1) % 3], VERTICES[(k + 2) % 3]
    return add(add(v, add(a, v, -1), 0.25), add(b, v, -1), 0.1)


def to_plane(column, row, p):
    """From the local frame of a cell to the plane."""
    if (column + row) % 2 == 0:
        return ((column - 0) / 2 + p[0], row * H + p[1])
    return ((column + 1) / 2 + 0.5 - p[0], (row + 1) * H - p[1])


def distance_to_line(p, a, b):
    d = unit(add(b, a, -1))
    return abs((p[0] - a[0]) * d[1] - (p[1] - a[1]) * d[0])


def expected_without_sweep(p, borders, marks):
    v = 0.0
    for k in range(3):
        if borders[k]:
            v = max(v, 1 - 2 * math.sqrt(3) * distance_to_line(p, VERTICES[(k + 1) % 3], VERTICES[(k + 2) % 3]))
        if marks[k]:
            v = max(v, 1 - 3 * math.dist(p, VERTICES[k]))
    return v


def sdl(sides, tiles, pattern, points, form, interior):
    """SDL that writes the pattern's value at each point, one per line."""
    text = [PREFIX,
            "#declare F = function { pigment { pavement number_of_sides %d number_of_tiles %d pattern %d form %d interior %d exterior 0 "
            "color_map { [0 rgb 0] [1 rgb 1] } } }\n" % (sides, tiles, pattern, form, interior),
            "#macro W(X, Z) #local C = F(X, 0, Z); #write (OUT, str(C.red, 0, 5), \"\\n\") #end\n"]
    text += ["W(%.12f,%.12f)\n" % p for p in points]
    text.append("#fclose OUT\n")
    return "".join(text)


def ask(script):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "probe.pov"), "w") as f:
            f.write(script)
        subprocess.run(["povray", "+Iprobe.pov", "+Oignored.png", "+W1", "+H1", "-D", "-GA", "+WT1", "-F"], cwd=folder, env={**os.environ, "HOME": folder},
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300, check=False)
        with open(os.path.join(folder, "out.txt")) as f:
            return [float(line) for line in f]


def measure_squares(tiles, pattern, columns, rows):
    points = [(c + p[0], r + p[1]) for r in range(rows) for c in range(columns) for p in SQUARE_POINTS]
    values = ask(sdl(4, tiles, pattern, points, 3, 0))
    assert len(values) == len(points)
    flags = []
    for i in range(0, len(values), 8):
        left, right, lower, upper = (v > 0.9 for v in values[i:i + 4])
        free = [not (left or lower), not (right or lower), not (left or upper), not (right or upper)]
        marks = [values[i + 4 + k] > 0.9 and free[k] for k in range(4)]
        flags.append(sum(b << k for k, b in enumerate([left, right, lower, upper] + marks)))
    return flags


def measure_triangles(sides, tiles, pattern, columns, rows):
    cells = [(c, r) for r in range(rows) for c in range(columns)]
    local = triangle_points()
    values = ask(sdl(sides, tiles, pattern, [to_plane(c, r, p) for c, r in cells for p in local], 0, 2))
    swept = ask(sdl(sides, tiles, pattern, [to_plane(c, r, sweep_point(k)) for c, r in cells for k in range(3)], 2, 2))
    assert len(values) == 6 * len(cells) and len(swept) == 3 * len(cells)
    flags = []
    for i in range(len(cells)):
        borders = [v > 0.9 for v in values[6 * i:6 * i + 3]]
        marks = [values[6 * i + 3 + k] > 0.9 and not borders[(k + 1) % 3] and not borders[(k + 2) % 3] for k in range(3)]
        word = sum(b << k for k, b in enumerate(borders + marks))
        for k in range(3):
            p, seen = sweep_point(k), swept[3 * i + k]
            candidates = [expected_without_sweep(p, borders, marks)]
            for end in ((k + 1) % 3, (k + 2) % 3):
                candidates.append(min(1.0, max(0.0, 2 * math.sqrt(3) * (math.dist(p, VERTICES[end]) - math.sqrt(3) / 3))))
            best = min(range(3), key=lambda n: abs(candidates[n] - seen))
            assert abs(candidates[best] - seen) < 1e-4, (sides, tiles, pattern, cells[i], k, seen, candidates)
            word |= best << (6 + 2 * k)
        flags.append(word)
    return flags


def main():
    measured = []
    for sides, sizes in PAVEMENTS.items():
        for tiles, (patterns, columns, rows) in enumerate(sizes, 1):
            for pattern in range(1, patterns + 1):
                if sides == 4:
                    flags = measure_squares(tiles, pattern, columns, rows)
                else:
                    flags = measure_triangles(sides, tiles, pattern, columns, rows)
                measured.append((sides, tiles, pattern, columns, rows, flags))
                print(sides, tiles, pattern, file=sys.stderr)
    words = sorted({w for m in measured for w in m[5]})
    alphabet = [chr(c) for c in range(35, 127) if chr(c) not in "\\\""]  # printable, no escapes needed
    assert len(words) <= len(alphabet) ** 2
    wide = len(words) > len(alphabet)
    code = {w: (alphabet[n // len(alphabet)] if wide else "") + alphabet[n % len(alphabet)] for n, w in enumerate(words)}
    print("// Measured from POV-Ray 3.7.0.10 by tools/measure_pavements. Part 1: the words that occur; part 2: per pavement, %s per cell, row by row;"
          % ("two characters" if wide else "one character"))
    print("// character c stands for number c - 35, less 1 above the backslash.")
    print("#ifdef VERISIM_PAVEMENT_WORDS")
    for i in range(0, len(words), 20):
        print(" ".join("0x%03x," % w for w in words[i:i + 20]))
    print("#else")
    for sides, tiles, pattern, columns, rows, flags in measured:
        print("{%d, %d, %d, %d, %d," % (sides, tiles, pattern, columns, rows))
        text = "".join(code[w] for w in flags)
        for i in range(0, len(text), 140):
            print(' "%s"' % text[i:i + 140])
        print("},")
    print("#endif")


if __name__ == "__main__":
    main()
