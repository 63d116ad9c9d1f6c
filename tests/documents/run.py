#!/usr/bin/env python3
"""Runs what the documents tell their readers to type.

usage: run.py VERISIM SOURCES

Commands are the lines of ```sh blocks in README.md, CONTRIBUTING.md and docs/, the examples of the man pages, and the calls in README's table
with words put in for the capitals. Each is run in a folder that has what the documents speak of, or it is in ELSEWHERE with the test that runs
it: a command that is in neither fails. Besides, options that are written of must be options, commands commands, and links must lead somewhere.
(C++ of docs/embedding.md: the test install.consumer. Python: the tests of python/.)
"""
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <3, 4, -9> rgb 1 }
sphere { 0, 1 + 0.1*clock pigment { rgb <1, .5, .2> } }
plane { y, -1 pigment { checker rgb 1, rgb 0.3 } }
"""
# Commands that build, install or need a cluster, and who runs them.
ELSEWHERE = {
    r"\./(demo|test|package( --check)?)": "continuous integration and hand",
    r"cmake --preset .*|cmake --install .*|ninja .*|ctest .*|apt-get .*": "./test",
    r"bench/.*|build/release/bin/verisim compare scenes/shapes .*": "by hand: long",
    r"python3 tests/(hostile|faults)/run\.py .*": "the tests hostile and faults",
    r"podman .*": "by hand: Containerfile",
    r"tools/aarch64/.*|qemu-aarch64-static .*": "by hand: a cross compiler",
    r"cd editors/vscode|npm .*|VERISIM=verisim npm test|ln -s .*": "ctest -C Editors -R editors.vscode",
    r"verisim lsp( .*)?": "the tests lsp.sessions and lsp.neovim",
    r"(old|new)=.*|verisim compare .*--(test|reference) .*|verisim diff old/ new/ .*": "the test renderers.cycles, with Blender",
    r"verisim review( .*)?": "the test report.browser",
    r"verisim compare verisim\.toml .*": "by hand: docs/photograph.md needs a photograph",
    r"verisim diff photograph\.jpg .*": "by hand: docs/photograph.md needs a photograph",
    r"export SBATCH_.*|verisim-slurm .*|verisim farm .*": "the tests of tests/farm",
}
# Options of other programs in running text.
OF_OTHERS = {"--component": "cmake", "--signal": "sbatch", "--requeue": "sbatch", "--mutate": "tests/differential", "--people": "tests/differential", "--seconds": "tests/hostile", "--most": "tests/faults", "--minutes": "tools/soak"}
# What stands for what in synopses; the longer first.
CAPITALS = [("help WORD", "help sphere"), ("[switches]", "+W32 +H24"), ("SCENE...", "scene.pov"), ("K/N", "1/2"), ("K.vsp", "one.vsp"), ("PARTS...", "parts/*.vsp"), ("FILE", "merged.png"),
            ("SCENE X Y", "scene.pov 16 12 +W32 +H24"), ("SCENE", "scene.pov"), ("A B", "povray.png verisim.png"), ("...", "")]
NEEDS_POVRAY = re.compile(r"^(build/release/bin/)?verisim (compare|bench|explain)\b")


def shell_lines(text):
    for block in re.findall(r"^ *```sh\n(.*?)^ *```", text, re.M | re.S):
        for line in block.splitlines():
            command = re.sub(r"\s#( .*|)$", "", line).strip()
            if command:
                yield from (part.strip() for part in command.split("&&"))


def man_examples(folder):
    for page in sorted(folder.glob("*.1")):
        examples = page.read_text().partition(".SH EXAMPLES\n")[2].partition(".SH")[0]
        for call in re.findall(r"^\.B (.*)$", examples, re.M):
            yield re.sub(r"\\\(aq", "'", call.replace("\\-", "-").replace("\\e", "\\"))


def table_calls(text):
    for cell in re.findall(r"^\| (`verisim .*?) \| ", text, re.M):
        for call in re.findall(r"`(verisim [^`]*)`", cell):
            call = call.split("\\|")[0].split(" | ")[0]
            for written, put in CAPITALS:
                call = call.replace(written, put)
            yield call.strip()


class Playground:
    """A folder with a scene, its picture by two programs, its parts, a folder of scenes and an unsaved buffer."""

    def __init__(self, verisim, povray):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="verisim_documents_"))
        self.povray = povray
        bin_folder = self.folder / "bin"
        for name in (bin_folder, self.folder / "home", self.folder / "scenes", self.folder / "parts", self.folder / "frames"):
            name.mkdir()
        (bin_folder / "verisim").symlink_to(verisim)
        for name in ("scene.pov", "buffer", "scenes/one.pov"):
            (self.folder / name).write_text(SCENE)
        self.environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}", HOME=str(self.folder / "home"))
        for command in ("verisim render scene.pov +W32 +H24 --output verisim.png", "verisim render scene.pov +W32 +H24 --output povray.png"):
            subprocess.run(command, shell=True, cwd=self.folder, env=self.environment, check=True, capture_output=True)
        self.make_parts()

    def make_parts(self):
        for part in (1, 2):
            subprocess.run(["verisim", "render", "scene.pov", "+W32", "+H24", "--part", f"{part}/2", "--output", f"parts/{part}.vsp"],
                           cwd=self.folder, env=self.environment, check=True, capture_output=True)

    def run(self, command):
        """What is wrong, or an empty text."""
        command = re.sub(r"^build/release/bin/|^/usr/bin/", "", command)
        command = re.sub(r"\+([WH])(\d+)00\b", r"+\1\2", command)  # a hundredth of the posters
        if command.startswith("verisim view"):
            return self.view(command)
        if command.startswith("verisim merge"):
            for other in self.folder.glob("parts/*.vsp"):
                other.unlink()
            self.make_parts()
        ended = subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
        return "" if ended.returncode == 0 else f"exit status {ended.returncode}\n{(ended.stdout + ended.stderr).decode(errors='replace')[-1500:]}"

    def view(self, command):
        program = subprocess.Popen([*shlex.split(command), "--no-open"], cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
                                   stderr=subprocess.DEVNULL, text=True)
        address = program.stdout.readline()
        program.send_signal(signal.SIGINT)
        program.wait(timeout=30)
        return "" if address.startswith("http://127.0.0.1:") else f"no address: '{address}'"


def options_known(pages):
    """Every `--option` that a page of the manual lists."""
    return set(re.findall(r"(?<![\w-])--[a-z][a-z0-9-]*", "\n".join(re.sub(r"\\f[BR]", " ", page.read_text().replace("\\-", "-")) for page in pages.glob("*.1"))))


def wrong_words(name, text, sources, known, commands):
    """Options and commands in running text that there are not, and links that lead nowhere."""
    others = r"cmake|ctest|podman|gcc|g\+\+|apt|format\.sh|tools/|bench/|tests/|sweep|\./|pkg-config|git|verisim-slurm|perf|mmdebstrap|sbatch|srun|python|test\.py"
    for code in re.findall(r"`([^`\n]+)`", re.sub(r"```.*?```", "", text, flags=re.S)):
        if not re.search(others, code):
            for option in re.findall(r"(?<![\w-])--[a-z][a-z0-9-]*", code):
                if option not in known:
                    yield f"{name}: there is no option {option} (in `{code}`)"
        command = re.match(r"verisim ([a-z]+)\b", code)
        if command and command[1] not in commands:
            yield f"{name}: there is no command in `{code}`"
    for link in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", re.sub(r"`[^`\n]*`", "", text)):
        if not re.match(r"[a-z]+:", link) and not (sources / name).parent.joinpath(link).exists():
            yield f"{name}: the link {link} leads nowhere"


def main():
    verisim, sources = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    povray = shutil.which("povray")
    if povray and subprocess.run([povray, "--version"], capture_output=True, text=True).stderr.startswith("verisim "):
        povray = None
    pages = pathlib.Path(tempfile.mkdtemp(prefix="verisim_pages_"))
    subprocess.run([verisim, "help", "--pages", pages], check=True)
    known = options_known(pages) | set(OF_OTHERS)
    known |= set(re.findall(r"--[a-z-]+", subprocess.run([verisim, "help", "--help"], capture_output=True, text=True, check=True).stdout))
    commands = {page.stem.partition("-")[2] for page in pages.glob("*.1")} | {"help"}
    documents = [sources / "README.md", sources / "CONTRIBUTING.md", sources / "CHANGELOG.md", *sorted(sources.glob("SECURITY.md")), *sorted(sources.glob("docs/*.md"))]
    places = {}  # command: where it stands
    wrong = []
    for document in documents:
        name, text = str(document.relative_to(sources)), document.read_text()
        wrong += wrong_words(name, text, sources, known, commands)
        if name != "docs/cli.md":  # the man pages have those
            for command in shell_lines(text):
                places.setdefault(command, name)
        if name == "README.md":
            for command in table_calls(text):
                places.setdefault(command, "README.md's table")
    for command in man_examples(pages):
        places.setdefault(command, "the man pages")
    ground = Playground(verisim, povray)
    ran = 0
    for command, place in places.items():
        if any(re.fullmatch(pattern, command) for pattern in ELSEWHERE):
            continue
        if NEEDS_POVRAY.match(command) and not povray:
            continue
        ran += 1
        if fault := ground.run(command):
            wrong.append(f"{place}: `{command}`: {fault}")
    for fault in wrong:
        print(fault)
    print(f"{ran} commands ran of {len(places)}, {len(known)} options, {len(documents)} documents: {len(wrong) or 'nothing'} wrong")
    shutil.rmtree(ground.folder)
    shutil.rmtree(pages)
    return 1 if wrong or ran < 20 else 0


sys.exit(main())
