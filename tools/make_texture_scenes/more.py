"""The rarer options: combinations of generators, waves, projections, image formats, lists, densities and versions. Used by generate.py."""
import struct
import zlib

SMALL = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (0, 255, 255), (255, 0, 255), (64, 128, 192), (32, 16, 8),
         (250, 240, 230), (90, 60, 30), (128, 128, 128), (10, 90, 170), (200, 30, 90), (20, 20, 20), (240, 120, 0), (0, 100, 50)]

NOISY = {"agate": "agate turbulence 0.2 scale 0.5", "bozo": "bozo turbulence 0.4 scale 0.3", "dents": "dents scale 0.25", "granite": "granite turbulence 0.2 scale 0.8",
         "marble": "marble turbulence 0.7 octaves 4 omega 0.6 lambda 2.3 scale 0.4", "spiral1": "spiral1 2 turbulence 0.3 scale 0.5", "spotted": "spotted scale 0.3",
         "wood": "wood turbulence <0.2, 0.1, 0.3> octaves 3 scale 0.3", "wrinkles": "wrinkles scale 0.5", "warp": "leopard warp { turbulence 0.3 } scale 0.1",
         "crackle_solid": "crackle solid scale 0.3"}
CRACKLE = {"form_100": "form <1, 0, 0>", "form_010": "form <0, 1, 0>", "form_001": "form <0, 0, 1>", "form_mixed": "form <-0.5, -0.5, 1>", "metric_1_form": "metric 1 form <0, 1, 0>",
           "metric_2_offset": "offset 0.4", "metric_4": "metric 4", "metric_half": "metric 0.5 form <-1, 2, -1>", "metric_3_solid": "metric 3 solid", "generator_3_solid": "solid noise_generator 3"}
FACETS = {"size_1": "facets size 1", "size_small": "facets size 0.05", "metric_1": "facets size 0.3 metric 1", "metric_4": "facets size 0.3 metric 4",
          "coords_metric_1": "facets coords 0.4 size 0.4 metric 1 scale 0.5", "coords_large": "facets coords 2 size 0.3 scale 0.6"}
WAVES = {"ramp": "ramp_wave", "sine": "sine_wave", "triangle": "triangle_wave", "scallop": "scallop_wave", "cubic": "cubic_wave", "poly": "poly_wave 0.6"}
WAVED = {"agate": "agate scale 0.6", "crackle": "crackle scale 0.4", "granite": "granite scale 0.8", "gradient": "gradient x scale 0.3", "marble": "marble turbulence 0.4 scale 0.5", "wood": "wood scale 0.3"}
LISTED = {"brick": "brick {} brick_size <0.5, 0.2, 0.3> mortar 0.04", "checker": "checker {} scale 0.4", "cubic": "cubic {} rotate 20*y", "hexagon": "hexagon {} scale 0.25 rotate <-25, 10, 5>",
          "object": "object {{ sphere {{ 0, 1 translate <-0.6, 0.2, -0.5> }} {} }}", "square": "square {} scale 0.3 rotate <-25, 10, 5>", "triangular": "triangular {} scale 0.3 rotate <-25, 10, 5>"}
COUNT = {"brick": 2, "checker": 2, "cubic": 6, "hexagon": 3, "object": 2, "square": 4, "triangular": 6}
NORMAL_ITEMS = ["bumps 0.6 scale 0.1", "wood 0.5 scale 0.1", "dents 0.8 scale 0.1", "granite 0.3 scale 0.5", "ripples 0.4 scale 0.2", "wrinkles 0.6 scale 0.3"]
TEXTURE_ITEMS = ["pigment { rgb <1, 0.9, 0.7> }", "pigment { granite scale 0.3 } normal { dents 0.8 scale 0.1 }", "pigment { rgb <0.3, 0.5, 0.9> } finish { phong 1 }",
                 "pigment { bozo scale 0.1 }", "pigment { rgb <0.2, 0.6, 0.3> } finish { specular 0.7 }", "pigment { rgb 0.8 } normal { bumps 0.5 scale 0.1 }"]
PIGMENT_ITEMS = ["bozo scale 0.1", "color rgb <0.9, 0.6, 0.2>", "agate scale 0.2", "gradient x scale 0.1", "color rgb <0.2, 0.3, 0.7>", "granite scale 0.3"]
DENSITIES = {"bozo": "bozo scale 0.4 color_map { [0.3 rgb 0] [0.6 rgb <1, 0.6, 0.2>] [1 rgb 1] }", "spherical": "spherical scale 0.9 color_map { [0 rgb 0] [0.5 rgb <0.2, 0.4, 1>] [1 rgb 1] }",
             "density_map": "gradient y density_map { [0.2 spherical scale 0.9] [0.6 color rgb 0.1] [0.8 boxed scale 0.7] }", "average": "average density_map { [1 spherical] [2 wood scale 0.2] }",
             "list": "checker density { spherical } density { rgb 0.2 } scale 0.4", "turbulence": "cylindrical turbulence 0.3 triangle_wave frequency 2 scale 0.8",
             "marble": "marble turbulence 0.5 sine_wave scale 0.4", "granite": "granite scale 1.2 poly_wave 2", "crackle": "crackle scale 0.4 color_map { [0 rgb 1] [0.2 rgb 0] }",
             "density_file": 'density_file df3 "../data/block.df3" interpolate 1 scale 1.6 translate -0.8', "function": "function { max(0, 1 - x*x*2 - y*y*3 - z*z*2) }",
             "object": "object { box { -0.4, 0.4 } density { rgb 0 } density { rgb <0.3, 1, 0.5> } }", "default_map": "onion scale 0.5"}
# file -> options
IMAGES = {
    "png_palette": ('png "../data/palette.png"', ""), "png_palette_interpolated": ('png "../data/palette.png"', "interpolate 2"), "png_palette_filter": ('png "../data/palette.png"', "filter 2 0.8 filter 5 0.5"),
    "png_palette_transmit": ('png "../data/palette.png"', "transmit 1 0.7 transmit all 0.2"), "png_alpha": ('png "../data/alpha.png"', ""), "png_alpha_interpolated": ('png "../data/alpha.png"', "interpolate 2"),
    "png_alpha_premultiplied": ('png "../data/alpha.png"', "premultiplied 1 interpolate 2"), "png_grey": ('png "../data/grey.png"', ""), "png_grey_gamma_1": ('png "../data/grey.png"', "gamma 1"),
    "png_grey_16": ('png "../data/grey16.png"', "interpolate 2"), "png_rgb_gama": ('png "../data/gama.png"', ""), "png_rgb_gama_overridden": ('png "../data/gama.png"', "gamma 1.5"),
    "tga": ('tga "../data/small.tga"', ""), "bmp": ('bmp "../data/small.bmp"', "interpolate 3"), "pgm": ('pgm "../data/small.pgm"', "interpolate 2"), "without_type": ('"../data/alpha.png"', ""),
    "function": ("function 24, 16 { abs(sin(x*9)*cos(y*7)) }", ""), "function_pigment": ("function 24, 16 { pigment { bozo scale 0.2 color_map { [0 rgb x] [1 rgbt <0, 0, 1, 0.5>] } } }", "interpolate 2"),
}
IMAGES |= {f"map_{m}_interpolate_{i}{o.replace(' ', '_')}": ('ppm "../data/small.ppm"', f"map_type {m} interpolate {i}{o}") for m in (0, 1, 2, 5) for i in (2, 3, 4) for o in ("", " once")}
BUMPS = {"use_index": 'png "../data/palette.png" use_index bump_size 0.4', "use_color": 'png "../data/palette.png" use_color bump_size 2', "interpolate_3": 'ppm "../data/small.ppm" interpolate 3 bump_size 3',
         "interpolate_4": 'ppm "../data/small.ppm" interpolate 4 bump_size 3', "cylindrical": 'ppm "../data/small.ppm" map_type 2 interpolate 2 bump_size 3',
         "torus": 'ppm "../data/small.ppm" map_type 5 interpolate 2 bump_size 3', "once": 'ppm "../data/small.ppm" once interpolate 2 bump_size 3', "function": "function 24, 16 { x*y } bump_size 20"}
PATTERNS_OF_IMAGES = {"use_alpha": 'png "../data/alpha.png" use_alpha', "use_index": 'png "../data/palette.png" use_index', "grey": 'png "../data/grey.png" interpolate 2', "gamma": 'png "../data/alpha.png" gamma 2.2',
                      "once": 'ppm "../data/small.ppm" once', "spherical": 'ppm "../data/small.ppm" map_type 1 interpolate 2', "function": "function 16, 16 { x*x }"}
SURFACE = {  # what looks at the surface
    "slope_texture_map": "slope y texture_map { [0.4 pigment { rgb x }] [0.8 pigment { rgb 1 } finish { phong 1 }] }", "slope_pigment_map": "pigment { slope <1, 2, 0> pigment_map { [0.3 bozo scale 0.1] [0.8 color rgb <0.2, 0.7, 0.2>] } }",
    "slope_normal": "pigment { rgb <0.8, 0.6, 0.5> } normal { slope y normal_map { [0.4 bumps 0.6 scale 0.1] [0.8 ripples 0.5 scale 0.2] } }", "aoi_map": "pigment { aoi pigment_map { [0.5 color rgb x] [0.7 agate scale 0.2] [1 color rgb 1] } }",
    "aoi_texture_map": "aoi texture_map { [0.6 pigment { rgb z }] [0.9 pigment { rgb 1 } finish { reflection 0.2 }] }", "aoi_after_normal": "pigment { aoi color_map { [0.5 rgb 0] [1 rgb 1] } } normal { wrinkles 0.8 scale 0.2 }",
    "slope_waves": "pigment { slope y frequency 4 phase 0.2 triangle_wave }", "aoi_waves": "pigment { aoi frequency 6 sine_wave }",
}
TEXTURES = {
    "layered_in_map": "gradient y texture_map { [0.3 Layered] [0.7 pigment { rgb <0.9, 0.8, 0.6> }] } scale 0.9", "map_in_map": "gradient x texture_map { [0.3 Mapped] [0.7 Layered] } scale 0.8",
    "average_layered": "average texture_map { [1 Layered] [0.5 Mapped] }", "map_turbulence": "wood turbulence 0.2 texture_map { [0.4 Layered] [0.4 pigment { rgb 0.3 } finish { phong 1 }] } scale 0.4",
    "tiles_layered": "tiles { texture { Layered } tile2 texture { Mapped } } scale 0.4", "uv_texture": "uv_mapping texture_map_placeholder", "finish_layers": "pigment { rgb <0.6, 0.3, 0.2> } finish { phong 0.8 ambient 0.2 } }\ntexture { pigment { bozo color_map { [0.4 rgbf 1] [0.6 rgb <0.2, 0.6, 0.3>] } scale 0.2 } normal { bumps 0.4 scale 0.1 } finish { conserve_energy reflection 0.3 }",
    "material_map_palette": 'material_map { png "../data/palette.png" texture { pigment { rgb x } } texture { pigment { rgb y } finish { phong 1 } } texture { Layered } } scale 0.8',
    "material_map_once": 'material_map { ppm "../data/materials.ppm" once texture { pigment { rgb x } } texture { pigment { rgb y } } } scale 0.8',
    "material_map_spherical": 'material_map { ppm "../data/materials.ppm" map_type 1 texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } }',
}
TEXTURES["uv_texture"] = "uv_mapping checker texture { Layered } texture { pigment { rgb 0.9 } } scale 0.1"
DECLARES = ("#declare Layered = texture { pigment { wood scale 0.2 } } texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgb <0.2, 0.3, 0.7>] } scale 0.15 } }\n"
            "#declare Mapped = texture { gradient x texture_map { [0.4 pigment { rgb <1, 0.4, 0.2> }] [0.6 pigment { granite scale 0.4 } finish { phong 0.6 }] } scale 0.5 }")
VERSIONS = {
    "noise": "pigment { bozo turbulence 0.3 scale 0.3 COLORS }", "granite": "pigment { granite scale 0.8 COLORS }", "wrinkles": "pigment { rgb 0.8 } normal { wrinkles 0.5 scale 0.4 }",
    "layers": "pigment { wood scale 0.3 } }\ntexture { pigment { checker rgbf <0.5, 0.25, 0.1, 0.4>, rgbf <0.6, 0.8, 1, 0.6> scale 0.3 }", "image": 'pigment { image_map { png "../data/alpha.png" interpolate 2 } scale 0.8 }',
}


def combinations(color_map):
    """(path, texture, settings, declares, object, version) of every scene."""
    def pigment(p):
        return f"pigment {{ {p} {color_map} }}"

    def normal(n):
        return f"pigment {{ rgb <0.85, 0.8, 0.7> }} normal {{ {n} }} finish {{ phong 0.5 phong_size 20 }}"

    def numbered(kind, items, n):
        return " ".join(f"{kind} {{ {item} }}" for item in items[:n])

    for name, p in NOISY.items():
        for g in (1, 2, 3):
            yield f"generators/{name}_{g}", pigment(f"{p} noise_generator {g}"), {}
    for name in ("dents", "granite", "wrinkles"):
        for g in (1, 3):
            yield f"generators/normal_{name}_{g}", normal(f"{name} 0.5 noise_generator {g} scale 0.3"), {}
    for g in (1, 2, 3):
        yield f"generators/scene_{g}", pigment("marble turbulence 0.6 scale 0.5"), {"settings": f"noise_generator {g} "}
    for name, options in CRACKLE.items():
        yield f"crackle/{name}", pigment(f"crackle {options} scale 0.4"), {}
        yield f"crackle/normal_{name}", normal(f"crackle 0.5 {options} scale 0.4"), {}
    for name, n in FACETS.items():
        yield f"normals/facets_{name}", normal(n), {}
    for name, p in WAVED.items():
        for wave, keyword in WAVES.items():
            yield f"waves/{name}_{wave}", pigment(f"{p} frequency 1.7 phase 0.2 {keyword}"), {}
    for wave, keyword in WAVES.items():
        yield f"waves/normal_{wave}", normal(f"wood 0.6 frequency 2 phase 0.3 {keyword} scale 0.4"), {}
        yield f"waves/normal_slope_map_{wave}", normal(f"onion 0.6 slope_map {{ [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] }} {keyword} scale 0.4"), {}
    for name, form in LISTED.items():
        yield f"lists/{name}_of_normals", normal(form.format(numbered("normal", NORMAL_ITEMS, COUNT[name]))), {}
        yield f"lists/{name}_of_textures", form.format(numbered("texture", TEXTURE_ITEMS, COUNT[name])), {}
        yield f"lists/{name}_of_pigments", "pigment { " + form.format(numbered("pigment", PIGMENT_ITEMS, COUNT[name])) + " }", {}
        if name != "object":
            yield f"lists/{name}_as_height", normal(form.format("0.6")), {}
    for name, d in DENSITIES.items():
        yield f"densities/{name}", "pigment { rgbt 1 }", {"object": f"sphere {{ 0, 1 pigment {{ rgbt 1 }} hollow interior {{ media {{ emission 1.2 density {{ {d} }} }} }} }}"}
    for name, (image, options) in IMAGES.items():
        yield f"images/image_map_{name}", f"pigment {{ image_map {{ {image} {options} }} {'' if 'map_type' in options and 'map_type 0' not in options else 'scale 0.8'} }}", {}
    for name, options in BUMPS.items():
        yield f"normals/bump_map_{name}", normal(f"bump_map {{ {options} }} {'' if 'map_type' in options else 'scale 0.8'}"), {}
    for name, options in PATTERNS_OF_IMAGES.items():
        yield f"images/image_pattern_{name}", pigment(f"image_pattern {{ {options} }} scale 0.8"), {}
    for name, t in SURFACE.items():
        yield f"surface/{name}", t, {}
    for name, t in TEXTURES.items():
        yield f"textures/{name}", t, {"declares": DECLARES}
    for i in range(7):
        yield f"fractals/interior_{i}", pigment(f"julia <0.35, 0.29>, 20 interior {i}, 0.6"), {}
    for i in range(9):
        yield f"fractals/exterior_{i}", pigment(f"mandel 20 exterior {i}, 2.5"), {}
    for e in (3, 4, 7):
        yield f"fractals/mandel_exponent_{e}", pigment(f"mandel 15 exponent {e} interior 1, 1"), {}
        yield f"fractals/julia_exponent_{e}", pigment(f"julia <0.4, 0.5>, 15 exponent {e}"), {}
    for n in (1, 3, 7, 10, 14, 18, 24, 26):
        yield f"normals/height_tiling_{n}", normal(f"tiling {n} scale 0.3 rotate <-25, 10, 5>"), {}
    for name, t in VERSIONS.items():
        for version in ("3.1", "3.5", "3.6"):
            yield f"versions/{name}_{version.replace('.', '_')}", t.replace("COLORS", color_map), {"version": version}
    inside = "sphere { 0, 1 clipped_by { plane { <1, 0.4, 0.6>, 0.2 } } texture { pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.7 } } interior_texture { %s } }"
    yield "textures/interior_texture", "pigment { rgb 0.7 }", {"object": inside % "pigment { bozo scale 0.1 } normal { bumps 0.6 scale 0.1 }"}
    yield "textures/interior_texture_map", "pigment { rgb 0.7 }", {"object": inside % "gradient y texture_map { [0.4 pigment { rgb x }] [0.6 pigment { rgb z } finish { phong 1 }] } scale 0.5"}
    for name, shape in {"sphere": "sphere { 0, 1", "torus": "torus { 0.7, 0.3 rotate -50*x", "box": "box { -0.7, 0.7 rotate <20, 30, 0>"}.items():
        yield f"uv/{name}_texture", "pigment { rgb 0.7 }", {"object": shape + " texture { uv_mapping pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 0.1 } normal { bumps 0.4 scale 0.02 } } }"}
        yield f"uv/{name}_image", "pigment { rgb 0.7 }", {"object": shape + ' uv_mapping texture { pigment { image_map { ppm "../data/small.ppm" interpolate 2 } } } }'}
        yield f"uv/{name}_pigment_and_normal", "pigment { rgb 0.7 }", {"object": shape + " pigment { uv_mapping granite scale 0.3 } normal { uv_mapping ripples 0.5 scale 0.05 } }"}


def png(width, height, color_type, depth, rows, chunks=()):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    body = b"".join(b"\0" + row for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, color_type, 0, 0, 0)) +
            b"".join(chunk(k, d) for k, d in chunks) + chunk(b"IDAT", zlib.compress(body)) + chunk(b"IEND", b""))


def write_images(folder):
    rows = [SMALL[4 * y:4 * y + 4] for y in range(4)]
    flat = lambda row: bytes(v for pixel in row for v in pixel)
    (folder / "palette.png").write_bytes(png(4, 4, 3, 8, [bytes(range(4 * y, 4 * y + 4)) for y in range(4)],
                                             [(b"PLTE", flat(SMALL)), (b"tRNS", bytes([255, 255, 128, 255, 0, 255, 200]))]))
    (folder / "alpha.png").write_bytes(png(4, 4, 6, 8, [bytes(v for x, p in enumerate(row) for v in (*p, 255 - (60 * x + 20 * y))) for y, row in enumerate(rows)]))
    (folder / "grey.png").write_bytes(png(4, 4, 0, 8, [bytes((7 + 61 * x + 19 * y * x + 5 * y) % 256 for x in range(4)) for y in range(4)]))
    (folder / "grey16.png").write_bytes(png(4, 4, 0, 16, [b"".join(struct.pack(">H", (700 + 16100 * x + 4900 * y) % 65536) for x in range(4)) for y in range(4)]))
    (folder / "gama.png").write_bytes(png(4, 4, 2, 8, [flat(row) for row in rows], [(b"gAMA", struct.pack(">I", 55556))]))
    bgr = lambda row: bytes(v for r, g, b in row for v in (b, g, r))
    (folder / "small.tga").write_bytes(struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 4, 4, 24, 0x20) + b"".join(map(bgr, rows)))
    pixels = b"".join(map(bgr, reversed(rows)))
    (folder / "small.bmp").write_bytes(b"BM" + struct.pack("<IHHI", 54 + len(pixels), 0, 0, 54) + struct.pack("<IiiHHIIiiII", 40, 4, 4, 1, 24, 0, len(pixels), 2835, 2835, 0, 0) + pixels)
    (folder / "small.pgm").write_text("P2\n4 4\n255\n" + "\n".join(" ".join(str((40 + 53 * x + 31 * y * y) % 256) for x in range(4)) for y in range(4)) + "\n")
