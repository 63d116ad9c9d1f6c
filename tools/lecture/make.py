#!/usr/bin/env python3
"""Makes the pages of docs/lecture: their text is in pages/, pictures and numbers come from the program.

    make.py VERISIM          writes docs/lecture
    make.py VERISIM --check  compares the text that would be written with what is there; draws no pictures

In a page, {{expression}} is replaced by the value of a Python expression; the functions of class Lecture may be used.
"""
import html
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
SCENES = os.path.join(ROOT, "scenes")
OUT = os.path.join(ROOT, "docs", "lecture")


class Lecture:
    def __init__(self, verisim, draw):
        self.verisim, self.draw, self.kept = os.path.abspath(verisim), draw, {}

    def call(self, *words):
        done = subprocess.run([self.verisim, *words], capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"verisim {' '.join(words)}: {done.stderr}")
        return done.stdout

    @staticmethod
    def words(scene, width, height, declared):
        return [os.path.join(SCENES, scene), f"+W{width}", f"+H{height}", *(f"Declare={k}={v}" for k, v in declared.items())]

    def picture(self, name, scene, width, height, *switches, caption="", **declared):
        """A rendered picture that may be changed and drawn anew where the program serves the page."""
        if self.draw:
            self.call("render", *self.words(scene, width, height, declared), *switches, "-D", "+O" + os.path.join(OUT, "pictures", name + ".png"))
        text = open(os.path.join(SCENES, scene)).read()
        for key, value in declared.items():
            text = re.sub(rf"(#declare {key} = )[^;]+;", rf"\g<1>{value};", text)
        return (f'<figure class="scene" data-name="{scene}" data-width="{width}" data-height="{height}" data-switches="{" ".join(switches)}">'
                f'<img src="pictures/{name}.png" width="{width}" height="{height}" alt="{html.escape(caption or name)}">'
                f'<figcaption>{caption}</figcaption><details><summary>The scene</summary><textarea spellcheck="false" aria-label="The scene">'
                f"{html.escape(text)}</textarea></details></figure>")

    def rays(self, name, scene, x, y, width, height, direction="30,25", caption="", **declared):
        """The rays of a pixel, drawn."""
        if self.draw:
            self.call("explain", *self.words(scene, width, height, declared), str(x), str(y), "--no-oracle", "--from", direction,
                      "--svg", os.path.join(OUT, "pictures", name + ".svg"))
        return f'<figure><img src="pictures/{name}.svg" width="480" height="360" alt="{html.escape(caption)}"><figcaption>{caption}</figcaption></figure>'

    def story(self, scene, x, y, width, height, **declared):
        """What `verisim explain --json` tells of a pixel: its first ray, with the pixel's `linear` and `stored`."""
        key = (scene, x, y, width, height, tuple(declared.items()))
        if key not in self.kept:
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "story.json")
                self.call("explain", *self.words(scene, width, height, declared), str(x), str(y), "--no-oracle", "--json", file)
                with open(file) as text:
                    told = json.load(text)
            self.kept[key] = dict(told["rays"][0], linear=told["linear"], stored=told["stored"])
        return self.kept[key]


def number(value, digits=3):
    if isinstance(value, (list, tuple)):
        return "(" + ", ".join(number(v, digits) for v in value) + ")"
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".") if digits else f"{value:.0f}"
    return "0" if text == "-0" else text


def question(asked, answer):
    return f'<details class="question"><summary>{asked}</summary><p>{answer}</p></details>'


FRAME = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="stylesheet" href="lecture.css">
<link rel="icon" href="data:,">
</head>
<body>
<nav>{links}</nav>
<main>
<h1>{title}</h1>
{body}
</main>
<footer>Every picture and every number on this page was made by verisim.</footer>
<script src="lecture.js"></script>
</body>
</html>
"""


def pages(lecture):
    sources = []
    for name in sorted(os.listdir(os.path.join(HERE, "pages"))):
        title, body = open(os.path.join(HERE, "pages", name)).read().split("\n", 1)
        sources.append((re.sub(r"^\d+-", "", name), title, body))
    names = {"picture": lecture.picture, "rays": lecture.rays, "story": lecture.story, "n": number, "question": question}
    for i, (name, title, body) in enumerate(sources):
        scope = dict(names)
        exec("import math", scope)

        def value(found):
            expression = found.group(1)
            if "\n" in expression or re.match(r"\s*\w+ = ", expression):
                exec(expression.strip(), scope)
                return ""
            result = eval(expression.strip(), scope)
            return number(result) if not isinstance(result, str) else result

        text = re.sub(r"\{\{(.*?)\}\}", value, body, flags=re.S)
        links = " ".join(f'<a href="{other}"{" aria-current=page" if k == i else ""}>{t}</a>' for k, (other, t, _) in enumerate(sources))
        yield name, FRAME.format(title=title, body=text.strip(), links=links)


def main():
    check = "--check" in sys.argv
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if not check:
        os.makedirs(os.path.join(OUT, "pictures"), exist_ok=True)
    wrong = []
    for name, text in pages(Lecture(sys.argv[1], draw=not check)):
        file = os.path.join(OUT, name)
        if check:
            if not os.path.exists(file) or open(file).read() != text:
                wrong.append(name)
                continue
            for picture in re.findall(r'src="(pictures/[^"]+)"', text):
                if not os.path.exists(os.path.join(OUT, picture)):
                    wrong.append(picture)
        else:
            with open(file, "w") as out:
                out.write(text)
    if wrong:
        sys.exit(f"not as the program makes them (tools/lecture/make.py VERISIM writes them): {', '.join(wrong)}")


if __name__ == "__main__":
    main()
