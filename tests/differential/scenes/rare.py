"""What the grammar seldom or never says: subsurface light, light groups, mesh cameras, lenses of their own shape, splines,
arrays, functions of patterns, images that are functions, uv and normal indices, every function of julia fractals, and the
settings and flags that people leave alone. Scenes of `grammar` with such things in place of some of theirs."""
import grammar
import objects
import textures

JULIA = "sqr cube exp reciprocal sin asin sinh asinh cos acos cosh acosh tan atan tanh atanh ln pwr(2.5,0.5)".split()


class Textures(textures.Textures):
    def __init__(self, d, subsurface):
        super().__init__(d)
        self.subsurface = subsurface

    def image(self):
        """An image by what makes it: a file, or a function."""
        d = self.d
        size = d.one("8, 8", "16, 4", "5, 7")
        return d.one(
            f"function {size} {{ {self.function()} }}",
            f"function {size} {{ pattern {{ {self.pattern()} }} }}",
            f"function {size} {{ pigment {{ {self.pattern()} {self.colour_map()} }} }}",
            'png "plasma2.png"',
            'png "povmap.png"',
        )

    def function(self):
        d = self.d
        return d.one(
            super().function,
            lambda: "sinh(x)*cosh(z)-tanh(y)",
            lambda: d.one(
                "acos(max(-1,min(1,x)))/pi",
                "asin(max(-1,min(1,y)))",
                "atan(x*y)",
                "tan(x)",
                "ln(abs(x)+1)",
                "log(abs(y)+1)",
                "acosh(1+x*x)",
                "asinh(z)",
                "atanh(min(0.9,abs(x)))",
                "ceil(x)-int(z)",
                "degrees(x)/90",
                "prod(i,1,3,x+i/2)",
                "sum(i,1,3,x*i/4)",
                "div(x*10,3)/5",
                "select(y-0.2,x,z)",
                "pow(abs(x),1.5)",
                "max(x,y,z)-min(x,y,z)",
                "exp(-x*x-y*y)",
                "(x<y)|(z>=0.5)",
                "abs(x)^0.7",
                "sqrt(abs(x*y*z))",
            ),
            lambda: f"{d.name('function')}(x,y,z)" if d.name("function") else "x*y",
            lambda: f"{d.name('pigment_function')}(x,y,z).{d.one('red', 'gray', 'green', 'x', 'transmit')}"
            if d.name("pigment_function")
            else "z",
        )()

    def pattern(self, owner="pigment"):
        d = self.d
        if d.chance(0.75):
            return super().pattern(owner)
        return d.one(
            lambda: "function { " + self.function() + " }",
            lambda: f"image_pattern {{ {self.image()} {d.one('', 'interpolate 2', 'once', 'map_type 1', 'map_type 2 once')} }}",
            lambda: "julia <0.3,0.5>, 12 " + d.one("exponent 3 interior 4, 1", "exterior 6, 1", "interior 3,0.5"),
            lambda: "mandel 12 " + d.one("exterior 7, 0.5", "exterior 4, 1", "interior 5, 1", "exterior 8, 1 exponent 4"),
            lambda: "magnet " + d.one("1 mandel 15", "2 mandel 8", "1 julia <0.3,0.4>, 12", "2 julia <0.2,0.6>, 9"),
            lambda: f"pavement number_of_sides {d.one('3', '4', '6')} number_of_tiles {d.integer(1, 3)} pattern 1 "
            + d.one("", "exterior 1", "interior 1", "form 1"),
            lambda: f"pigment_pattern {{ {self.pattern()} {self.colour_map()} {d.transforms(1)} }}",
            lambda: "crackle " + d.one("metric 4", "metric 0.7", "form <0.3,-0.5,0.2> metric 2", "solid offset 0.5"),
        )()

    def image_map(self):
        d = self.d
        if d.chance(0.5):
            return super().image_map()
        more = d.some(
            [
                "once",
                f"map_type {d.one('1', '2', '5', '7', '0')}",
                f"interpolate {d.one('2', '3', '4')}",
                "transmit all 0.4",
            ],
            2,
        )
        return f"image_map {{ {self.image()} {' '.join(more)} }}"

    def normal_body(self, depth=1):
        d = self.d
        if d.chance(0.85):
            return super().normal_body(depth)
        return (
            f"bump_map {{ {self.image()} {d.one('use_color', 'use_index', 'use_colour', '')} {d.one('', 'bump_size 3')} }}"
        )

    def finish_body(self):
        d = self.d
        body = super().finish_body()
        if self.subsurface and d.chance(0.6):
            body += f" subsurface {{ translucency {d.one('0.5', '<0.9,0.5,0.3>', 'rgb 2')} {d.one('', '', 'anisotropy 0.3')} }}"
        return body

    def media_body(self):
        d = self.d
        body = super().media_body()
        if d.chance(0.3):
            entries = self.entries(lambda: self.pattern("density") + " " + self.colour_map())
            body += f" density {{ {d.one('spherical', 'gradient y', 'average')} density_map {{ {entries} }} }}"
        if d.chance(0.2):
            body += " density { rgb 0.7 } density { planar }"
        return body

    def interior_body(self):
        d = self.d
        body = super().interior_body()
        return body + d.one("", "", " fade_colour rgb <0.8,0.4,0.2> fade_power 2 fade_distance 0.5", " refraction 1")


class Objects(objects.Objects):
    def __init__(self, d, subsurface):
        super().__init__(d)
        self.t = Textures(d, subsurface)

    def solid(self):
        d, t = self.d, self.t
        if d.chance(0.75):
            return super().solid()
        return d.one(
            lambda: f"julia_fractal {{ {d.one('<-0.1,0.6,0,-0.3>', '<-0.2,0.4,0.3,-0.2>')} hypercomplex {d.of(JULIA)} max_iteration {d.integer(3, 5)} precision 15"
            + d.one("", " slice <0,0,0,1>, 0.2", " slice <0,1,0,1>, 0"),
            lambda: f"julia_fractal {{ <-0.2,0.6,0.2,-0.3> quaternion {d.one('sqr', 'cube')} max_iteration 4 precision 15"
            + d.one("", " slice <0.2,0,0,1>, 0.1"),
            lambda: f"isosurface {{ function {{ {self.surface()} }} {d.one('', 'threshold 0.3')} max_gradient {d.one('3', '6')} "
            + d.one("contained_by { box { -1.2, 1.2 } }", "contained_by { sphere { 0, 1.3 } }", "")
            + d.one("", " open", " all_intersections", " evaluate 1,1.5,0.8"),
            lambda: "polynomial { 2, "
            + d.one("xyz(2,0,0):1, xyz(0,2,0):1, xyz(0,0,2):1, xyz(0,0,0):-1", "xyz(2,0,0):1 , xyz(0,0,2):1, xyz(0,1,0):-0.7"),
            lambda: "sphere_sweep { linear_spline 3, <-1,0,0>, 0.3, <0,1,0>, 0.1, <1,0,0.5>, 0.5",
            lambda: f'text {{ {d.one("internal 1", "internal 2", "internal 3", "internal 4")} "{d.one("g", "B8", "i")}" {d.one("0.3", "1")}, 0',
            lambda: "lathe { "
            + d.one(
                "cubic_spline 6, <0.3,-1.5> <0.5,-1> <1,0> <0.4,0.6> <0.7,1> <0,1.5>",
                "linear_spline 5, <0.5,-1>, <1,-1>, <1,1>, <0.5,1>, <0.5,-1>",
                "bezier_spline 8 <0,-1> <0.5,-1> <1,-0.7> <1,0> <1,0> <1,0.5> <0.5,1> <0,1>",
            ),
            lambda: "prism { "
            + d.one("conic_sweep ", "")
            + d.one(
                "quadratic_spline 0.2, 1, 6 <-1,-1> <1,-1> <1,1> <-0.5,0.5> <-1,-1> <1,-1>",
                "bezier_spline 0, 1, 8 <-1,0> <-1,0.6> <1,0.6> <1,0> <1,0> <1,-1> <-1,-1> <-1,0>",
                "linear_spline 0, 1, 10 <-1,-1> <1,-1> <1,1> <-1,1> <-1,-1> <-0.5,-0.5> <0.5,-0.5> <0.5,0.5> <-0.5,0.5> <-0.5,-0.5>",
            ),
            lambda: f"blob {{ threshold 0.4 sphere {{ 0, 1, 1 texture {{ {t.texture_body(0)} }} }} sphere {{ x, 1, 1 {t.pigment(0)} {t.finish()} }} cylinder {{ 0, y, 0.5, 0.7 {d.transform()} }}",
            lambda: "cone { y, 0.5, -y, 1.2",
            lambda: f"ovus {{ {d.one('0.5, 1', '1, 1', '1, 0.2')}",
            lambda: f"sphere {{ {d.name('vector') or 'y/2'}, 0.7",
        )()

    def surface(self):
        d = self.d
        return d.one(
            lambda: f"x*x+y*y+z*z-1+0.3*({self.t.function()})",
            lambda: "f_sphere(x,y,z,0.8)" if d.name("functions") else "x*x+y*y+z*z-0.7",
            lambda: d.one(
                "f_torus(x,y,z,0.7,0.25)",
                "f_rounded_box(x,y,z,0.2,0.8,0.6,0.7)",
                "f_superellipsoid(x,y,z,0.5,0.5)",
                "f_heart(x,y,z,-1)",
                "f_noise3d(x*2,y*2,z*2)-0.5",
                "f_ridged_mf(x,y,z,0.1,3,4,0.7,0.7,2)-0.5",
                "f_helix1(x,y,z,2,6,0.15,0.6,1,0.5,0)",
                "f_ellipsoid(x,y,z,1,1.5,2)-1",
                "f_r(x,y,z)-0.9",
                "f_mesh1(x,y,z,0.4,0.3,0.1,0.3,1)",
            )
            if d.name("functions")
            else "abs(x)+y*y+abs(z)-0.8",
            lambda: f"y+0.2*{d.name('function')}(x,0,z)" if d.name("function") else "y*y+x*x-0.4",
        )()

    def open_shape(self):
        d = self.d
        if d.chance(0.55):
            return super().open_shape()
        return d.one(
            lambda: "mesh2 { vertex_vectors { 5, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0>, <0,0,-0.7> } normal_vectors { 3, -z, <1,0,-1>, <-1,1,-1> } "
            "uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0.5,0.2> } face_indices { 4, <0,1,4>, <1,2,4>, <2,3,4>, <3,0,4> } "
            "uv_indices { 4, <0,1,3>, <1,2,3>, <2,0,3>, <0,3,1> } normal_indices { 4, <0,1,2>, <1,1,0>, <2,0,0>, <0,0,0> } }",
            lambda: "mesh { triangle { <-1,-1,0>, <1,-1,0>, <0,1,0.3> "
            + " uv_vectors <0,0>,<1,0>,<0.5,1> } inside_vector <0,0,1>",
            lambda: "parametric { function { sin(u)*cos(v) } function { sin(v) } function { cos(u)*cos(v) } <0,-pi/2>, <2*pi,pi/2> contained_by { sphere { 0, 1.1 } } max_gradient 2 accuracy 0.01"
            + d.one("", " precompute 5 x,y,z", " precompute 3 y"),
            lambda: f"height_field {{ function 8, 8 {{ {self.t.function()} }} {d.one('', 'smooth', 'water_level 0.2')} translate <-0.5,0,-0.5> scale <3,1,3>",
            lambda: "quartic { <1,0,0,0,2,0,0,2,0,-1.3,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.2,0,0,0,0,1,0,-1.3,0,0.4> sturm",
            lambda: "polynomial { 3, xyz(3,0,0):1, xyz(0,1,0):-1, xyz(0,0,1):0.4 sturm clipped_by { sphere { 0, 1.5 } }",
            lambda: "cubic { <0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,1,0,-1,0> clipped_by { sphere { 0, 1.2 } }",
            lambda: "quadric { <0,1,1>, <0,0,0.5>, <-1,0,0>, 0 clipped_by { box { -1.2, 1.2 } }",
            lambda: "bicubic_patch { type 1 flatness 0.05 u_steps 3 v_steps 3 uv_vectors <0,0>,<1,0>,<1,1>,<0,1> "
            + ", ".join(f"<{i - 1.5},{d.one('0', '0.7', '-0.4')},{j - 1.5}>" for j in range(4) for i in range(4))
            + " uv_mapping",
            lambda: "smooth_triangle { <-1,-1,0>, <0.3,0,-1>, <1,-1,0>, <0,1,-1>, <0,1,0>, <-0.5,0,-1>",
        )()

    def light(self):
        d = self.d
        if d.chance(0.6):
            return super().light()
        lamp = super().light
        return d.one(
            lambda: f"light_group {{ {lamp()} {self.object(1)} {d.one('', self.object(0))} global_lights {d.one('on', 'off')} {d.transforms(1)} }}",
            lambda: f"light_group {{ {lamp()} {lamp()} sphere {{ x, 0.7 {self.modifiers(2)} }} }}",
            lambda: "light_source { <-3,5,-4>, rgb 1 area_light 2*x, 2*y, 3, 3 circular orient adaptive 0 }",
            lambda: "light_source { <4,5,-4>, rgb <0.7,0.8,1> spotlight point_at <0,0.3,0> radius 5 falloff 30 tightness 12 photons { refraction on reflection off } }",
            lambda: f"light_source {{ 0, rgb 0.8 looks_like {{ sphere {{ 0, 0.2 {self.t.texture(0)} }} }} translate <2,2,-2> fade_distance 3 fade_power 2 }}",
            lambda: f"light_source {{ <0,4,-3>, rgb 1 projected_through {{ {self.box()} translate 2*y }} }} }}",
            lambda: "light_source { <-5,5,-5>, rgb 1 parallel point_at x area_light 3*x, 3*z, 4, 4 adaptive 1 }",
        )()

    def modifiers(self, most=3):
        d = self.d
        body = super().modifiers(most)
        if d.chance(0.25):
            body += " " + d.one(
                "no_radiosity",
                "radiosity { importance 0.4 }",
                "photons { target 0.5 reflection on collect off }",
                "photons { pass_through }",
                "photons { target refraction on collect on }",
                "photons { target refraction off reflection on }",
                "double_illuminate",
                "hollow off",
                "no_shadow",
            )
        return body

    def csg(self, depth):
        d = self.d
        if d.chance(0.9):
            return super().csg(depth)
        return f"union {{ {self.object(depth - 1)} light_group {{ {super().light()} {self.object(0)} }} "


class Scene(grammar.Scene):
    def __init__(self, seed):
        super().__init__(seed)
        self.d.odd = self.d.chance(0.1)
        self.subsurface = self.d.chance(0.25)
        self.o = Objects(self.d, self.subsurface)
        self.t = self.o.t
        if self.version in ("1.0", "3.0", "3.1"):
            self.version = "3.7"

    def settings(self):
        d = self.d
        text = super().settings().rstrip("} ")
        # Braces that the plain settings ended with.
        text += " }" * (text.count("{") - text.count("}") - 1)
        if self.subsurface:
            text += f" mm_per_unit {d.one('10', '40', '4')} subsurface {{ samples {d.one('4, 3', '6, 0', '0, 5')} {d.one('', '', 'radiosity on')} }}"
        if d.chance(0.3):
            more = d.some(
                [
                    "low_error_factor 0.7",
                    "nearest_count 3",
                    "nearest_count 6, 2",
                    "minimum_reuse 0.03",
                    "maximum_reuse 0.3",
                    "max_sample 0.6",
                    "adc_bailout 0.02",
                    "subsurface on",
                    "error_bound 0.4",
                    "recursion_limit 2",
                    "gray_threshold 0.5",
                    "brightness 1.3",
                    "always_sample on",
                ],
                4,
            )
            text += f" radiosity {{ count 12 pretrace_start 0.08 pretrace_end 0.04 {' '.join(more)} }}"
        if d.chance(0.2):
            more = d.some(
                ["gather 5, 15", "media 8", "autostop 0.2", "expand_thresholds 0.3, 8", "jitter 0.2", "max_trace_level 3", "adc_bailout 0.05", "radius 0.3"],
                3,
            )
            text += f" photons {{ {d.one('spacing 0.15', 'count 800')} {' '.join(more)} }}"
        if d.chance(0.2):
            text += " " + d.one("max_intersections 64", "charset utf8", "ambient_light rgb <1,0.8,0.6>", "max_trace_level 12", "charset ascii", "noise_generator 3")
        return text + " }"

    def includes(self):
        d = self.d
        lines = super().includes()
        if d.chance(0.3):
            lines.append('#include "functions.inc"')
            d.add("functions", "functions.inc")
        return lines

    def declaration(self):
        d, t = self.d, self.t
        if d.chance(0.6):
            return super().declaration()
        kind = d.one("function", "pigment_function", "spline", "array", "vectors", "file")
        name = d.new_name(kind)
        if kind == "function":
            text = f"#declare {name} = function(x,y,z) {{ {t.function()} }}"
            if d.chance(0.4):
                text = f"#declare {name} = function {{ pattern {{ {t.pattern()} {t.modifiers('pigment', 2)} }} }}"
        elif kind == "pigment_function":
            text = f"#declare {name} = function {{ {t.pigment(1)} }}"
        elif kind == "spline":
            of = d.one("linear_spline", "quadratic_spline", "cubic_spline", "natural_spline")
            points = " ".join(f"{p}, {d.triple(d.unit)}{d.comma()}" for p in ("-0.5", "0", "0.3", "1", "1.4")).rstrip(", ")
            text = f"#declare {name} = spline {{ {of} {points} }}"
            for i in range(2):
                d.add("vector", f"({name}({d.one('0.1', '0.5', '0.8', '2')})+<0,0,0>)")
            return text
        elif kind == "array":
            text = f"#declare {name} = array[3] {{ {d.triple()}, {d.triple()}, {d.triple()} }}"
            d.add("vector", f"{name}[{d.integer(0, 2)}]")
            return text
        elif kind == "vectors":
            text = f"#declare {name} = {d.one('vaxis_rotate(x, <1,1,0>, 40)', 'vcross(<1,2,0>, z)', 'vturbulence(2, 0.5, 4, <0.3,0.2,0.1>)', 'min_extent(box { -1, 2 })', '<vdot(x,<0.5,1,0>), ln(2), log(5)>', '<asin(0.5), acos(0.3), atan2(1,2)>', '<cosh(0.3), sinh(0.2), tanh(0.7)>', '<asc(chr(66))/66, strlen(str(pi,0,3))/9, strcmp(concat(chr(65)), chr(66))>', '<bitwise_and(6,3)/4, bitwise_or(1,2)/3, bitwise_xor(5,1)/6>', '<div(7,2), ceil(0.3), degrees(0.01)>')};"
            d.add("vector", name)
            return text
        else:
            text = f"#declare {name} = seed(7); #declare {name}A = <rand({name}), rand({name}), rand({name})>;"
            d.add("vector", f"{name}A")
            return text
        d.add(kind, name)
        return text

    def camera(self):
        d = self.d
        if d.chance(0.75):
            return super().camera()
        place = d.one("<0,1,-6>", "<0,0,-5>", "<3,3,-5>")
        return d.one(
            f"camera {{ location {place} look_at 0 angle {d.one('40', '60')} aperture 0.4 blur_samples {d.one('3', '7', '4, 12')} focal_point <0,0,{d.one('0', '-1')}> "
            + d.one("", "confidence 0.8 variance 1/100", "bokeh { pigment { spherical translate <0.5,0.5,0> scale 0.5 } }", "bokeh { pigment { image_map { png \"plasma2.png\" } } }")
            + " }",
            f"camera {{ fisheye location {place} angle {d.one('180', '120', '400')} look_at 0 }}",
            f"camera {{ ultra_wide_angle location {place} angle {d.one('150', '60')} look_at 0 }}",
            f"camera {{ spherical location {place} angle {d.one('360', '180, 90', '300 100')} look_at 0 }}",
            f"camera {{ cylinder {d.one('1', '2', '3', '4')} location {place} angle {d.one('100', '200')} look_at 0 }}",
            "camera { mesh_camera { 1 1 mesh { triangle { <-2,-2,-5>, <2,-2,-5>, <0,2,-5> } triangle { <-2,-2,-5>, <0,2,-5>, <-2,2,-5> } } } location <0,0,0.01> }",
            # Not `smooth` over flat triangles: what they show hangs on memory.
            "camera { mesh_camera { 1 3 mesh { smooth_triangle { <-2,-2,-5>, <0.1,0,1>, <2,-2,-5>, <-0.2,0.1,1>, <0,2,-5>, <0,-0.3,1> uv_vectors <0,0>, <1,0>, <0.5,1> } } smooth } location <0,0,0.01> }",
            f"camera {{ orthographic location {place} look_at 0 angle {d.one('30', '50')} }}",
            f"camera {{ location {place} look_at 0 {self.t.normal()} }}",
        )

    def atmosphere(self):
        d, t = self.d, self.t
        if d.chance(0.6):
            return super().atmosphere()
        return d.one(
            "rainbow { angle 35 width 8 distance 50 direction <0.1,-0.3,1> arc_angle 120 falloff_angle 40 up <0.1,1,0> color_map { [0 rgbt 1] [0.5 rgbt <0,1,0,0.4>] [1 rgbt 1] } }",
            f"sky_sphere {{ {t.pigment(1)} emission {d.one('0.5', 'rgb <0.4,0.8,1>')} }}",
            f"fog {{ distance 8 rgbft <0.5,0.6,0.7,0.2,0.1> fog_type 2 fog_offset -0.5 fog_alt 0.3 up {d.one('y', '<1,2,0>', 'z')} turbulence <0.3,0.1,0.2> turb_depth 0.4 omega 0.6 lambda 2.5 octaves 3 }}",
            "fog { distance 12 rgb 0.6 } fog { fog_type 2 distance 3 rgb <0.4,0.3,0.2> fog_offset 0 fog_alt 0.4 }",
            f"media {{ {t.media_body()} }}",
            "background { rgbft <0.2,0.3,0.4,0.2,0.3> }",
        )


def scene(seed):
    """(version of the language, text without its #version line)."""
    s = Scene(seed)
    return s.version, s.text()
