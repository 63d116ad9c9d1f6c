"""Mutations of real scenes: statements dropped, doubled, swapped, moved to another block, numbers made rounder."""
import copy
import pathlib
import random
import re

import sdl_text

LARGEST = 30_000  # bytes; longer scenes are slow to render and to reduce


def sources(folder):
    """Scene files below a folder that are small enough, sorted."""
    found = [p for p in sorted(pathlib.Path(folder).rglob("*.pov")) if p.stat().st_size < LARGEST]
    return found or [exit(f"no scenes in {folder}")]


def _statements(tree):
    return [(block, i) for block in sdl_text.blocks(tree) if block.opening in ("", "{") for i in range(len(block))]


def _mutation(tree, r):
    places = _statements(tree)
    if len(places) < 2:
        return
    (block, i), (other, j) = r.choice(places), r.choice(places)
    kind = r.choice(["drop", "double", "swap", "move", "copy", "repeat", "number"])
    if kind == "drop":
        del block[i]
    elif kind == "double":
        block.insert(i, copy.deepcopy(block[i]))
    elif kind == "swap" and len(block) > 1:
        k = r.randrange(len(block))
        block[i], block[k] = block[k], block[i]
    elif kind == "move" and block is other:
        block.insert(j, block.pop(i))
    elif kind == "copy":
        other.insert(j, copy.deepcopy(block[i]))
    elif kind == "repeat":
        block.append(copy.deepcopy(block[i]))
    elif kind == "number":
        numbers = [k for k, t in enumerate(block[i]) if isinstance(t, str) and sdl_text.NUMBER.match(t)]
        if numbers:
            block[i][r.choice(numbers)] = r.choice(["0", "1", "0.5", "2", "10", "-1", "0.001"])


def scene(seed, files, group):
    """(folder of the scene, (version, text)); scenes of one group are mutations of one file, so that they share a batch."""
    r = random.Random(seed)
    path = random.Random(group).choice(files)
    text = path.read_text("latin-1")
    tree = sdl_text.parse(text)
    version = re.match(r"(?:\s|//[^\n]*\n|/\*.*?\*/)*#\s*version\s+([\d.]+)", text, re.S)
    if tree is not None:
        for _ in range(r.randint(0, 3)):
            _mutation(tree, r)
        text = sdl_text.render(tree)
    return str(path.parent), (version.group(1) if version else "", text)
