"""Runs POV-Ray and verisim over many small scenes and says where they differ.

Most of the time of a small scene is POV-Ray's sleeping: 0.6 s a process, 0.2 s a frame. So a batch of scenes is one
animation whose frame K includes the scene K. A scene that POV-Ray refuses ends the animation; it goes on after it.
"""
import os
import pathlib
import re
import shutil
import subprocess
from dataclasses import dataclass, field

WIDTH, HEIGHT, SWITCHES = 0, 0, []
TIMEOUT = 25  # seconds for one scene; what takes longer is left out
ACCURACY = 1  # 8-bit units within which a value is the same


def set_size(width, height):
    """Of the pictures of all runs."""
    global WIDTH, HEIGHT, SWITCHES
    WIDTH, HEIGHT = width, height
    SWITCHES = [f"+W{width}", f"+H{height}", "-A", "-D", "-P", "+FP", "+WT1"]


set_size(32, 24)


@dataclass
class Result:
    """What one program made of one scene."""

    status: str = "none"  # picture | refused | slow | crashed | unsupported
    picture: bytes = b""
    messages: str = ""  # text of #debug and #warning
    warnings: list = field(default_factory=list)
    error: str = ""


@dataclass
class Difference:
    kind: str  # picture | accepted | refused | crashed | unsupported | messages
    pixels: int = 0
    largest: int = 0
    note: str = ""


def _read_ppm(path):
    try:
        data = path.read_bytes()
    except OSError:
        return b""
    size = WIDTH * HEIGHT * 3
    return data[-size:] if len(data) > size else b""


# What only one of the programs says, by intent: experimental features are named one by one, or all together at the end.
OWN = re.compile(
    "experimental feature|#version directive is not the first|no #version directive|assumed_gamma is not set|language version 3.1 or earlier|default gamma"
)


def _messages(text):
    """(what #debug wrote, the warnings with a place) of what a program printed of one frame."""
    match = re.search(r"==== \[Parsing\.\.\.\] =+\n(.*?)(?=^-{70}|^==== \[|\Z)", text, re.S | re.M)
    said, warnings = [], []
    warning = False
    for line in match.group(1).split("\n") if match else []:
        if re.match(r"File '|Parse Warning|Warning|Possible|Fatal|Parse Error|Render failed", line):
            warning = True
            warnings.append(line)
        elif warning and line.startswith(" "):
            warnings[-1] += line
        else:
            warning = False
            said.append(line)
    # The lines they name are those of the token that was read last, which is now and then the next statement's.
    texts = {
        re.sub(r"\s+", " ", w.replace("Possible Parse Error: ", "Warning: ")).partition("Warning: ")[2]
        for w in warnings
        if w.startswith("File") and not OWN.search(w)
    }
    # POV-Ray's progress ends with a carriage return, and now and then stands in a line with what the scene says.
    words = re.sub(r"Parsing \d+K tokens", "", " ".join(said))
    return re.sub(r"\s+", " ", words).strip(), sorted(texts - {""})


def _error(text):
    match = re.search(r"((?:File '[^\n]*)?(?:Parse Error|Fatal error|error)[^\n]*(?:\n [^\n]*)*)", text)
    return re.sub(r"\s+", " ", match.group(1))[:200] if match else text.strip()[-160:]


class Programs:
    def __init__(self, povray, verisim, folder, library=()):
        self.povray, self.verisim = povray, verisim
        self.folder = pathlib.Path(folder)
        self.library = [f"+L{p}" for p in library]
        self.home = self.folder / "home"
        self.home.mkdir(parents=True, exist_ok=True)
        self.environment = dict(os.environ, HOME=str(self.home))

    def _run(self, command, where, seconds):
        try:
            done = subprocess.run(
                ["nice", "-n", "15", *command],
                cwd=where,
                env=self.environment,
                timeout=seconds,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
            )
            if done.returncode in (126, 127):
                raise RuntimeError(f"{command[0]} cannot be run")
            return done.returncode, done.stderr.decode("latin-1")
        except subprocess.TimeoutExpired as late:
            return None, (late.stderr or b"").decode("latin-1")

    def _write(self, name, scenes, version):
        where = self.folder / name
        shutil.rmtree(where, ignore_errors=True)
        where.mkdir(parents=True)
        for number, scene in enumerate(scenes, 1):
            (where / f"s{number}.inc").write_text(scene, "latin-1")
        head = f"#version {version};\n" if version else ""
        (where / "all.pov").write_text(head + '#include concat("s", str(frame_number, 0, 0), ".inc")\n')
        return where

    @staticmethod
    def _picture(where, letter, number, count):
        for name in (f"{letter}{number:0{len(str(count + 1))}d}.ppm", f"{letter}.ppm", f"{letter}{number}.ppm"):
            data = _read_ppm(where / name)
            if data:
                return data
        return b""

    def _frame(self, where, count, number, seconds):
        """verisim's result for one frame: one process a scene, so that a crash is one scene's."""
        code, text = self._run(
            [
                self.verisim,
                "+Iall.pov",
                "+Ov",
                *SWITCHES,
                "--replay",
                *self.library,
                "+KFI1",
                f"+KFF{count + 1}",
                f"+SF{number}",
                f"+EF{number}",
            ],
            where,
            seconds,
        )
        result = Result()
        result.messages, result.warnings = _messages(text)
        result.picture = self._picture(where, "v", number, count)
        if code is None:
            result.status = "slow"
        elif code == 0 and result.picture:
            result.status = "picture"
        elif code < 0 or code > 5:
            result.status, result.error = "crashed", f"status {code}"
        else:
            result.error = _error(text)
            result.status = "unsupported" if "nsupported" in text or "not supported" in text else "refused"
        return result

    def natives(self, where, count, seconds=5):
        return [self._frame(where, count, number, seconds) for number in range(1, count + 1)]

    def oracles(self, where, count, wanted):
        """POV-Ray's results for the frames whose numbers are wanted."""
        results = {number: Result() for number in wanted}
        remaining = sorted(wanted)
        while remaining:
            # Only neighbours can be one animation.
            run = [n for i, n in enumerate(remaining) if n - i == remaining[0]]
            code, text = self._run(
                [
                    self.povray,
                    "+Iall.pov",
                    "+Oo",
                    *SWITCHES,
                    *self.library,
                    "+KFI1",
                    f"+KFF{count + 1}",
                    f"+SF{run[0]}",
                    f"+EF{run[-1]}",
                ],
                where,
                TIMEOUT + 2 * len(run),
            )
            frames = re.split(r"^Rendering frame (\d+) of \d+[^\n]*\n", text, flags=re.M)
            texts = {}
            for number, part in zip(frames[1::2], frames[2::2]):
                frame = run[0] + int(number) - 1  # POV-Ray counts from the first of a subset
                texts[frame] = texts.get(frame, "") + part
            texts = texts or {run[0]: text}
            for last in run:
                picture = self._picture(where, "o", last, count)
                if not picture or last not in texts:
                    break
                results[last].status, results[last].picture = "picture", picture
            for number in run[: run.index(last) + 1]:
                part = texts.get(number, "")
                results[number].messages, results[number].warnings = _messages(part)
                if results[number].status != "picture":
                    results[number].status = "slow" if code is None else "crashed" if code < 0 else "refused"
                    results[number].error = _error(part)
            remaining = [n for n in remaining if n > last]
        return results

    def differences(self, name, scenes, version, worth=lambda native: True):
        """For each scene its Difference, None where the programs agree, or "skipped" (slow, or not worth asking)."""
        where = self._write(name, scenes, version)
        count = len(scenes)
        natives = self.natives(where, count)
        wanted = [n for n, native in enumerate(natives, 1) if native.status != "slow" and worth(native)]
        oracles = self.oracles(where, count, wanted)
        found = [compare(oracles[n], native) if n in oracles else "skipped" for n, native in enumerate(natives, 1)]
        # What include files say by #warning is each program's own matter.
        return [
            None if getattr(d, "kind", "") == "messages" and "#debug" not in scene else d
            for d, scene in zip(found, scenes)
        ]


def compare(oracle, native):
    if oracle.status == "slow" or native.status == "slow" or oracle.status == "crashed":
        return "skipped"
    if native.status == "crashed":
        return Difference("crashed", note=native.error)
    if native.status == "unsupported":
        return Difference("unsupported", note=native.error) if oracle.status == "picture" else None
    if oracle.status != native.status:
        if native.status == "picture":
            return Difference("accepted", note=oracle.error)  # what POV-Ray refuses
        return Difference("refused", note=native.error)
    if oracle.status == "refused":
        return None
    wrong = largest = 0
    for i in range(0, len(oracle.picture), 3):
        d = max(abs(a - b) for a, b in zip(oracle.picture[i : i + 3], native.picture[i : i + 3]))
        wrong += d > ACCURACY
        largest = max(largest, d)
    if wrong:
        return Difference("picture", wrong, largest)
    # POV-Ray breaks long lines, also in the middle of words.
    if "".join(oracle.messages.split()) != "".join(native.messages.split()):
        return Difference("messages", note=f"{oracle.messages[:80]!r} against {native.messages[:80]!r}")
    if bool(oracle.warnings) != bool(native.warnings):  # each has words of its own
        who, what = ("POV-Ray", oracle.warnings) if oracle.warnings else ("verisim", native.warnings)
        return Difference("warnings", note=f"only {who} warns: {what[0]}"[:160])
    return None
