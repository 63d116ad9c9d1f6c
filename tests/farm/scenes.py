"""Scenes that a farm must draw as one machine does, each with its switches, and calls of verisim in a folder."""
import pathlib
import subprocess
import sys

SCENES = {
    "radiosity": ("#version 3.7; global_settings { assumed_gamma 1 radiosity { count 80 error_bound 0.4 recursion_limit 2 } }\n"
                  "camera { location <0, 1, -5> look_at 0 } light_source { <3, 5, -6> rgb 1 }\n"
                  "sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.3 } } plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }\n",
                  ["+W192", "+H144", "+A0.1"]),
    "photons": ("#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.02 } }\n"
                "camera { location <0, 2, -5> look_at 0 } light_source { <3, 5, -6> rgb 1 }\n"
                "sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on reflection on } }\n"
                "plane { y, -1 pigment { rgb 0.8 } }\n", ["+W160", "+H120", "+A0.3"]),
    "blur": ("#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { location <0, 1, -5> look_at 0 aperture 0.4 focal_point 0 blur_samples 40 }\n"
             "light_source { <3, 5, -6> rgb 1 area_light x * 2, y * 2, 6, 6 jitter }\n"
             "sphere { <clock * 2 - 1, 0, 0>, 1 pigment { granite } } plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }\n",
             ["+W160", "+H120", "+A0.05", "+AM2", "+R2"]),
    # Some seconds a part of twelve, for what is to be interrupted.
    "slow": ("#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { location <0, 1, -5> look_at 0 }\n"
             "light_source { <3, 5, -6> rgb 1 area_light x * 2, y * 2, 17, 17 jitter }\n"
             "sphere { 0, 1 pigment { granite } normal { bumps 0.4 } finish { reflection 0.4 } } plane { y, -1 pigment { bozo } }\n",
             ["+W480", "+H360", "+A0.0", "+AM2", "+R2"]),
}


class Folder:
    """A folder with the scenes in it, and verisim to be called there."""

    def __init__(self, verisim, path):
        self.verisim, self.path = pathlib.Path(verisim).resolve(), pathlib.Path(path)
        for name, (text, _) in SCENES.items():
            (self.path / f"{name}.pov").write_text(text)
        self.wholes = {}

    def call(self, *words, status=0, **options):
        """Standard output and error; ends the test when the exit status is another one."""
        done = subprocess.run([str(self.verisim), *map(str, words)], cwd=self.path, capture_output=True, text=True, **options)
        if done.returncode != status:
            sys.exit(f"verisim {' '.join(map(str, words))}: status {done.returncode}, not {status}\n{done.stdout}{done.stderr}")
        return done.stdout + done.stderr

    def whole(self, scene):
        """The bytes of one machine."""
        if scene not in self.wholes:
            name = f"whole-{scene}.png"
            self.call("render", f"{scene}.pov", *SCENES[scene][1], "--output", name)
            self.wholes[scene] = (self.path / name).read_bytes()
        return self.wholes[scene]
