"""Programs that call POV-Ray. Each makes its own scene and calls whatever `povray` it finds; none of them is changed.

A client is a class: `package`, Debian's name; `needs`, the programs it takes to run it here; `run`, which works in the current folder and
returns the pictures it left there.
"""
import os
import pathlib
import shutil
import subprocess
import time

MOLECULE = """9
ethanol
C 1.168 -0.400 0.000
C 0.000 0.550 0.000
O -1.190 -0.210 0.000
H -1.950 0.380 0.000
H 2.110 0.150 0.000
H 1.130 -1.040 0.890
H 1.130 -1.040 -0.890
H 0.040 1.200 0.890
H 0.040 1.200 -0.890
"""


class Failed(Exception):
    """The client did not do what it was asked for."""


def call(*words, timeout=120):
    """Runs a program; fails with what it said."""
    ended = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=timeout, text=True, errors="replace")
    if ended.returncode != 0:
        raise Failed(f"{' '.join(words)} ended with {ended.returncode}:\n{ended.stdout[-3000:]}")
    return ended.stdout


def write(name, text):
    pathlib.Path(name).write_text(text)


class Screen:
    """An X server without a screen, and hands on the keyboard."""

    def __enter__(self):
        reader, writer = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1200x24", "-nolisten", "tcp"],
                                       pass_fds=[writer], stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as said:
            os.environ["DISPLAY"] = ":" + said.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def window(self, name, seconds=30):
        """Waits for a window whose name matches, and gives it the keyboard."""
        for _ in range(10 * seconds):
            found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", name], capture_output=True, text=True).stdout.split()
            if found:
                time.sleep(0.5)  # it is there before it listens
                subprocess.run(["xdotool", "windowfocus", found[-1]], check=False)
                return
            time.sleep(0.1)
        raise Failed(f"no window '{name}'")

    def keys(self, *keys):
        for key in keys:
            command = "type" if len(key) > 1 and key.isdigit() else "key"
            subprocess.run(["xdotool", command, key], check=True)
            time.sleep(0.2)


def until(condition, what, seconds=60):
    for _ in range(10 * seconds):
        if condition():
            return
        time.sleep(0.1)
    raise Failed(f"no {what} after {seconds} s")


class Ase:
    """The Atomic Simulation Environment, `.render()` of its POV-Ray writer: an INI file; area light with jitter, then depth cueing (fog)."""
    package, needs, noisy = "python3-ase", ["/usr/bin/python3"], True

    def run(self):
        call("/usr/bin/python3", "-c", """
from ase.build import molecule
from ase.io import write
atoms = molecule('CH3CH2OH', vacuum=2)
usual = dict(canvas_width=160, pause=False)
write('plain.pov', atoms, rotation='10x,20y', povray_settings=usual).render()
write('fog.pov', atoms, rotation='10x,20y', povray_settings=dict(
    usual, depth_cueing=True, cue_density=0.02, transparent=False, area_light=None, point_lights=[[(5, 5, 20), 'White']], bondatoms=[(0, 1)],
    textures=['ase2', 'glass', 'jmol'] * 3, transmittances=[0.3] * 9)).render()
""")
        return ["plain.png", "fog.png"]


class Pymol:
    """PyMOL, `ray renderer=1`: tmp_pymol.pov in the current folder, and its picture read again."""
    package, needs = "pymol", ["pymol"]

    def run(self):
        write("picture.pml", "fragment ala\nas sticks\nshow spheres, elem O\nray 160, 120, renderer=1\npng seen.png\n")
        said = call("pymol", "-cq", "picture.pml")
        if "loaded image from 'tmp_pymol.png'" not in said:
            raise Failed("PyMOL did not take the picture:\n" + said[-2000:])
        return ["tmp_pymol.png", "seen.png"]


class Blender:
    """Blender's add-on render_povray, in the background: an INI file with radiosity, its picture read into Blender and saved from there."""
    package, needs, noisy = "blender", ["blender"], True

    def run(self):
        write("render.py", """
import os
import bpy
bpy.ops.preferences.addon_enable(module='render_povray')
scene = bpy.context.scene
scene.render.engine = 'POVRAY_RENDER'
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 160, 120, 100
scene.render.filepath = os.path.abspath('out.png')
bpy.ops.mesh.primitive_torus_add(location=(1.5, 1, 0))
bpy.ops.mesh.primitive_monkey_add(location=(-2, 0, 1))
scene.pov.tempfiles_enable = True
bpy.ops.render.render(write_still=True)
""")
        call("blender", "-b", "--factory-startup", "-P", "render.py")
        return ["out.png"]


class Leocad:
    """LeoCAD's dialog File > Render, by the keyboard: a mesh of bricks; the picture comes through standard output, progress through standard error."""
    package, needs = "leocad", ["leocad", "Xvfb", "xdotool"]

    def run(self):
        write("model.ldr", "0 model\n1 4 0 0 0 1 0 0 0 1 0 0 0 1 3001.dat\n1 1 40 -24 0 1 0 0 0 1 0 0 0 1 3001.dat\n"
                           "1 2 0 -48 20 1 0 0 0 1 0 0 0 1 3005.dat\n")
        settings = pathlib.Path(os.environ["HOME"], ".config/LeoCAD Software/LeoCAD.conf")
        settings.parent.mkdir(parents=True)
        settings.write_text(f"[POVRay]\nPath={shutil.which('povray')}\n")
        with Screen() as screen:
            program = subprocess.Popen(["leocad", "model.ldr"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                screen.window("^LeoCAD$")  # that there is no parts library
                screen.keys("Return")
                screen.window("^model.ldr")
                screen.keys("alt+f", "r")
                screen.window("^Render")
                screen.keys("ctrl+a", "320", "Tab", "ctrl+a", "180", "Tab", "Tab", "Tab", "Tab", "space")
                until(lambda: os.path.exists("model.png") and os.path.getsize("model.png") > 0, "picture of LeoCAD's")
                screen.window("^(LeoCAD|Render)")
                time.sleep(0.5)
            finally:
                program.terminate()
                program.wait()
        return ["model.png"]


class OpenBabel:
    """Open Babel's format pov, whose include file it brings, rendered as its documentation does."""
    package, needs = "openbabel", ["obabel"]

    def run(self):
        write("molecule.xyz", MOLECULE)
        call("obabel", "molecule.xyz", "-O", "molecule.pov", "-xm", "SPF")
        include = next(pathlib.Path("/usr/share/openbabel").rglob("babel_povray3.inc"), None)
        call("povray", "+Imolecule.pov", *([f"+L{include.parent}"] if include else []), "+W160", "+H120", "-D")
        return ["molecule.png"]


class Jmol:
    """Jmol's `write POVRAY`: a scene of macros and the file NAME.pov.ini beside it, with which povray is called."""
    package, needs = "jmol", ["jmol", "Xvfb"]

    def run(self):
        write("molecule.xyz", MOLECULE)
        write("script.spt", 'load molecule.xyz; spacefill 30%; dots on; write POVRAY "molecule.pov"; quit\n')
        with Screen():
            call("jmol", "-o", "-x", "-g160x120", "-s", "script.spt")
        call("povray", "molecule.pov.ini")
        return ["molecule.pov.png"]


class StructureSynth:
    """Structure Synth's template for POV-Ray, filled and rendered by its own script."""
    package, needs = "structure-synth", ["structure-synth", "Xvfb", "xdotool"]

    def run(self):
        here = os.getcwd()
        write("model.es", "set maxdepth 40\n{ hue 20 } r\nrule r { { x 0.9 rz 7 ry 5 s 0.98 hue 11 } r  box  { x 0.5 y 1 } sphere }\n")
        write("script.es", f"""#javascript
Builder.load("{here}/model.es");
Builder.setSize(160, 120);
Builder.build();
Builder.templateRenderToFile("/usr/share/structure-synth/Misc/povray.rendertemplate", "{here}/model.pov", true);
Builder.execute("povray", "+I{here}/model.pov +O{here}/model.png +W160 +H120 +A -D", true);
Builder.execute("touch", "{here}/done", true);
""")
        with Screen() as screen:
            program = subprocess.Popen(["structure-synth", here + "/script.es"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                screen.window("script.es|Structure Synth")
                screen.keys("F5")
                until(lambda: os.path.exists("done"), "end of Structure Synth's script")
            finally:
                program.terminate()
                program.wait()
        return ["model.png"]


CLIENTS = {"ase": Ase, "pymol": Pymol, "blender": Blender, "leocad": Leocad, "openbabel": OpenBabel, "jmol": Jmol, "structure_synth": StructureSynth}
