"""The report and `verisim review` in a real headless Chromium: test.py VERISIM [FOLDER FOR SCREENSHOTS]. Exit status 77: no Chromium."""
import json
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "view"))
import browser

VERISIM = os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else "verisim"
KEPT = sys.argv[2] if len(sys.argv) > 2 else None
WIDTH, HEIGHT = 32, 24

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
sphere { <%s, 0, 0>, 1 pigment { rgb <0.9, 0.3, 0.1> } }
"""


def png(file, pixels):
    """pixels(x, y) -> (r, g, b)"""
    rows = b"".join(b"\0" + bytes(v for x in range(WIDTH) for v in pixels(x, y)) for y in range(HEIGHT))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)) +
                  chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def press(page, key):
    page.run("document.body.dispatchEvent(new KeyboardEvent('keydown', { key: arguments[0], bubbles: true, cancelable: true }))", key)


class InBrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.browser = browser.Browser(os.path.join(cls.folder.name, "profile"), (1400, 900))

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def path(self, *names):
        return os.path.join(self.folder.name, *names)


class Report(InBrowser):
    def test_two_thousand_scenes(self):
        for side in ("a", "b"):
            os.mkdir(self.path(side))
        ground = lambda x, y: (8 * x, 10 * y, (7 * x * y) % 256)
        for i in range(2000):
            patch = lambda x, y: (255, 0, 0) if 20 <= x < 26 and 15 <= y < 19 else ground(x, y)
            png(self.path("a", f"scene{i:04}.png"), ground)
            png(self.path("b", f"scene{i:04}.png"), patch if i % 100 == 7 else ground)
        report = self.path("report.html")
        subprocess.run([VERISIM, "diff", self.path("a"), self.path("b"), "--html", report], stdout=subprocess.DEVNULL, check=False)
        page = self.browser
        start = time.monotonic()
        page.open("file://" + report)
        page.until("return document.querySelector('#rows img') && document.querySelector('#rows img').naturalWidth > 0")
        self.assertLess(time.monotonic() - start, 2 if not os.environ.get("VERISIM_SLOW_MACHINE") else 20)
        self.assertEqual(page.run("return document.getElementById('scenes').getAttribute('aria-rowcount')"), "2001")
        slowest = page.run("""let slowest = 0;
            for (let y = 0; y < document.documentElement.scrollHeight; y += 5000) {
              const t = performance.now(); scrollTo(0, y); dispatchEvent(new Event('scroll'));
              document.body.getBoundingClientRect(); slowest = Math.max(slowest, performance.now() - t);
            }
            return slowest""")
        self.assertLess(slowest, 100)
        page.run("scrollTo(0, document.documentElement.scrollHeight); dispatchEvent(new Event('scroll'))")
        page.until("return [...document.querySelectorAll('#rows a')].some(a => a.textContent === 'scene1999.png')")
        # A failing scene opens where it is wrong, both pictures and the difference side by side.
        first = page.run("scrollTo(0, 0); dispatchEvent(new Event('scroll')); return document.querySelector('#rows a').getAttribute('href')")
        page.run("location.hash = arguments[0]", first)
        page.until("return document.getElementById('canvas').dataset.ready === arguments[0]", first[1:])
        left, top, right, bottom = map(float, page.run("return document.getElementById('canvas').dataset.view").split())
        self.assertTrue(left <= 20 and right >= 26 and top <= 15 and bottom >= 19, (left, top, right, bottom))
        self.assertLess(right - left, WIDTH)
        self.assertTrue(page.run("return document.querySelector('[data-mode=all]').getAttribute('aria-pressed') === 'true'"))
        self.assertIn("must be", page.run("return document.getElementById('reason').textContent"))
        if KEPT:
            page.screenshot(os.path.join(KEPT, "report-scene.png"))


class Corners(InBrowser):
    def test_four_corners_of_a_photograph(self):
        ground = lambda x, y: (8 * x, 10 * y, (7 * x * y) % 256)
        png(self.path("render.png"), ground)
        png(self.path("it's a photograph.png"), ground)
        file = self.path("corners.html")
        subprocess.run([VERISIM, "diff", self.path("it's a photograph.png"), self.path("render.png"), "--pick", file], check=True)
        page = self.browser
        page.open("file://" + file)
        page.until("return document.getElementById('photograph').dataset.ready")
        self.assertIn("upper left", page.run("return document.getElementById('ask').textContent"))
        self.assertTrue(page.run("return document.getElementById('result').hidden"))
        wanted = [(3.5, 2.5), (28.5, 3.5), (27.5, 20.5), (4.5, 19.5)]
        for x, y in wanted:
            page.run("""const c = document.getElementById('photograph'), box = c.getBoundingClientRect(), scale = box.width / c.width;
                c.setPointerCapture = () => {};
                for (const kind of ['pointerdown', 'pointermove'])
                  c.dispatchEvent(new PointerEvent(kind, { clientX: box.left + arguments[0] * scale, clientY: box.top + arguments[1] * scale, buttons: 0 }))""", x, y)
        key = lambda name: page.run("document.getElementById('photograph').dispatchEvent(new KeyboardEvent('keydown', { key: arguments[0], cancelable: true }))", name)
        key("ArrowRight")  # the last one, by a pixel
        text = page.run("return document.getElementById('command').textContent")
        numbers = [float(v) for v in text.split("--corners ")[1].split()[0].split(",")]
        for got, value in zip(numbers, [3.5, 2.5, 28.5, 3.5, 27.5, 20.5, 5.5, 19.5]):
            self.assertAlmostEqual(got, value, delta=0.11)
        self.assertIn("corners = [[3.5, 2.5], ", page.run("return document.getElementById('manifest').textContent"))
        if KEPT:
            page.screenshot(os.path.join(KEPT, "corners.png"))
        # What the page says is what the program takes.
        path = {**os.environ, "PATH": os.path.dirname(VERISIM) + os.pathsep + os.environ["PATH"]}
        done = subprocess.run(text + " --json " + self.path("out.json"), shell=True, cwd=self.folder.name, env=path, capture_output=True, text=True)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        self.assertIn("fit", json.load(open(self.path("out.json"))))
        key("Backspace")
        self.assertTrue(page.run("return document.getElementById('result').hidden"))


class Review(InBrowser):
    def setUp(self):
        self.run_folder, self.baseline = self.path("run"), self.path("baseline")
        os.makedirs(self.path("scenes"), exist_ok=True)
        for name in ("one", "two", "three"):
            self.save(name, "0")
        self.compare("--update")
        self.save("two", "0.5")
        self.save("three", "-0.5")
        self.assertEqual(self.compare("--work", self.run_folder), 1)
        self.stored = {name: self.bytes_of(name) for name in ("one", "two", "three")}

    def save(self, name, x):
        with open(self.path("scenes", name + ".pov"), "w") as out:
            out.write(SCENE % x)

    def bytes_of(self, name):
        with open(self.path("baseline", name + ".pov.png"), "rb") as file:
            return file.read()

    def compare(self, *options):
        words = [VERISIM, "compare", self.path("scenes"), "+W64", "+H48", "-A", "--quiet", "--baseline", self.baseline]
        return subprocess.run([*words, *options], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode

    def review(self, *options):
        return subprocess.run([VERISIM, "review", self.run_folder, *options], capture_output=True, text=True)

    def changed(self):
        return [name for name, was in self.stored.items() if self.bytes_of(name) != was]

    def test_accepts_and_refuses_with_keys(self):
        page = self.browser
        program = subprocess.Popen([VERISIM, "review", self.run_folder, "--no-open"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        try:
            address = program.stdout.readline().strip()
            with self.assertRaises(urllib.error.HTTPError):
                urllib.request.urlopen(address.rsplit("/", 2)[0] + "/guessed-token-0000/")
            page.open(address)
            page.until("return document.querySelector('#rows img') && document.querySelector('#rows img').naturalWidth > 0")
            page.run("location.hash = [...document.querySelectorAll('#rows a')].find(a => a.textContent === 'two.pov').getAttribute('href')")
            page.until("return document.getElementById('canvas').dataset.ready && !document.getElementById('review').hidden")
            page.run("document.getElementById('note').value = 'moved on purpose'")
            press(page, "a")  # and the next one that is open comes
            page.until("return document.getElementById('name').textContent === 'three.pov'")
            page.until("return document.getElementById('review-text').textContent.startsWith('1 to decide, 1 accepted')")
            press(page, "r")
            page.until("return document.getElementById('review-text').textContent.startsWith('0 to decide, 1 accepted, 1 refused')")
            if KEPT:
                page.screenshot(os.path.join(KEPT, "review.png"))
            self.assertEqual(self.changed(), [])  # a decision stores nothing yet
            page.run("document.getElementById('store').click()")
            page.until("return document.getElementById('store').disabled")
            self.assertEqual(page.run("return document.getElementById('review-error').textContent"), "")
            self.assertEqual(self.changed(), ["two"])
        finally:
            program.send_signal(signal.SIGINT)
            self.assertEqual(program.wait(20), 1)  # something is refused
            program.stdout.close()
        with open(os.path.join(self.baseline, "baseline.json")) as file:
            self.assertEqual(json.load(file)["scenes"]["two.pov"]["note"], "moved on purpose")
        self.assertIn("0 to decide, 1 refused, 0 accepted", self.review("--status").stdout)

        # In a pull request, and as a file that is read elsewhere.
        self.assertEqual(self.review("--markdown", self.path("review.md"), "--html", self.path("review.html")).returncode, 1)
        with open(self.path("review.md")) as file:
            text = file.read()
        self.assertIn("![](<review_pictures/two.pov.png>)", text)
        self.assertIn("accepted: moved on purpose", text)
        self.assertTrue(os.path.getsize(self.path("review_pictures", "two.pov.png")) > 500)
        page.open("file://" + self.path("review.html"))
        page.until("return document.querySelector('#rows a')")
        page.run("location.hash = [...document.querySelectorAll('#rows a')].find(a => a.textContent === 'two.pov').getAttribute('href')")
        page.until("return document.getElementById('decided').textContent === 'accepted, stored'")
        self.assertTrue(page.run("return document.getElementById('accept').hidden && document.getElementById('note').readOnly"))

        # What is decided on one picture does not hold for another.
        self.save("three", "0.7")
        self.compare("--work", self.run_folder)
        self.assertIn("1 to decide, 0 refused", self.review("--status").stdout)
        self.assertEqual(self.review("--update").returncode, 1)
        self.assertEqual(self.changed(), ["two"])


if __name__ == "__main__":
    if not browser.available():
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:])
