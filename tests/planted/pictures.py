"""Faults of whole pictures: what happens to pixels after they have been computed, by a renderer or on their way to a file."""
import math
import random

LINEAR = lambda v: v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4
CODED = lambda v: 12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055


class Image:
    def __init__(self, width, height, samples):
        self.width, self.height = width, height
        self.rows = [[tuple(samples[3 * (y * width + x) + c] / 65535 for c in range(3)) for x in range(width)] for y in range(height)]

    def samples(self):
        return [round(65535 * min(1, max(0, v))) for row in self.rows for pixel in row for v in pixel]

    def at(self, x, y):
        return self.rows[min(self.height - 1, max(0, y))][min(self.width - 1, max(0, x))]

    def between(self, x, y):
        i, j = math.floor(x), math.floor(y)
        u, v = x - i, y - j
        return tuple((1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d)
                     for a, b, c, d in zip(self.at(i, j), self.at(i + 1, j), self.at(i, j + 1), self.at(i + 1, j + 1)))

    def each(self, change):
        """change(pixel, x, y) for every pixel."""
        return [[change(pixel, x, y) for x, pixel in enumerate(row)] for y, row in enumerate(self.rows)]


def of_values(f):
    return lambda image, s: image.each(lambda p, x, y: f(p, s))


def resampled(place):
    """place(u, v, s): where the pixel at u, v, seen from the middle, comes from."""
    def fault(image, s):
        cx, cy = (image.width - 1) / 2, (image.height - 1) / 2

        def pixel(_, x, y):
            u, v = place(x - cx, y - cy, s)
            return image.between(cx + u, cy + v)
        return image.each(pixel)
    return fault


def box(image, part, shape=1):
    """A rectangle somewhere in the picture, of a part of its width."""
    w, h = max(2, round(image.width * part * shape)), max(2, round(image.height * part))
    generator = random.Random(image.width * 1000 + w)
    x, y = generator.randrange(image.width - w), generator.randrange(image.height - h)
    return x, y, x + w, y + h


def in_box(part, change, shape=1):
    def fault(image, s):
        x0, y0, x1, y1 = box(image, part, shape)
        return image.each(lambda p, x, y: change(image, p, x, y, s) if x0 <= x < x1 and y0 <= y < y1 else p)
    return fault


def kernel(weights):
    """A filter of 3x3 pixels; weights(s): of the middle, the sides, the corners."""
    def fault(image, s):
        m, e, c = weights(s)
        def pixel(_, x, y):
            cells = [(m, image.at(x, y))] + [(e, image.at(x + i, y + j)) for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1))] + [
                (c, image.at(x + i, y + j)) for i, j in ((1, 1), (-1, 1), (1, -1), (-1, -1))]
            return tuple(sum(w * p[k] for w, p in cells) for k in range(3))
        return image.each(pixel)
    return fault


def noise(image, s):
    generator = random.Random(5)
    return image.each(lambda p, x, y: tuple(v + generator.gauss(0, s) for v in p))


def specks(color):
    def fault(image, s):
        generator = random.Random(7)
        return image.each(lambda p, x, y: color(p) if generator.random() < s else p)
    return fault


def luma(p):
    return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]


def rolled(s):
    a = math.radians(s)
    return math.cos(a), math.sin(a)


# Name -> (fault of (image, strength), three strengths, what must be named first).
PICTURES = {
    'gamma': (of_values(lambda p, s: tuple(v ** s for v in p)), (0.97, 0.9, 0.4545), 'gamma'),
    'exposure': (of_values(lambda p, s: tuple(CODED(min(1, s * LINEAR(v))) for v in p)), (0.98, 0.9, 0.5), 'brightness'),
    'white balance': (of_values(lambda p, s: (p[0], p[1], CODED(s * LINEAR(p[2])))), (0.97, 0.9, 0.6), 'color balance'),
    'black level': (of_values(lambda p, s: tuple(v + s for v in p)), (1 / 255, 4 / 255, 16 / 255), 'offset|contrast'),
    'contrast': (of_values(lambda p, s: tuple(0.5 + s * (v - 0.5) for v in p)), (0.97, 0.9, 0.7), 'contrast'),
    'saturation': (of_values(lambda p, s: tuple(luma(p) + s * (v - luma(p)) for v in p)), (0.95, 0.7, 0), 'saturation'),
    'channels': (of_values(lambda p, s: tuple(p[i] for i in s)), ((2, 1, 0), (1, 0, 2), (1, 2, 0)), 'swapped channels'),
    'lost channel': (of_values(lambda p, s: tuple(0 if i == s else v for i, v in enumerate(p))), (0, 1, 2), 'channel|color balance'),
    'negative': (of_values(lambda p, s: tuple(1 - v for v in p)), (1,), 'inverted'),
    'few values': (of_values(lambda p, s: tuple(round(v * s) / s for v in p)), (63, 15, 3), 'quantised'),
    'cut off highlights': (of_values(lambda p, s: tuple(min(v, s) for v in p)), (0.8, 0.6, 0.4), 'clipped'),
    'shift': (lambda image, s: image.each(lambda p, x, y: image.between(x - s[0], y - s[1])), ((0.5, 0), (0.5, 0.5), (3, -2)), 'shift'),
    'mirror': (lambda image, s: image.each(lambda p, x, y: image.at(image.width - 1 - x if s & 1 else x, image.height - 1 - y if s & 2 else y)),
               (1, 2, 3), 'mirrored'),
    'zoom': (resampled(lambda u, v, s: (u / s, v / s)), (1.01, 1.03, 1.1), 'zoom'),
    'stretch': (resampled(lambda u, v, s: (u / s, v)), (1.01, 1.03, 1.1), 'stretched|zoom'),
    'roll': (resampled(lambda u, v, s: (rolled(s)[0] * u + rolled(s)[1] * v, rolled(s)[0] * v - rolled(s)[1] * u)), (0.5, 1.5, 5), 'rotation'),
    'blur': (kernel(lambda s: ((1 - s), s / 6, s / 12)), (0.2, 0.5, 0.85), 'blur'),
    'sharpening': (kernel(lambda s: ((1 + s), -s / 6, -s / 12)), (0.2, 0.5, 0.9), 'sharpen'),
    'noise': (noise, (1 / 255, 4 / 255, 16 / 255), 'noise'),
    'fireflies': (specks(lambda p: (1, 1, 1)), (0.0008, 0.005, 0.02), 'speck|few pixels'),
    'dead pixels': (specks(lambda p: (0, 0, 0)), (0.0008, 0.005, 0.02), 'speck|few pixels'),
    'black tile': (in_box(0.15, lambda image, p, x, y, s: tuple(s * v for v in p)), (0.9, 0.5, 0), 'rectangle|tile'),
    'tile elsewhere': (in_box(0.2, lambda image, p, x, y, s: image.at(x + s[0], y + s[1])), ((1, 0), (3, 2), (16, 0)), 'part shifted'),
    'half a picture': (lambda image, s: image.each(lambda p, x, y: p if y < image.height * s else (0, 0, 0)), (0.97, 0.8, 0.5), 'rectangle|rows'),
    'a row': (lambda image, s: image.each(lambda p, x, y: image.at(x, y + s) if y == image.height // 3 else p), (1, 4, 12), 'row'),
    'half resolution': (lambda image, s: image.each(lambda p, x, y: image.at(x // s * s, y // s * s)), (2, 3, 6), 'pixelation'),
    'vignetting': (lambda image, s: image.each(lambda p, x, y: tuple(
        v * (1 - s * ((2 * x / image.width - 1) ** 2 + (2 * y / image.height - 1) ** 2) / 2) for v in p)), (0.03, 0.1, 0.4), 'vignetting'),
}
