"""Many renders at once in one process: the program's bytes, no deadlock, no leak."""

import concurrent.futures
import pathlib
import unittest

from support import BALL, Scratch, in_python, program

import numpy as np

import verisim

THREADS, SCENES = 8, 100

# A mesh, area lights, media, radiosity and noise have memories of their own that renders share or make.
TRIANGLES = 20000


def grid():
    n = int((TRIANGLES / 2) ** 0.5) + 1
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    vertices = np.stack([u, v, 0.3 * np.sin(4 * u) * np.cos(3 * v)], -1).reshape(-1, 3)
    i = np.arange(n * n).reshape(n, n)
    lower, upper = (i[:-1, :-1], i[1:, :-1], i[1:, 1:]), (i[:-1, :-1], i[1:, 1:], i[:-1, 1:])
    return vertices, np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in (lower, upper)])


MESH = verisim.Mesh(*grid())
KINDS = [
    ("sphere { <1, 1, 0>, 0.5 pigment { bozo scale 0.2 } normal { bumps 0.5 scale 0.1 } }", {}),
    ("object { M texture { pigment { crackle scale 0.1 } } }", {"M": MESH}),
    ("light_source { <0, 4, -2> rgb 0.5 area_light x, z, 3, 3 adaptive 1 }", {}),
    ("sphere { <1, 0, -1>, 0.7 pigment { rgbt 1 } hollow interior { media { scattering { 1, 0.5 } } } }", {}),
    ("global_settings { radiosity { count 20 nearest_count 3 error_bound 1 } }", {}),
    ("isosurface { function { x*x + y*y + z*z - 0.3 } contained_by { box { -1, 1 } } max_gradient 4 "
     "translate <-1, 1, 0> pigment { granite } }", {}),
]  # fmt: skip


def scene(i):
    extra, declare = KINDS[i % len(KINDS)]
    return BALL.replace("rgb <1, 0.5, 0.2>", f"rgb <1, {i / SCENES}, 0.2>") + extra, declare


def render(i, threads=1):
    text, declare = scene(i)
    return verisim.render(text, 32, 24, threads=threads, declare=declare, name=f"s{i}.pov").png()


class Together(Scratch):
    def test_bytes(self):
        """100 scenes by 8 threads, each render with one thread or with all: the same bytes as alone and as the program's."""
        with concurrent.futures.ThreadPoolExecutor(THREADS) as pool:
            together = list(pool.map(lambda i: render(i, threads=i % 3), range(SCENES)))
        self.assertEqual(together, [render(i) for i in range(SCENES)])
        for i in (0, 2, 3, 4, 5, 99):
            text, declare = scene(i)
            if declare:
                continue
            pathlib.Path(f"s{i}.pov").write_text(text)
            program("render", f"s{i}.pov", "+W32", "+H24", "+Oprogram.png")
            self.assertEqual(together[i], pathlib.Path("program.png").read_bytes(), i)

    def test_one_mesh(self):
        """Threads that ask for the geometry of one new mesh at the same time."""
        for _ in range(5):
            mesh = verisim.Mesh(*grid())
            ask = lambda _: verisim.render(scene(1)[0], 8, 6, declare={"M": mesh}).png()  # noqa: B023, E731
            with concurrent.futures.ThreadPoolExecutor(THREADS) as pool:
                self.assertEqual(len(set(pool.map(ask, range(THREADS)))), 1)

    def test_no_leak(self):
        """What is in use does not grow with the number of renders."""
        code = f"""
import sys; sys.path.insert(0, {str(pathlib.Path(__file__).parent)!r})
import concurrent.futures, gc, threads_test
def resident(): return int(open("/proc/self/statm").read().split()[1]) * 4096
def all_scenes():
    with concurrent.futures.ThreadPoolExecutor(threads_test.THREADS) as pool: list(pool.map(threads_test.render, range({SCENES})))
    gc.collect()
for _ in range(3): all_scenes()
sizes = [resident()]
for _ in range(4):
    all_scenes()
    sizes.append(resident())
print(min(after - before for before, after in zip(sizes, sizes[1:])))
"""
        result = in_python(code, timeout=200)
        self.assertEqual(result.returncode, 0, result.stderr)
        grown = int(result.stdout)
        # Threads that meet otherwise take some memory once; what leaks is taken every time.
        self.assertLess(grown, 1 << 20, f"every {SCENES} renders take {grown >> 10} KiB")


if __name__ == "__main__":
    unittest.main()
