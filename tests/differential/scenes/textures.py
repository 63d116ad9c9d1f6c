"""Textures: every pattern in every owner with every kind of map, warps, finishes, layers, materials and their interiors."""

PATTERNS = """agate bozo bumps crackle dents granite leopard marble onion spotted wood wrinkles radial ripples waves gradient
 planar cylindrical spherical boxed cells quilted spiral1 spiral2 mandel julia function slope aoi pavement tiling
 density_file image_pattern pigment_pattern facets""".split()
LISTS = ["checker", "hexagon", "brick", "square", "triangular", "cubic", "checker"]
WAVES = ["ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave", "poly_wave 2"]


class Textures:
    """Draws what dresses objects. `d` is the Draw; `shape` draws a small object (for object patterns)."""

    def __init__(self, d):
        self.d = d

    def shape(self):
        return self.d.one(
            "sphere{0,0.5}", "box{0,0.5}", "cylinder{-y,y,0.3}", "union{sphere{0,0.3} box{0.2,0.7}}", "plane{y,0}"
        )

    def pattern(self, owner="pigment"):
        d = self.d
        name = d.of(PATTERNS)
        if name == "facets" and owner != "normal":
            name = "cells"
        if owner == "density" and name in ("slope", "aoi", "facets"):
            name = "spherical"
        return {
            "agate": lambda: "agate" + d.one("", f" agate_turb {d.unit()}"),
            "crackle": lambda: "crackle"
            + d.one("", " solid", " form <1,0,0>", " metric 1", " offset 0.2", " metric 3 form <-1,1,0>"),
            "gradient": lambda: f"gradient {d.direction()}",
            "quilted": lambda: "quilted" + d.one("", " control0 0.3", " control1 1 control0 0"),
            "spiral1": lambda: f"spiral1 {d.integer(1, 5)}",
            "spiral2": lambda: f"spiral2 {d.integer(1, 4)}",
            "mandel": lambda: "mandel 10"
            + d.one("", " exponent 3", " interior 1, 2", " exterior 3,1", " exterior 0,1"),
            "julia": lambda: "julia <0.3,0.5>, 12" + d.one("", " interior 2,1", " exponent 4", " exterior 5, 1"),
            "function": lambda: "function { " + self.function() + " }",
            "slope": lambda: d.one(
                "slope y",
                "slope {y}",
                "slope { y, 0, 0.7 }",
                "slope { <1,1,0> altitude y, -1, 1 }",
                "slope { -z, 0.2, 0.9 altitude x }",
            ),
            "object": lambda: f"object {{ {self.shape()} }}",
            "pavement": lambda: d.one(
                "pavement number_of_sides 4 number_of_tiles 3 pattern 1", "pavement number_of_sides 6", "pavement"
            ),
            "tiling": lambda: f"tiling {d.integer(1, 27)}",
            "density_file": lambda: 'density_file df3 "spiral.df3" interpolate ' + d.one("0", "1", "2"),
            "image_pattern": lambda: 'image_pattern { png "plasma2.png" '
            + d.one("", "interpolate 2", "once", "use_alpha")
            + " }",
            "pigment_pattern": lambda: f"pigment_pattern {{ {d.one('bozo', 'checker rgb 0, rgb 1', 'gradient x', 'rgb 0.5')} }}",
            "facets": lambda: d.one("facets coords 0.5", "facets size 0.3"),
        }.get(name, lambda: name)()

    def function(self):
        return self.d.one(
            "x*x+y*y-z",
            "sin(4*x)*cos(4*y)",
            "abs(x)",
            "x",
            "min(x,y,z)",
            "sqrt(x*x+z*z)",
            "select(x,0,0.5,1)",
            "y-floor(y)",
            "mod(abs(x*3),1)",
            "pow(abs(y),0.5)",
            "(x>0)&(y>0)",
            "atan2(x,z)/pi",
            "exp(-x*x)",
            "max(0,1-abs(x))+y/5",
        )

    def warp(self):
        d = self.d
        return (
            "warp { "
            + d.one(
                "turbulence 0.3",
                "turbulence <0.5,0,0.5> octaves 3 lambda 2 omega 0.4",
                "repeat x",
                "repeat 0.5*y flip x",
                "repeat 2*z offset <0.5,0,0>",
                "black_hole <0.5,0,0>, 0.7",
                "black_hole 0, 1 strength 2 falloff 1 inverse",
                "cylindrical",
                "spherical orientation y",
                "toroidal major_radius 1",
                "planar z, 0",
                "planar",
                "cubic",
                "cylindrical orientation z dist_exp 1",
                "black_hole <0.3,0,-1> 0.5 repeat <1,1,1> turbulence 0.2",
            )
            + " }"
        )

    def modifiers(self, owner, most=3):
        """Modifiers of a pattern, in any order."""
        d = self.d
        choices = [
            d.transform,
            d.transform,
            self.warp,
            lambda: d.of(WAVES),
            lambda: f"frequency {d.one('2', '0.5', '-1', '0', '3')}",
            lambda: f"phase {d.one('0.5', '0.25', '-0.3', '1')}",
            lambda: f"turbulence {d.one('0.3', '<0.5,0,0>', '1', '0')}",
            lambda: f"octaves {d.integer(1, 7)}",
            lambda: f"omega {d.unit()}",
            lambda: f"lambda {d.one('1.5', '2', '3')}",
            lambda: f"noise_generator {d.integer(1, 3)}",
        ]
        return " ".join(c() for c in d.some(choices, most))

    def listed(self, item, owner):
        """A list pattern with items of its owner's kind, some of them left out."""
        d = self.d
        name = d.of(LISTS)
        if item == d.colour and d.chance(0.1):
            return f"object {{ {self.shape()} }} {d.colour()}, {d.colour()}"
        count = {"checker": 2, "brick": 2, "square": 4, "cubic": 6, "triangular": 6}.get(name, 3)
        count = d.one(*[count] * 9, 0, 0, max(0, count - 1)) if d.odd else d.one(count, count, count, 0)
        text = f"{name} " + d.comma().join(item() for _ in range(count))
        if name == "brick":
            text += d.one("", " brick_size <1,0.5,0.7>", " mortar 0.1", " mortar 0.05 brick_size 0.5")
        return text

    def entries(self, item):
        d = self.d
        places = d.one(
            ["0", "1"],
            ["0", "0.5", "1"],
            ["0.2", "0.8"],
            ["0", "0.3", "0.3", "1"],
            ["0", "0.5", "0.5", "0.9"],
            ["0.5"],
            ["0", "0.4", "1"],
        )
        return " ".join(f"[{p}{d.one(' ', ', ') if d.odd else ' '}{item()}]" for p in places)

    def colour_map(self):
        d = self.d
        if d.name("color_map") and d.chance(0.2):
            return f"color_map {{ {d.name('color_map')} }}"
        if d.chance(0.1):
            return "color_map { [0, 0.5 color rgb 1 color rgb x] [0.5, 1 color rgb <0,0,1> color rgb y] }"
        return d.one("color_map", "color_map", "colour_map") + " { " + self.entries(d.colour) + " }"

    def pigment_body(self, depth=2):
        d = self.d
        r = d.random.random()
        if r < 0.3 or depth <= 0:
            body = d.colour(0.15)
        elif r < 0.4 and d.name("pigment"):
            body = d.name("pigment")
        elif r < 0.55:
            items = (d.colour, lambda: "pigment { " + self.pigment_body(depth - 1) + " }")
            body = self.listed(d.one(*items), "pigment")
        elif r < 0.62:
            body = self.image_map()
        else:
            body = self.pattern()
            kind = d.random.random()
            if kind < 0.6:
                body += " " + self.colour_map()
            elif kind < 0.8:
                body += " pigment_map { " + self.entries(lambda: self.pigment_body(depth - 1)) + " }"
            elif kind < 0.9:
                body = "average pigment_map { " + self.entries(lambda: self.pigment_body(depth - 1)) + " }"
        words = [body, self.modifiers("pigment")]
        if d.odd and d.chance(0.06):  # statements in an unusual order, or a second pattern
            words.append(d.one(d.of(["bozo", "gradient y", "wood"]), self.colour_map(), "quick_color rgb x"))
        if d.odd and d.chance(0.2):
            words.insert(0, d.one(d.transform(), "uv_mapping", self.warp()))
        return " ".join(words)

    def image_map(self):
        d = self.d
        return (
            "image_map { "
            + d.one('png "plasma2.png"', 'png "povmap.png"', 'png "fract003.png"', '"plasma2.png"')
            + " "
            + " ".join(
                d.some(
                    [
                        "once",
                        f"map_type {d.one('0', '1', '2', '5')}",
                        f"interpolate {d.one('0', '2', '3', '4')}",
                        "filter all 0.3",
                        "transmit 1, 0.5",
                        "transmit all .2",
                        "filter 0 0.7",
                    ],
                    2,
                )
            )
            + " }"
        )

    def pigment(self, depth=2):
        return "pigment { " + self.pigment_body(depth) + " }"

    def normal_body(self, depth=1):
        d = self.d
        r = d.random.random()
        if r < 0.15 and d.name("normal"):
            body = d.name("normal")
        elif r < 0.3 and depth > 0:
            body = self.listed(lambda: "normal { " + self.normal_body(0) + " }", "normal")
        elif r < 0.4:
            body = (
                'bump_map { png "plasma2.png" ' + d.one("", "bump_size 2", "use_index", "interpolate 2", "once") + " }"
            )
        else:
            body = self.pattern("normal")
            if " " not in body or d.odd and d.chance(0.2):  # with parameters it does not always take an amount
                body += f" {d.one(d.unit(), d.number())}"
            if d.chance(0.25):
                body += " slope_map { " + self.entries(lambda: f"<{d.unit()}, {d.one('0', '1', '-1')}>") + " }"
            elif d.chance(0.2) and depth > 0:
                body += " normal_map { " + self.entries(lambda: self.normal_body(0)) + " }"
        extra = d.one("", "", f"bump_size {d.positive()}", f"accuracy {d.one('0.02', '0.1')}", "no_bump_scale")
        return f"{body} {self.modifiers('normal', 2)} {extra}"

    def normal(self):
        return "normal { " + self.normal_body() + " }"

    def finish_body(self):
        d = self.d
        ambient = lambda: d.one(d.unit(), "rgb <0.2,0.1,0.3>", "color rgb 0.4")  # noqa: E731
        reflection = lambda: d.one(  # noqa: E731
            f"reflection {d.unit()}",
            "reflection { 0.4 }",
            "reflection { 0, 1 fresnel on }",
            "reflection { rgb <0.5,0.4,0.3> falloff 2 }",
            "reflection { 0.1 0.8 metallic }",
            "reflection rgb <0.3,0.2,0.5> reflection_exponent 0.7",
            "reflection { 0.3 exponent 1.5 }",
            "reflection { color rgb 0.2, color rgb 0.6 metallic 0.5 }",
        )
        choices = [
            lambda: f"ambient {ambient()}",
            lambda: f"diffuse {d.unit()}",
            lambda: f"diffuse albedo {d.unit()}",
            lambda: f"diffuse 0.5, {d.unit()}",
            lambda: f"specular {d.unit()}",
            lambda: f"specular albedo {d.unit()} roughness 0.1",
            lambda: f"roughness {d.one('0.01', '0.1', '0.001', '1')}",
            lambda: f"phong {d.unit()}",
            lambda: f"phong_size {d.one('10', '40', '1')}",
            lambda: f"phong albedo {d.unit()}",
            lambda: f"brilliance {d.one('2', '0.5', '1')}",
            lambda: d.one("metallic", "metallic 0.5"),
            reflection,
            reflection,
            lambda: "irid { 0.3 thickness 0.5 turbulence 0.2 }",
            lambda: f"emission {ambient()}",
            lambda: "conserve_energy",
            lambda: f"crand {d.one('0.1', '0')}",
        ]
        name = [d.name("finish")] if d.name("finish") and d.chance(0.3) else []
        return " ".join(name + [c() for c in d.some(choices, 4)])

    def finish(self):
        return "finish { " + self.finish_body() + " }"

    def texture_body(self, depth=1):
        d = self.d
        r = d.random.random()
        if r < 0.15 and d.name("texture"):
            return f"{d.name('texture')} {d.transforms()}" + d.one("", "", " " + self.finish(), " " + self.pigment(1))
        if r < 0.28 and depth > 0:
            return (
                self.pattern()
                + " texture_map { "
                + self.entries(lambda: self.texture_body(depth - 1))
                + " } "
                + self.modifiers("texture", 2)
            )
        if r < 0.36 and depth > 0:
            return (
                self.listed(lambda: "texture { " + self.texture_body(depth - 1) + " }", "texture")
                + " "
                + self.modifiers("texture", 1)
            )
        if r < 0.39 and depth > 0:
            return "average texture_map { " + self.entries(lambda: self.texture_body(depth - 1)) + " }"
        if r < 0.42 and depth > 0:
            return (
                'material_map { png "plasma2.png" texture { '
                + self.texture_body(0)
                + " } texture { "
                + self.texture_body(0)
                + " } } "
            )
        parts = d.some([self.pigment, self.normal, self.finish, d.transform], 3)
        if self.pigment not in parts or d.chance(0.1):
            parts.append(self.pigment)
            d.random.shuffle(parts)
        return " ".join(p() for p in parts)

    def texture(self, depth=1):
        d = self.d
        uv = d.one("", "", "", "", "", "uv_mapping ")
        if d.chance(0.15):
            return (
                f"texture {{ {self.texture_body(0)} }} texture {{ pigment {{ {d.one('bozo', 'wood', 'gradient x')} "
                f"color_map {{ [0 rgbt 1] [1 rgbt <1,{d.unit()},0,{d.unit()}>] }} {d.transforms()} }} {d.one('', self.finish(), self.normal())} }}"
            )
        return f"texture {{ {uv}{self.texture_body(depth)} }}"

    def media_body(self):
        d = self.d
        parts = d.some(
            [
                lambda: f"emission {d.one('0.5', 'rgb <0.3,0.6,1>', '1')}",
                lambda: f"absorption {d.one('0.5', 'rgb <1,0.5,0.2>')}",
                lambda: f"scattering {{ {d.integer(1, 5)}, {d.one('0.3', 'rgb <0.2,0.4,0.6>')} {d.one('', 'extinction 0.5', 'eccentricity 0.4')} }}",
                lambda: f"density {{ {self.pattern('density')} {self.colour_map()} {self.modifiers('density', 1)} }}",
                lambda: f"method {d.integer(1, 3)}",
                lambda: f"intervals {d.integer(1, 3)}",
                lambda: f"samples {d.integer(1, 4)}",
                lambda: f"samples {d.integer(1, 3)}, {d.integer(3, 6)}",
                lambda: "confidence 0.8 variance 1/64",
                lambda: "aa_level 3 aa_threshold 0.1",
                lambda: "jitter 0.5",
                lambda: "ratio 0.7",
                d.transform,
            ],
            5,
        )
        return " ".join(p() for p in parts)

    def media(self):
        return "media { " + self.media_body() + " }"

    def interior_body(self):
        d = self.d
        parts = d.some(
            [
                lambda: f"ior {d.one('1.5', '1.33', '1', '0.8', '2')}",
                lambda: f"caustics {d.unit()}",
                self.media,
                lambda: f"fade_distance {d.positive()}",
                lambda: f"fade_power {d.one('1', '2', '1001')}",
                lambda: f"fade_color {d.colour(0)}",
                lambda: "dispersion 1.05 dispersion_samples 5",
            ],
            3,
        )
        name = [d.name("interior")] if d.name("interior") and d.chance(0.3) else []
        return " ".join(name + [p() for p in parts])

    def interior(self):
        return "interior { " + self.interior_body() + " }"

    def material_body(self):
        d = self.d
        name = [d.name("material")] if d.name("material") and d.chance(0.3) else []
        parts = d.some(
            [
                self.texture,
                self.interior,
                d.transform,
                lambda: f"{self.texture(0)} interior_texture {{ {self.texture_body(0)} }}",
            ],
            3,
        )
        return " ".join(name + [p() for p in parts])

    def material(self):
        return "material { " + self.material_body() + " }"
