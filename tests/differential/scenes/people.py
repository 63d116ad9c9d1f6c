"""Scenes as people write them: standard include files, loops with rand, macros, CSG of round numbers, one of everything.

The names of textures and the like are read from the include files that are installed.
"""
import functools
import pathlib
import re

import draw

INCLUDES = pathlib.Path("/usr/share/povray-3.7/include")
FILES = {
    "texture": ["textures", "woods", "stones", "metals", "golds", "glass", "skies", "stars", "finish"],
    "material": ["glass", "textures"],
}
DECLARED = re.compile(r"^\s*#\s*declare\s+(\w+)\s*=\s*(texture|material|pigment|finish|sky_sphere|normal)\b", re.M)


@functools.lru_cache(None)
def names(file, kind):
    """What an include file declares of a kind."""
    try:
        text = (INCLUDES / f"{file}.inc").read_text("latin-1")
    except OSError:
        return []
    return sorted({name for name, what in DECLARED.findall(text) if what == kind and not name.startswith("_")})


COLORS = "White Black Red Green Blue Yellow Cyan Magenta Gray50 Orange Brown NeonBlue Gold SkyBlue Wheat Tan Firebrick Coral".split()


class People(draw.Draw):
    def __init__(self, seed):
        super().__init__(seed)
        self.version = self.one("", "", "3.7", "3.7", "3.7", "3.6", "3.6", "3.5", "3.1", "3.0")
        self.files = ["colors"]

    def include(self, file):
        if file not in self.files:
            self.files.append(file)

    def round(self, low, high):
        return f"{round(self.random.uniform(low, high) * 4) / 4:g}"

    def point(self, size=3):
        return f"<{self.round(-size, size)}, {self.round(0, 2)}, {self.round(-size, size)}>"

    def paint(self):
        name = self.of(COLORS)
        return self.one(
            f"color {name}",
            name,
            f"color {name}*{self.unit()}",
            f"rgb <{self.unit()}, {self.unit()}, {self.unit()}>",
            f"color rgb <{self.unit()}, {self.unit()}, {self.unit()}>",
            f"color red {self.unit()} green {self.unit()} blue {self.unit()}",
            f"rgb {self.unit()}",
        )

    def clear_paint(self):
        return self.one(
            "rgbf <0.9, 1, 0.95, 0.9>", "rgbt <1, 1, 1, 0.7>", "color Clear", "rgbf 0.8", "color rgbf<1,1,1,0.5>",
            "Col_Glass_Bluish" if "glass" in self.files else "rgbf <0.6, 0.7, 1, 0.8>", "rgb 1 filter 0.9",
        )  # fmt: skip

    def finish(self):
        items = self.some(
            [
                f"ambient {self.unit()}", f"diffuse {self.unit()}", f"phong {self.unit()} phong_size {self.integer(5, 120)}",
                f"specular {self.unit()} roughness {self.one('0.001', '0.01', '1/40', '0.1')}", "metallic",
                f"reflection {self.one('0.1', '0.3', '.25', '{0.1, 0.6 fresnel}', '{0.3 metallic}', '{0, 1 falloff 3}')}",
                "brilliance 3", "conserve_energy", "irid { 0.3 thickness 0.5 turbulence 0.2 }", f"reflection {{ {self.unit()} }}",
            ],
            4,
        )  # fmt: skip
        return self.one("", f"finish {{ {' '.join(items)} }}", f"finish {{ {' '.join(items)} }}", f"finish {{ {self.one('Phong_Shiny', 'Shiny', 'Dull', 'Glossy', 'Luminous', 'Mirror')} }}" if self.has("finish") else "")

    def has(self, file):
        self.include(file)
        return True

    def colour_map(self):
        cuts = sorted(self.random.sample(["0.2", "0.3", "0.4", "0.5", "0.6", "0.8"], self.random.randint(0, 3)))
        if self.chance(0.2):
            stops = ["0.0", *cuts, "1.0"]
            return "color_map { " + " ".join(f"[{a} {b} color {self.of(COLORS)} color {self.of(COLORS)}]" for a, b in zip(stops, stops[1:])) + " }"
        return self.one("color_map", "colour_map") + " { " + " ".join(f"[{p} {self.paint()}]" for p in ["0", *cuts, "1"]) + " }"

    def pattern(self):
        p = self.one(
            "marble", "wood", "bozo", "granite", "agate", "spotted", "leopard", "onion", "gradient y", "gradient x", "crackle", "wrinkles",
            "radial", "cells", "spiral1 5", "dents", "bumps", "ripples", "waves", "mandel 30", "julia <0.353, 0.288>, 20", "cylindrical", "spherical", "planar", "boxed",
            "function { x*x + z*z }", "function { abs(sin(3*x)*cos(2*z)) }", "slope y", "quilted", "facets size 0.5",
        )  # fmt: skip
        return p

    def pigment(self):
        r = self.random.random()
        if r < 0.35:
            body = self.paint()
        elif r < 0.5:
            body = self.one(
                f"checker {self.paint()}, {self.paint()}", f"hexagon {self.paint()} {self.paint()} {self.paint()}", f"brick {self.paint()}, {self.paint()} brick_size <1, 0.5, 0.5> mortar 0.05",
                f"checker color {self.of(COLORS)} color {self.of(COLORS)}", f"square {self.paint()} {self.paint()} {self.paint()} {self.paint()}", f"triangular {self.paint()} {self.paint()} {self.paint()} {self.paint()} {self.paint()} {self.paint()}",
            )  # fmt: skip
        else:
            body = f"{self.pattern()} {self.one('', f'turbulence {self.unit()}', 'frequency 3', 'sine_wave', 'octaves 3 turbulence 0.4 omega 0.7', 'warp { turbulence 0.5 octaves 4 }', 'phase 0.3')} {self.colour_map()}"
        return f"pigment {{ {body} {self.one('', '', f'scale {self.positive()}', 'rotate <0, 45, 0>', f'translate {self.vector()}')} }}"

    def normal(self):
        return self.one("", "", "", f"normal {{ {self.pattern()} {self.unit()} scale {self.positive()} }}", f"normal {{ bumps {self.unit()} scale 0.2 }}")

    def texture(self):
        r = self.random.random()
        if r < 0.4:
            file = self.of(FILES["texture"])
            choices = names(file, "texture")
            if choices:
                self.include(file)
                return f"texture {{ {self.of(choices)} {self.one('', f'scale {self.positive()}', 'rotate <0, 30, 45>', self.finish())} }}"
        if r < 0.5:
            return self.pigment()
        if r < 0.6:
            return f"{self.pigment()} {self.finish()} {self.normal()}"
        if r < 0.68:
            return f"texture {{ {self.pigment()} {self.finish()} }} texture {{ pigment {{ {self.pattern()} color_map {{ [0 rgbt 1] [0.5 rgbf <1,0,0,0.8>] [1 {self.paint()}] }} }} }}"
        if r < 0.75:
            return f"texture {{ {self.pattern()} texture_map {{ [0 {self.pigment()} {self.finish()}] [{self.unit()} {self.pigment()}] [1 {self.pigment()} {self.normal()}] }} }}"
        return f"texture {{ {self.pigment()} {self.normal()} {self.finish()} }}"

    def glass(self):
        r = self.random.random()
        choices = names("glass", "material") + names("textures", "material")
        if r < 0.2 and names("glass", "material"):
            self.include("glass")
            return f"material {{ {self.of(names('glass', 'material'))} }}"
        if r < 0.4 and names("glass", "texture"):
            self.include("glass")
            return f"texture {{ {self.of(names('glass', 'texture'))} }} interior {{ {self.one('I_Glass', 'ior 1.5', 'I_Glass1')} }}"
        del choices
        fade = self.one("", f"fade_distance {self.positive()} fade_power {self.one('1', '2', '1001')} fade_color {self.paint()}")
        return f"pigment {{ {self.clear_paint()} }} finish {{ ambient 0 diffuse 0.1 specular 0.8 roughness 0.001 reflection {self.one('0.1', '{0, 1 fresnel on}', '0.05')} {self.one('conserve_energy', '')} }} interior {{ ior {self.one('1.5', '1.33', '1.1', '2.4')} {fade} {self.one('', 'caustics 1', 'dispersion 1.02')} }}"

    def skin(self):
        return self.glass() if self.chance(0.2) else self.texture()

    def simple(self):
        r1, r2 = self.positive(), self.positive()
        return self.one(
            f"sphere {{ {self.point()}, {r1}", f"box {{ <-1, 0, -1>, <1, {r1}, 1>", f"box {{ {self.point()}, {self.point()}",
            f"cylinder {{ <0, 0, 0>, <0, {r1}, 0>, {r2}", f"cylinder {{ {self.point()}, {self.point()}, {r2} {self.one('', 'open')}",
            f"cone {{ <0, 0, 0>, {r1}, <0, 2, 0>, {self.one('0', r2)} {self.one('', 'open')}", f"torus {{ {r1}, {self.one('0.1', '.25', '0.05')}",
            f"superellipsoid {{ <{self.unit()}, {self.one('0.1', '0.3', '1')}>", f"disc {{ {self.point()}, y, {r1}",
        )  # fmt: skip

    def odd_shape(self):
        return self.one(
            f"lathe {{ linear_spline 4, <0, 0>, <{self.positive()}, 0.2>, <0.4, 1>, <0, 1.5>", "lathe { cubic_spline 6, <0,-.5>, <0.8, 0>, <0.5, 0.5>, <0.7, 1>, <0.2, 1.5>, <0, 2>",
            f"sor {{ 6, <0.5, -0.2>, <0.5, 0>, <{self.positive()}, 0.6>, <0.3, 1.2>, <0.4, 1.6>, <0.4, 2>", "prism { linear_sweep linear_spline 0, 0.5, 5, <-1,-1>, <1,-1>, <1,1>, <0, 0.4>, <-1,-1>",
            "prism { cubic_spline 0, 1, 7, <0, -1>, <1, 0>, <0.5, 1>, <-1, 0.5>, <0, -1>, <1, 0>, <0.5, 1>", "prism { conic_sweep linear_spline 0, 1, 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1> rotate 180*x translate y",
            f"text {{ ttf \"timrom.ttf\" \"{self.one('POV', 'Hi!', 'Abg', '3.7')}\" {self.one('0.2', '1', '.1')}, 0", f"text {{ ttf \"crystal.ttf\" \"{self.one('Ray', 'x=1')}\" 0.5, 0.1*x",
            "blob { threshold 0.6 sphere { <0, 0.5, 0>, 1, 1 } sphere { <0.75, 0.5, 0>, 0.8, 1 } cylinder { <-1, 0, 0>, <0, 1, 0.5>, 0.5, 1 }", f"blob {{ threshold 0.5 component 1 1 <0.5, 0, 0> component {self.one('1', '-0.5', '2')} 1 <-0.5, 0.5, 0> sturm",
            "height_field { function 20, 20 { 0.3*f_noise3d(5*x, 5*y, 0) + 0.1*sin(9*x) } smooth translate <-0.5, 0, -0.5> scale <4, 1, 4>", "isosurface { function { x*x + y*y + z*z - 1 + 0.2*sin(8*x)*sin(8*y) } contained_by { box { -1.3, 1.3 } } max_gradient 6 accuracy 0.001",
            "julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 slice <0, 0, 0, 1>, 0", "mesh { triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1.5, 0> } triangle { <-1, 0, 0>, <1, 0, 0>, <0, 0.5, -1> }",
            "sphere_sweep { b_spline 5, <-1, 0, 0>, 0.3, <-0.5, 1, 0>, 0.3, <0, 0, 0.5>, 0.2, <0.5, 1, 0>, 0.3, <1, 0, 0>, 0.3", "sphere_sweep { linear_spline 3, <-1, 0, 0>, 0.3, <0, 1, 0>, 0.2, <1, 0, 0>, 0.3",
            "bicubic_patch { type 1 flatness 0.01 u_steps 3 v_steps 3 <-1,0,-1> <-.3,1,-1> <.3,0,-1> <1,0,-1> <-1,0,-.3> <-.3,1,-.3> <.3,1,-.3> <1,0,-.3> <-1,0,.3> <-.3,1,.3> <.3,2,.3> <1,0,.3> <-1,0,1> <-.3,0,1> <.3,0,1> <1,1,1>",
            "quadric { <1, 1, 1>, <0, 0, 0>, <0, 0, 0>, -1", "quartic { <1,0,0,0,2,0,0,2,0,-2.26,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.74,0,0,0,0,1,0,-2.26,0,0.7569>", "polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>",
        )  # fmt: skip

    def csg(self):
        word = self.one("union", "difference", "intersection", "merge", "difference")
        inner = " ".join(f"{self.simple()} {self.one('', '', self.texture())} }}" for _ in range(self.random.randint(2, 4)))
        if self.chance(0.3):
            inner += f" {self.one('difference', 'union', 'intersection')} {{ {self.simple()} }} {self.simple()} {self.one('', self.texture())} }} }}"
        return f"{word} {{ {inner}"

    def body(self):
        r = self.random.random()
        return self.simple() if r < 0.5 else self.odd_shape() if r < 0.72 else self.csg()

    def moves(self):
        return " ".join(
            self.one("", f"rotate {self.one('y', 'x', 'z')}*{self.integer(-18, 18)}0", f"translate {self.point(4)}", f"scale {self.positive()}", f"rotate <{self.integer(0, 9)}0, {self.integer(0, 36)}0, 0>", f"scale <1, {self.positive()}, 1>")
            for _ in range(self.random.randint(0, 3))
        )  # fmt: skip

    def thing(self):
        extras = self.one("", "", "", "", "no_shadow", "hollow", "no_reflection", "double_illuminate", f"clipped_by {{ plane {{ y, {self.round(0, 1)} }} }}", f"bounded_by {{ sphere {{ 0, {self.integer(4, 9)} }} }}")
        skin, moves = self.skin(), self.moves()
        return f"{self.body()} {self.one(f'{skin} {moves}', f'{moves} {skin}')} {extras} }}"

    def statement(self):
        r = self.random.random()
        if r < 0.55:
            return self.thing()
        if r < 0.7:
            name = self.new_name("thing")
            placed = " ".join(f"object {{ {name} {self.moves()} {self.one('', '', self.skin())} }}" for _ in range(self.random.randint(1, 3)))
            return f"#declare {name} = {self.thing()}{self.one('', ';')} {placed}"
        if r < 0.85:
            count = self.integer(3, 12)
            item = self.one(
                f"sphere {{ <rand(S)*6-3, rand(S)*2, rand(S)*6-3>, 0.2+rand(S)*0.3 pigment {{ rgb <rand(S), rand(S), rand(S)> }} {self.finish()} }}",
                f"object {{ {self.body()} {self.texture()} }} scale 0.3 translate 2*x rotate y*I*360/{count} }}",
                f"box {{ 0, <0.5, 0.5 + I/{count}, 0.5> translate <I*0.5 - 2, 0, 0> {self.pigment()} }}",
                f"cylinder {{ 0, y*(1 + sin(I)), 0.1 translate <cos(I*2*pi/{count})*2, 0, sin(I*2*pi/{count})*2> {self.texture()} }}",
            )
            return f"#declare S = seed({self.integer(1, 999)}); #declare I = 0; #while (I < {count}) {item} #declare I = I + 1; #end"
        if self.version == "3.0":  # which has no macros
            return self.thing()
        if r < 0.93:
            name = self.new_name("macro")
            return f"#macro {name}(P, R) {self.one('union', 'merge', 'difference')} {{ sphere {{ P, R }} box {{ P - R, P + <R, R/2, R> }} {self.texture()} }} #end {name}({self.point()}, {self.positive()}) object {{ {name}(<0, 1, 0>, 0.5) {self.moves()} }}"
        self.include("shapes")
        return f"object {{ {self.one('Round_Box(<-1, 0, -1>, <1, 1, 1>, 0.2, 0)', 'Round_Cylinder(0, y, 0.5, 0.1, 1)', 'Disk_Y', 'Cube', 'Hyperboloid_Y clipped_by { box { -2, 2 } }', 'Round_Cone(0, 0.6, y, 0.3, 0.1, 0)', 'Wedge(40)', 'Supertorus(1, 0.25, 0.45, 0.7, 0.001, 1.2)')} {self.skin()} {self.moves()} }}"

    def light(self):
        place = f"<{self.integer(-20, 20)}, {self.integer(5, 40)}, {self.integer(-40, 5)}>"
        color = self.one("color White", "rgb 1", "White", "color rgb <1,1,1>", "rgb <1, 0.9, 0.8>*0.8", "color Gray50", "color red 1 green 1 blue 0.8", "1", "rgb 1.5")
        extra = self.one(
            "", "", "", "", "shadowless", f"spotlight point_at <0, 0, 0> radius {self.integer(5, 30)} falloff {self.integer(20, 60)} tightness {self.integer(0, 20)}", "fade_distance 20 fade_power 2",
            "area_light <2, 0, 0>, <0, 0, 2>, 3, 3 adaptive 1", "area_light 3*x, 3*y, 4, 4", "parallel point_at <0, 0, 0>", "cylinder point_at <0, 0, 0> radius 3 falloff 5", "spotlight point_at 0 falloff 40",
            "looks_like { sphere { 0, 0.5 pigment { rgb 1 } finish { ambient 1 } } }", "media_attenuation on", "area_light <3, 0, 0>, <0, 3, 0>, 3, 3 circular orient",
        )  # fmt: skip
        return f"light_source {{ {place}{self.one(',', '')} {color} {extra} }}"

    def camera(self):
        place = f"<{self.integer(-6, 6)}, {self.one('1', '2', '3', '5', '0.5', '8')}, {self.integer(-12, -4)}>"
        extra = self.one(
            "", "", "angle 40", "angle 60", "right x*image_width/image_height", "up y right x*4/3", "direction 1.5*z", "right <4/3, 0, 0> up <0, 1, 0> direction <0, 0, 1.2>", "sky <0.2, 1, 0>", "fisheye angle 150", "ultra_wide_angle angle 90", "panoramic",
        )  # fmt: skip
        if self.chance(0.08):
            return f"camera {{ orthographic location {place} look_at <0, 1, 0> right 8*x up 6*y }}"
        return f"camera {{ {self.one('perspective', '', '')} location {place} {extra} look_at {self.one('<0, 1, 0>', '0', '<0, 0.5, 0>', 'y')} }}"

    def sky(self):
        clouds = names("skies", "sky_sphere")
        if clouds and self.chance(0.2):
            self.include("skies")
            return f"sky_sphere {{ {self.of(clouds)} }}"
        return self.one(
            "", f"background {{ {self.paint()} }}", f"background {{ color {self.of(COLORS)} }}", f"sky_sphere {{ pigment {{ gradient y {self.colour_map()} }} }}",
            f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 White] [1 SkyBlue] }} scale 2 translate -1 }} pigment {{ bozo turbulence 0.6 color_map {{ [0 rgbt 1] [0.6 rgbt 1] [1 White] }} scale 0.3 }} }}",
            f"fog {{ distance {self.integer(10, 60)} {self.paint()} }}", f"fog {{ fog_type 2 distance 20 color {self.of(COLORS)} fog_offset 0.2 fog_alt 0.5 turbulence 0.2 }}", f"plane {{ y, 100 pigment {{ bozo turbulence 0.5 color_map {{ [0 White] [1 SkyBlue] }} scale 50 }} finish {{ ambient 1 diffuse 0 }} hollow }}",
            "rainbow { angle 42 width 8 distance 1e4 direction <-0.2, -0.2, 1> jitter 0 color_map { [0 rgbt 1] [0.3 rgbt <1,0,0,0.8>] [0.7 rgbt <0,1,0,0.8>] [1 rgbt 1] } }",
        )  # fmt: skip

    def floor(self):
        return self.one("", f"plane {{ y, {self.one('0', '0', '-1', '-0.5')} {self.texture()} {self.finish()} }}", f"plane {{ y, 0 {self.pigment()} {self.finish()} }}", f"box {{ <-5, -0.5, -5>, <5, 0, 5> {self.texture()} }}", f"plane {{ <0, 1, 0>, 0 pigment {{ checker color {self.of(COLORS)}, color {self.of(COLORS)} }} }}")

    def settings(self):
        gamma = self.one("assumed_gamma 1.0", "assumed_gamma 1", "assumed_gamma 2.2") if self.version in ("3.7", "") or self.chance(0.5) else ""
        more = self.one("", "", "max_trace_level 8", "ambient_light rgb <1, 1, 1>*0.5", "adc_bailout 1/128", "max_trace_level 3", "number_of_waves 5")
        return f"global_settings {{ {gamma} {more} }}" if gamma or more else ""

    def scene(self):
        parts = [self.settings(), self.one("", "", f"#default {{ finish {{ ambient {self.unit()} diffuse 0.8 }} }}", f"#default {{ texture {{ {self.pigment()} {self.finish()} }} }}"), self.camera(), self.sky(), self.floor()]
        parts += [self.light() for _ in range(self.random.randint(1, 3))]
        parts += [self.statement() for _ in range(self.random.randint(2, 7))]
        head = [f'#include "{file}.inc"' for file in self.files]
        return self.version, "\n".join(head + [part for part in parts if part]) + "\n"


def scene(seed):
    """(version, text) of a number."""
    return People(seed).scene()
