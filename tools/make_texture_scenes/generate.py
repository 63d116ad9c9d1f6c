#!/usr/bin/env python3
"""Writes scenes/textures/: one small scene for every pattern, wave, warp, map and image option, as pigment and as normal.

usage: tools/make_texture_scenes/generate.py [FOLDER]      (default: scenes/textures beside this tool)
The scenes are checked in; run this again after changing the lists below.
"""
import pathlib
import sys

import more

HEADER = """// {title}
#version {version};
global_settings {{ assumed_gamma 1 {settings}}}
camera {{ location <0, 1.6, -4> direction 1.6*z right 1.3333*x up y look_at <0, 0.05, 0> }}
light_source {{ <-4.3, 6.5, -5.6> rgb 1 }}
light_source {{ <5, 3, -4> rgb 0.35 shadowless }}
background {{ rgb <0.1, 0.15, 0.25> }}
{declares}
#declare Sample = texture {{
  {texture}
}}
{objects}
"""
THREE = """sphere { <-1.05, 0, 0>, 0.95 texture { Sample } }
box { -0.72, 0.72 rotate <0, 35, 0> translate <1.05, -0.1, 0.1> texture { Sample } }
plane { y, -1.037 texture { Sample } }"""

MAP = "color_map { [0 rgb <0.1, 0.1, 0.35>] [0.35 rgb <0.9, 0.8, 0.3>] [0.7 rgb <0.75, 0.15, 0.1>] [1 rgb <0.95, 0.95, 0.9>] }"
LISTED = "checker brick hexagon square triangular cubic".split()

# name -> pattern with its own parameters, scaled to show some detail
PATTERNS = {
    "agate": "agate scale 0.6", "agate_turb": "agate agate_turb 0.4 scale 0.5", "boxed": "boxed scale 1.4", "bozo": "bozo scale 0.3",
    "bozo_generator_1": "bozo noise_generator 1 scale 0.3", "bozo_generator_3": "bozo noise_generator 3 scale 0.3", "bumps": "bumps scale 0.25",
    "cells": "cells scale 0.4", "crackle": "crackle scale 0.4", "crackle_solid": "crackle solid scale 0.35", "crackle_form": "crackle form <1, 0, 0> scale 0.4",
    "crackle_metric_1": "crackle metric 1 scale 0.4", "crackle_metric_3": "crackle metric 3 form <1, 1, -1> offset 0.2 scale 0.5",
    "cylindrical": "cylindrical scale 1.3", "dents": "dents scale 0.25", "gradient": "gradient <1, 2, 0.5> scale 0.5", "granite": "granite scale 0.8",
    "granite_generator_1": "granite noise_generator 1 scale 0.8", "granite_generator_3": "granite noise_generator 3 scale 0.8",
    "julia": "julia <0.353, 0.288>, 30 interior 1, 1", "leopard": "leopard scale 0.12", "magnet_1_julia": "magnet 1 julia <0.4, 0.6>, 25 interior 6, 0.5",
    "magnet_1_mandel": "magnet 1 mandel 30", "magnet_2_julia": "magnet 2 julia <0.3, 0.5>, 30 interior 6, 0.5", "magnet_2_mandel": "magnet 2 mandel 30",
    "mandel": "mandel 30", "mandel_exponent": "mandel 25 exponent 5 interior 1, 1", "mandel_exterior_2": "mandel 20 exterior 2, 0.3",
    "mandel_exterior_8": "mandel 20 exterior 8, 3", "marble": "marble turbulence 0.6 scale 0.5", "marble_plain": "marble scale 0.4", "onion": "onion scale 0.4",
    "planar": "planar scale 1.2", "quilted": "quilted scale 0.4", "quilted_controls": "quilted control0 0.2 control1 1.6 scale 0.4", "radial": "radial frequency 6",
    "ripples": "ripples frequency 3 scale 0.4", "spherical": "spherical scale 1.5", "spiral1": "spiral1 3 scale 0.5", "spiral1_turbulence": "spiral1 3 turbulence 0.3 scale 0.6",
    "spiral2": "spiral2 5 scale 0.5", "spotted": "spotted scale 0.25", "waves": "waves frequency 4 phase 0.1 scale 0.6", "wood": "wood turbulence 0.1 scale 0.3",
    "wood_plain": "wood scale 0.3", "wrinkles": "wrinkles scale 0.5", "wrinkles_generator_1": "wrinkles noise_generator 1 scale 0.5",
    "function": "function { sin(x*5)*cos(y*4)*sin(z*6)/2 + 0.5 }", "object": "object { sphere { 0, 0.35 } } warp { repeat 0.5*x } warp { repeat 0.5*y } warp { repeat 0.5*z }",
    "pigment_pattern": "pigment_pattern { checker rgb 0.2, rgb 0.8 scale 0.3 }",
    "slope": "slope y", "slope_range": "slope { <1, 2, -1>, 0.3, 0.9 }", "slope_point_at": "slope { point_at <1, 3, -2> }",
    "slope_altitude": "slope { y*3, 0, 0.9 altitude <0, 2, 1>, -1, 1 }", "aoi": "aoi",
    "image_pattern": 'image_pattern { ppm "../data/small.ppm" interpolate 2 } scale 0.7', "density_file": 'density_file df3 "../data/block.df3" interpolate 1 scale 2 translate -1',
    "density_file_cubic": 'density_file df3 "../data/block.df3" interpolate 2 scale 2 translate -1',
}
PATTERNS |= {f"tiling_{n}": f"tiling {n} scale 0.3 rotate <-25, 10, 5>" for n in range(1, 28)}
PAVEMENTS = {
    "3_4_2": "number_of_sides 3 number_of_tiles 4 pattern 2 interior 1 form 1", "3_6_7": "number_of_sides 3 number_of_tiles 6 pattern 7 exterior 2 form 2",
    "3_5_3": "number_of_sides 3 number_of_tiles 5 pattern 3 exterior 1", "4_5_11": "number_of_sides 4 number_of_tiles 5 pattern 11 interior 2",
    "4_6_28": "number_of_sides 4 number_of_tiles 6 pattern 28 exterior 1 form 2", "4_4_3": "number_of_sides 4 number_of_tiles 4 pattern 3 exterior 2 interior 1 form 3",
    "6_3_2": "number_of_sides 6 number_of_tiles 3 pattern 2 form 1", "6_5_8": "number_of_sides 6 number_of_tiles 5 pattern 8 interior 1",
    "6_4_6": "number_of_sides 6 number_of_tiles 4 pattern 6 interior 2 form 2",
}
PATTERNS |= {f"pavement_{k}": f"pavement {v} scale 0.25 rotate <-25, 10, 5>" for k, v in PAVEMENTS.items()}

LISTS = {
    "checker": "checker rgb <0.9, 0.8, 0.5>, rgb <0.2, 0.2, 0.5> scale 0.35", "checker_default": "checker scale 0.35",
    "brick": "brick rgb 0.7, rgb <0.6, 0.2, 0.15> brick_size <0.5, 0.2, 0.3> mortar 0.04", "brick_default": "brick scale 0.08",
    "hexagon": "hexagon rgb <0.9, 0.3, 0.2>, rgb <0.2, 0.7, 0.3>, rgb <0.2, 0.3, 0.8> scale 0.25 rotate <-25, 10, 5>", "square": "square scale 0.3 rotate <-25, 10, 5>",
    "triangular": "triangular scale 0.3 rotate <-25, 10, 5>", "cubic": "cubic", "checker_pigments": "checker pigment { bozo scale 0.1 } pigment { agate scale 0.2 } scale 0.4",
    "checker_frequency": "checker frequency 0.3 phase 0.1 scale 0.3", "brick_turbulence": "brick turbulence 0.1 scale 0.08",
    "object_list": "object { sphere { 0, 1 translate <-0.6, 0.2, -0.5> } rgb <0.8, 0.7, 0.3>, rgb <0.3, 0.1, 0.4> }",
}
BUILT_IN_MAPS = "agate bozo marble wood radial onion granite".split()
WAVES = "ramp_wave sine_wave triangle_wave scallop_wave cubic_wave".split()
WARPS = {
    "turbulence": "warp { turbulence <0.5, 0.3, 0.2> octaves 4 lambda 2.2 omega 0.6 }", "repeat": "warp { repeat 0.7*x offset <0, 0.2, 0.1> flip <1, 1, 0> }",
    "repeat_twice": "warp { repeat 0.5*x } warp { repeat 0.4*z flip z }", "black_hole": "warp { black_hole <-0.9, 0.3, -0.6>, 0.8 strength 1.6 falloff 1.5 }",
    "black_hole_inverse": "warp { black_hole <-0.9, 0.3, -0.6>, 0.8 strength 1.3 inverse }",
    "black_hole_repeat": "warp { black_hole <0.25, 0.25, 0.25>, 0.2 strength 1.5 repeat <0.6, 0.6, 0.6> turbulence <0.1, 0.1, 0.1> }",
    "cylindrical": "warp { cylindrical orientation y dist_exp 1 }", "spherical": "warp { spherical }", "toroidal": "warp { toroidal orientation y dist_exp 1 major_radius 0.7 }",
    "planar": "warp { planar y, 0.7 }", "cubic": "warp { cubic }", "order": "warp { turbulence 0.3 } scale 0.5 rotate 30*y", "classic_order": "turbulence 0.3 scale 0.5 rotate 30*y",
}
MAPS = {
    "unsorted": "gradient y color_map { [0.5 rgb x] [0.2 rgb y] [0.9 rgb z] }", "duplicates": "gradient x color_map { [0.3 rgb 1] [0.3 rgb <1, 0, 0>] [0.6 rgb <1, 0, 0>] [0.6 rgb z] }",
    "pigment_map": "gradient y pigment_map { [0.2 bozo scale 0.1] [0.5 color rgb <1, 0.5, 0.2>] [0.9 granite scale 0.4] } scale 0.8",
    "pigment_map_turbulence": "gradient y turbulence 0.4 pigment_map { [0.3 checker rgb 1, rgb 0 scale 0.1] [0.7 gradient x scale 0.2] } scale 0.8",
    "average": "average pigment_map { [2 bozo scale 0.2] [gradient x scale 0.3] [0.5 color rgb <1, 0, 0>] }",
    "nested": "wood pigment_map { [0.3 onion pigment_map { [0 color rgb 1] [1 leopard scale 0.05] } scale 0.3] [0.8 color rgb <0.3, 0.1, 0>] } scale 0.5",
    "filter": "gradient y color_map { [0 rgbf <1, 0.8, 0.6, 0.9>] [0.5 rgbt <0.2, 0.5, 0.9, 0.6>] [1 rgb 1] } scale 0.5",
    "quick_color": "bozo scale 0.2 quick_color rgb <1, 0, 0>",
}
NORMALS = {
    "slope_map": "onion 0.6 slope_map { [0 <0, 1>] [0.4 <1, -1>] [0.4 <0.2, 0>] [1 <0.8, 2>] } scale 0.4",
    "normal_map": "gradient x normal_map { [0.2 bumps 0.8 scale 0.2] [0.7 wrinkles 0.5 scale 0.5] } scale <2, 1, 1>",
    "average": "average normal_map { [1 bumps 0.8 scale 0.3] [2 ripples 0.5 scale 0.3] }", "list": "checker normal { bumps 0.6 scale 0.1 }, normal { wood 0.5 scale 0.1 } scale 0.5",
    "facets": "facets size 0.4", "facets_coords": "facets coords 0.5 size 0.3 scale 0.5", "facets_metric": "facets coords 0.6 size 0.2 metric 3",
    "bump_map": 'bump_map { ppm "../data/small.ppm" bump_size 2 interpolate 2 } scale 0.6', "bump_map_plain": 'bump_map { ppm "../data/small.ppm" bump_size 1 } scale 0.6',
    "bump_map_spherical": 'bump_map { ppm "../data/small.ppm" map_type 1 interpolate 2 bump_size 4 }', "accuracy": "granite 0.3 accuracy 0.005 scale 0.8",
    "scaled": "bumps 0.6 scale <0.1, 0.3, 1>", "no_bump_scale": "bumps 0.6 scale <0.1, 0.3, 1> no_bump_scale", "rotated": "wrinkles 0.7 scale <1, 0.2, 0.3> rotate <20, 40, 60>",
    "bumps": "bumps 0.5 scale 0.2", "dents": "dents 0.9 scale 0.2", "wrinkles": "wrinkles 0.6 scale 0.4", "ripples": "ripples 0.4 frequency 3 phase 0.2 scale 0.5",
    "waves": "waves 0.3 frequency 5 phase 0.1 scale 0.6", "quilted": "quilted 0.9 control0 0.3 control1 0.8 scale 0.4", "negative": "bozo -1 scale 0.2",
}
AS_NORMAL = ["agate", "boxed", "bozo", "cells", "crackle", "cylindrical", "gradient", "granite", "julia", "leopard", "mandel", "marble", "onion", "planar", "radial", "spherical",
             "spiral1", "spiral2", "spotted", "wood", "function", "pigment_pattern", "image_pattern", "density_file", "tiling_5", "tiling_22", "tiling_27", "pavement_3_4_2", "object"]
IMAGES = {
    "plain": "", "interpolate_2": "interpolate 2", "interpolate_3": "interpolate 3", "interpolate_4": "interpolate 4", "once": "once", "map_type_1": "map_type 1 interpolate 2",
    "map_type_2": "map_type 2", "map_type_5": "map_type 5 interpolate 2", "repeat": "repeat <3, 2>", "offset": "offset <0.3, 0.6>", "gamma_srgb": "gamma srgb", "gamma_2": "gamma 2.2",
    "filter_all": "filter all 0.6", "transmit_all": "transmit all 0.4",
}
TEXTURES = {
    "layers": "pigment { wood scale 0.3 } finish { phong 0.6 } }\ntexture { pigment { checker rgbt 1, rgbf <0.6, 0.8, 1, 0.6> scale 0.3 } }\ntexture { pigment { bozo "
              "color_map { [0 rgbt 1] [0.6 rgbt 1] [0.7 rgb 1] } scale 0.2 }",
    "texture_map": "gradient y texture_map { [0.2 pigment { rgb x } finish { phong 1 }] [0.8 pigment { bozo scale 0.1 } normal { bumps 0.5 scale 0.1 } finish { reflection 0.3 }] } scale 0.9",
    "texture_list": "checker texture { pigment { rgb <1, 0.9, 0.7> } } texture { pigment { granite scale 0.3 } normal { dents 0.8 scale 0.1 } } scale 0.4",
    "texture_average": "average texture_map { [1 pigment { rgb x } finish { ambient 0.5 }] [2 pigment { checker rgb 1, rgb 0 scale 0.2 } normal { ripples 0.6 scale 0.2 }] }",
    "texture_scaled_normal": "gradient y texture_map { [0.3 pigment { rgb 1 } normal { bumps 0.6 scale 0.3 }] [0.7 pigment { rgb <0.5, 0.7, 1> } normal { wrinkles 0.8 }] } scale <0.4, 1, 0.4>",
    "texture_no_bump_scale": "gradient y texture_map { [0.3 pigment { rgb 1 } normal { bumps 0.6 scale 0.3 }] [0.7 pigment { rgb <0.5, 0.7, 1> }] } no_bump_scale scale <0.5, 1, 0.5>",
    "tiles": "tiles { texture { pigment { rgb <0.8, 0.3, 0.2> } } tile2 texture { pigment { rgb 0.9 } finish { phong 0.8 } } } scale 0.3",
    "material_map": 'material_map { ppm "../data/materials.ppm" texture { pigment { rgb x } } texture { pigment { rgb y } finish { phong 1 } } texture { pigment { agate scale 0.2 } } } scale 0.8',
    "slope_after_normal": "pigment { slope y color_map { [0.3 rgb 0] [0.8 rgb 1] } } normal { bumps 0.7 scale 0.2 }",
    "uv_mapping": "uv_mapping pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 0.1 }",
    "uv_pigment": "pigment { uv_mapping gradient x scale 0.25 color_map { [0 rgb 1] [1 rgb z] } } normal { uv_mapping bumps 0.5 scale 0.05 }",
}


def scenes():
    """(path, texture, global settings, options: declares, object, version) of every scene."""
    for path, texture, settings in plain_scenes():
        yield path, texture, {"settings": settings}
    yield from more.combinations(MAP)


def plain_scenes():
    for name, p in PATTERNS.items():
        yield f"pigments/{name}", f"pigment {{ {p} {'' if name == 'object' else MAP} }}", ""
    for name, p in LISTS.items():
        yield f"lists/{name}", f"pigment {{ {p} }}", ""
    for name in BUILT_IN_MAPS:
        yield f"maps/built_in_{name}", f"pigment {{ {name} scale 0.4 }}", ""
    for wave in WAVES:
        yield f"waves/{wave}", f"pigment {{ onion frequency 2.5 phase 0.3 {wave} {MAP} scale 0.6 }}", ""
    yield "waves/poly_wave", f"pigment {{ onion poly_wave 2.2 {MAP} scale 0.4 }}", ""
    yield "waves/negative_frequency", f"pigment {{ onion frequency -2.5 phase 0.1 {MAP} scale 0.6 }}", ""
    for name, w in WARPS.items():
        yield f"warps/{name}", f"pigment {{ checker rgb <1, 0.9, 0.6>, rgb <0.1, 0.2, 0.4> scale 0.17 {w} }}", ""
        yield f"warps/{name}_smooth", f"pigment {{ bozo scale 0.2 {w} {MAP} }}", ""
    for name, m in MAPS.items():
        yield f"maps/{name}", f"pigment {{ {m} }}", ""
    for name, n in NORMALS.items():
        yield f"normals/{name}", f"pigment {{ rgb <0.85, 0.8, 0.7> }} normal {{ {n} }} finish {{ phong 0.5 phong_size 20 }}", ""
    for name in AS_NORMAL:
        p = PATTERNS[name]
        yield f"normals/height_{name}", f"pigment {{ rgb <0.85, 0.8, 0.7> }} normal {{ {p} }} finish {{ phong 0.5 phong_size 20 }}", ""
    for name, option in IMAGES.items():
        yield f"images/image_map_{name}", f'pigment {{ image_map {{ ppm "../data/small.ppm" {option} }} scale 0.8 }}', ""
    for name, t in TEXTURES.items():
        yield f"textures/{name}", t, ""
    yield "pigments/waves_25", f"pigment {{ waves frequency 4 scale 0.6 {MAP} }}", "number_of_waves 25 "
    yield "pigments/bozo_scene_generator_3", f"pigment {{ bozo scale 0.3 {MAP} }}", "noise_generator 3 "


README = """# Texture scenes

One small scene for every pattern, wave form, warp, map, list, image format and option, kind of normal, density and version, written by
`tools/make_texture_scenes/generate.py`. All {count} are deterministic. At 160x120 without anti-aliasing they are exact (99.99 % of pixels within 1/255), except three that
are a match: `densities/default_map` (media samples on the steps of an onion) and `normals/bump_map_function` and `normals/bump_map_torus` (two pixels each).

    verisim compare scenes/textures +W160 +H120 -A
"""


def images(folder):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "small.ppm").write_text("P3\n4 4\n255\n" + "255 0 0  0 255 0  0 0 255  255 255 0\n0 255 255  255 0 255  64 128 192  32 16 8\n"
                                      "250 240 230  90 60 30  128 128 128  10 90 170\n200 30 90  20 20 20  240 120 0  0 100 50\n")
    (folder / "materials.ppm").write_text("P3\n3 3\n255\n" + "0 0 0  1 0 0  2 0 0\n3 0 0  4 0 0  5 0 0\n6 0 0  255 0 0  1 0 0\n")
    n = 6
    data = bytes([0, n, 0, n, 0, n]) + bytes((37 * x * x + 53 * y + 71 * z * x + 29 * y * z) % 256 for z in range(n) for y in range(n) for x in range(n))
    (folder / "block.df3").write_bytes(data)


def main():
    here = pathlib.Path(__file__).resolve().parent
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent / "scenes" / "textures"
    images(root / "data")
    count = 0
    more.write_images(root / "data")
    for path, texture, options in scenes():
        file = root / (path + ".pov")
        file.parent.mkdir(parents=True, exist_ok=True)
        title = path.split("/")[-1].replace("_", " ") + " (" + path.split("/")[0] + ")"
        objects = options["object"] + "\nplane { y, -1.037 pigment { checker rgb 0.4, rgb 0.7 } }" if "object" in options else THREE
        file.write_text(HEADER.format(title=title, version=options.get("version", "3.7"), settings=options.get("settings", ""), declares=options.get("declares", ""),
                                      texture=texture.replace("\n", "\n  "), objects=objects))
        count += 1
    (root / "README.md").write_text(README.format(count=count))
    print(count, "scenes")


if __name__ == "__main__":
    main()
