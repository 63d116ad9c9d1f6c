"""Delta debugging of scenes (Zeller and Hildebrandt, "Simplifying and isolating failure-inducing input", 2002).

From the outermost block inwards: statements are left out in ever smaller runs, then blocks are replaced by their
content or left empty, then numbers become rounder ones. Candidates are tried a batch at a time, because POV-Ray takes
hardly longer for ten scenes than for three; the first that still differs in the same way is kept.
"""
import copy
import re
import time

import sdl_text

BATCH = 12
NUMBER = re.compile(r"(?<![\w.#])(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)(?![\w.])")


class Reducer:
    def __init__(self, programs, name, version, difference, end, budget):
        self.programs, self.name, self.version = programs, name, version
        self.difference, self.end, self.budget = difference, end, budget
        self.seen = set()

    def _same(self, other):
        """Is it still this difference? One of a single pixel must not take the place of one of a hundred."""
        mine = self.difference
        if not hasattr(other, "kind") or other.kind != mine.kind:
            return False
        if mine.kind == "picture":
            return other.pixels * 4 >= min(mine.pixels, 60) and (other.largest > 8) == (mine.largest > 8)
        if mine.kind == "messages":  # POV-Ray loses a text that no line end follows
            return other.note.startswith("''") == mine.note.startswith("''")
        if mine.kind == "warnings":
            return other.note[:60] == mine.note[:60]
        return True

    def _first(self, texts):
        """The first of the texts that differs as the scene does, or None."""
        fresh = []
        for text in texts:
            if text not in self.seen:
                self.seen.add(text)
                fresh.append(text)
        status = {
            "picture": ("picture",),
            "messages": ("picture",),
            "warnings": ("picture",),
            "accepted": ("picture",),
            "refused": ("refused",),
            "crashed": ("crashed",),
            "unsupported": ("unsupported",),
        }
        for start in range(0, len(fresh), BATCH):
            part = fresh[start : start + BATCH]
            if time.monotonic() > self.end:
                self.budget = 0
            if self.budget <= 0:
                return None
            found = self.programs.differences(
                self.name, part, self.version, worth=lambda native: native.status in status[self.difference.kind]
            )
            self.budget -= sum(d != "skipped" for d in found)
            for text, difference in zip(part, found):
                if self._same(difference):
                    return text
        return None

    def _without(self, tree, index, start, length):
        copied = copy.deepcopy(tree)
        block = list(sdl_text.blocks(copied))[index]
        del block[start : start + length]
        return sdl_text.render(copied)

    def _drop_statements(self, text):
        index = 0
        while True:
            tree = sdl_text.parse(text)
            blocks = list(sdl_text.blocks(tree)) if tree is not None else []
            if index >= len(blocks) or self.budget <= 0:
                return text
            block = blocks[index]
            length = max(1, len(block) // 2)
            while block and length:
                candidates = [self._without(tree, index, s, length) for s in range(0, len(block), length)][::-1]
                better = self._first(candidates)
                if better:
                    text, tree = better, sdl_text.parse(better)
                    blocks = list(sdl_text.blocks(tree))
                    if index >= len(blocks):
                        break
                    block = blocks[index]
                    length = min(length, max(1, len(block) // 2))
                elif length == 1:
                    break
                else:
                    length //= 2
            index += 1

    @staticmethod
    def _cuts(statement):
        """Parts of a statement that may go: blocks, and words with the numbers that belong to them."""
        for i, item in enumerate(statement):
            if isinstance(item, sdl_text.Block) and item.opening == "{":
                yield i, i + 1
            elif isinstance(item, str) and item[0].isalpha():
                end = i + 1
                while end < len(statement) and isinstance(statement[end], str) and not statement[end][0].isalpha():
                    end += 1
                yield i, end

    def _hoist(self, text):
        """Words and blocks left out of statements, or blocks replaced by what stands in them."""
        changed = True
        while changed and self.budget > 0:
            changed = False
            tree = sdl_text.parse(text)
            candidates = []
            for b, block in enumerate(sdl_text.blocks(tree)):
                for s, statement in enumerate(block):
                    for start, end in self._cuts(statement):
                        copied = copy.deepcopy(tree)
                        del list(sdl_text.blocks(copied))[b][s][start:end]
                        candidates.append(sdl_text.render(copied))
                        if isinstance(statement[start], sdl_text.Block):
                            copied = copy.deepcopy(tree)
                            target = list(sdl_text.blocks(copied))[b]
                            target[s : s + 1] = list(target[s][start])
                            candidates.append(sdl_text.render(copied))
            better = self._first([c for c in candidates if len(c) < len(text)])
            if better:
                text, changed = better, True
        return text

    def _round_numbers(self, text):
        position = 0
        while self.budget > 0:
            match = NUMBER.search(text, position)
            if not match:
                return text
            number = match.group(1)
            rounder = [r for r in ("0", "1", "2", f"{float(number):.1g}") if len(r) < len(number)]
            better = self._first([text[: match.start()] + r + text[match.end() :] for r in rounder])
            if better:
                text = better
            position = match.start() + 1
            while position < len(text) and (text[position].isdigit() or text[position] in ".e"):
                position += 1
        return text

    def reduce(self, text):
        """The smallest scene found that differs likewise; None where the difference does not come again."""
        if not self._first([text]):
            return None if time.monotonic() < self.end else text
        tree = sdl_text.parse(text)
        if tree is None:
            return text
        flat = sdl_text.render(tree)
        if flat != text and not self._first([flat]):
            return text
        text = flat
        for _ in range(3):
            before = text
            text = self._drop_statements(text)
            text = self._hoist(text)
            if text == before:
                break
        return self._round_numbers(text)
