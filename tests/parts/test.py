#!/usr/bin/env python3
"""Parts of a picture, merged, are the file of a whole render: random scenes, sizes, numbers of parts, formats and ways of
sampling, compared to the byte.

    test.py VERISIM [--cases N] [--seed S] [--keep]
"""
import argparse
import pathlib
import random
import subprocess
import sys
import tempfile

HEAD = "#version 3.7;\n"
CAMERA = "camera {{ location <0.3, 1.2, -5> look_at <0, 0.2, 0> {blur} }}\n"
BLUR = "aperture 0.3 focal_point <0, 0, 0> blur_samples 9"
LIGHTS = ["light_source { <3, 5, -6> rgb 1 }\n",
          "light_source { <3, 5, -6> rgb 1 area_light x, y, 3, 3 jitter }\n",
          "light_source { <-4, 6, -3> rgb <0.9, 1, 0.8> spotlight point_at 0 radius 20 falloff 40 }\n"]
OBJECTS = ["sphere { <-0.9, 0.1, 0>, 0.9 pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.3 } }\n",
           "box { <0.3, -0.7, -0.5>, <1.6, 0.6, 0.7> pigment { checker rgb 1 rgb 0.3 scale 0.3 } }\n",
           "torus { 1, 0.25 pigment { granite } rotate 40 * x finish { phong 1 } }\n",
           "sphere { 0, 0.8 pigment { rgbf 0.9 } interior { ior 1.5 } finish { reflection { 0.1, 0.6 fresnel } conserve_energy } }\n",
           "plane { y, -0.8 pigment { bozo color_map { [0 rgb 0.2] [1 rgb <0.6, 0.8, 1>] } } normal { bumps 0.3 } }\n"]
KINDS = {
    "plain": "",
    "radiosity": "global_settings { radiosity { count 30 nearest_count 4 error_bound 0.6 recursion_limit 2 "
                 "pretrace_start 0.08 pretrace_end 0.02 } }\n",
    "photons": "global_settings { photons { spacing 0.05 } }\n"
               "sphere { <0.6, 0.3, -1.2>, 0.4 pigment { rgbf 1 } interior { ior 1.4 } photons { target refraction on } }\n",
    "media": "box { <-2, -0.7, 1>, <2, 1.5, 2> pigment { rgbt 1 } hollow interior { media { scattering { 1, 0.2 } "
             "samples 4, 6 method 2 jitter 0.5 } } }\n",
}
SAMPLING = [["-A"], ["+A0.1", "+AM1"], ["+A0.05", "+AM2", "+R2"], ["+A0.1", "--sampler", "adaptive"]]
FORMATS = [("p.png", []), ("p.png", ["+UA"]), ("p.png", ["+TH", "+FN5"]), ("p.png", ["+FN16"]), ("p.ppm", ["+FP"]), ("p.tga", []),
           ("p.bmp", []), ("p.jpg", []), ("p.tif", []), ("p.exr", []), ("p.hdr", ["+THD2"]),
           ("p.exr", ["--layers", "all"]), ("p.exr", ["--layers", "depth,id"])]


def scene(rng, kind):
    gamma = rng.choice(["", "global_settings { assumed_gamma 1 }\n", "global_settings { assumed_gamma srgb }\n"])
    objects = rng.sample(OBJECTS, rng.randint(1, len(OBJECTS)))
    return (HEAD + gamma + CAMERA.format(blur=BLUR if rng.random() < 0.25 else "") + "".join(rng.sample(LIGHTS, rng.randint(1, 2)))
            + KINDS[kind] + "".join(objects) + ("background { rgbt <0, 0, 0.3, 0.5> }\n" if rng.random() < 0.5 else ""))


def size(rng):
    return rng.choice([(1, 1), (1, rng.randint(2, 90)), (rng.randint(2, 90), 1)]
                      + [(rng.randint(2, 97), rng.randint(2, 97)) for _ in range(9)])


def call(verisim, folder, *arguments):
    done = subprocess.run([verisim, *arguments], cwd=folder, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: status {done.returncode}\n{done.stderr}")


def run_case(verisim, folder, seed):
    rng = random.Random(seed)
    kind = rng.choice(list(KINDS))
    (folder / "scene.pov").write_text(scene(rng, kind))
    width, height = size(rng)
    name, format_words = rng.choice(FORMATS)
    words = ["scene.pov", f"+W{width}", f"+H{height}", f"+BS{rng.choice([4, 8, 16, 32])}", *rng.choice(SAMPLING), *format_words]
    if rng.random() < 0.1:
        words += ["--integrator", "path", "--path-samples", "2"]
    if rng.random() < 0.2 and width > 4 and height > 4:
        words += [f"+SC{rng.randint(1, width // 2)}", f"+ER{rng.randint(height // 2 + 1, height)}"]
    parts = rng.choice([1, 2, 3, 7, rng.randint(1, 64)])
    call(verisim, folder, "render", *words, "+WT2", "--output", f"whole.{name}")
    shared = []
    if rng.random() < 0.6:
        call(verisim, folder, "render", *words, "--part", "prepass", "--output", "prepass.vsp")
        shared = ["--prepass", "prepass.vsp"]
    files = []
    for number in range(1, parts + 1):
        files.append(f"{number}.vsp")
        call(verisim, folder, "render", *words, *shared, f"+WT{rng.randint(1, 2)}", "--part", f"{number}/{parts}", "--output", files[-1])
    rng.shuffle(files)
    call(verisim, folder, "merge", *files, "--output", name)
    if (folder / name).read_bytes() != (folder / f"whole.{name}").read_bytes():
        return f"case {seed}: {kind}, {parts} parts: {' '.join(words)} {' '.join(shared)}"
    for file in folder.glob("*.vsp"):
        file.unlink()
    return None


def main():
    options = argparse.ArgumentParser()
    options.add_argument("verisim")
    options.add_argument("--cases", type=int, default=24)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", action="store_true", help="leave the files of a failed case")
    options = options.parse_args()
    verisim = str(pathlib.Path(options.verisim).resolve())
    failures = []
    for case in range(options.cases):
        with tempfile.TemporaryDirectory(prefix="verisim_parts_") as folder:
            failure = run_case(verisim, pathlib.Path(folder), options.seed + case)
            if failure:
                print(failure)
                failures.append(failure)
                if options.keep:
                    kept = pathlib.Path(tempfile.mkdtemp(prefix="verisim_parts_failed_"))
                    for file in pathlib.Path(folder).iterdir():
                        (kept / file.name).write_bytes(file.read_bytes())
                    print(f"its files: {kept}")
    print(f"{options.cases} cases, {len(failures)} differ from the whole picture")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
