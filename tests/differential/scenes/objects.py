"""Objects of every kind in all nestings, with all modifiers in any order."""
import textures

MESH_FACES = [
    ("<-1,-1,0>", "<1,-1,0>", "<0,1,0>"),
    ("<-1,0,-1>", "<1,0,-1>", "<0,0,1>"),
    ("<0,-1,0>", "<1,0,0>", "<0,1,1>"),
]


class Objects:
    def __init__(self, d):
        self.d = d
        self.t = textures.Textures(d)

    def place(self):
        """A corner on the grid on which things touch."""
        d = self.d
        return d.triple(lambda: d.one("-2", "-1", "0", "1", "0", "-0.5", "0.5"))

    def box(self):
        d = self.d
        x, y, z = (d.random.choice([-2, -1.5, -1, -0.5, 0, 0, 0.5, 1]) for _ in range(3))
        w, h, l = (d.random.choice([0.5, 1, 1, 2, 1.5, 3]) for _ in range(3))
        return d.one(
            f"box {{ <{x},{y},{z}>, <{x + w},{y + h},{z + l}>",
            f"box {{ <{x},{y},{z}>{d.comma()}<{x + w},{y + h},{z + l}>",
            f"box {{ <{x + w},{y},{z + l}>, <{x},{y + h},{z}>",
            "box { -1, 1",
            f"box {{ -{d.positive()}, 1",
        )

    def solid(self):
        """A finite object with an inside, without its closing brace."""
        d, t = self.d, self.t
        pick = d.one(
            self.box,
            self.box,
            self.box,
            lambda: f"sphere {{ {self.place()}, {d.positive()}",
            lambda: "sphere { 0, 1",
            lambda: f"cylinder {{ {self.place()}, {d.one('<0,1,0>', 'y*2', '<1,1,1>', '-2*y')}, {d.positive()} {d.one('', '', 'open')}",
            lambda: f"cone {{ {d.one('0', '-y')}, {d.positive()}, {d.one('y', '2*y', '<1,1,0>')}, {d.one('0', '0.2', '1')} {d.one('', '', 'open')}",
            lambda: f"torus {{ {d.one('1', '0.75', '1.5')}, {d.one('0.25', '0.5', '0.1')} {d.one('', '', 'sturm')}",
            lambda: f"superellipsoid {{ <{d.one('0.25', '1', '0.1', '2')}, {d.one('0.25', '1', '0.5')}>",
            lambda: "lathe { "
            + d.one(
                "linear_spline 4 <0,-1> <1,-0.5> <0.5,0.5> <0,1>",
                "quadratic_spline 5, <0,-1>, <1,-1>, <0.7,0>, <1,0.5>, <0,1>",
                "cubic_spline 5 <1,-1> <0.5,-0.5> <1,0> <0.5,1> <0,1.5>",
                "bezier_spline 4 <0.5,-1> <1.5,0> <0.3,0.5> <0.8,1>",
            )
            + d.one("", " sturm"),
            lambda: "sor { 5 <0,-1> <0.5,-0.8> <1,0> <0.3,0.8> <0.5,1.2> " + d.one("", "open", "sturm"),
            lambda: "prism { "
            + d.one("", "linear_sweep ", "conic_sweep ")
            + d.one("", "linear_spline ")
            + d.one("0, 1", "-1, 0.5", "0.5,1")
            + ", 4 "
            + d.one("<-1,-1> <1,-1> <0,1> <-1,-1>", "<0,0>, <1,0>, <1,1>, <0,0>")
            + d.one("", " open", " sturm"),
            lambda: "prism { cubic_spline 0, 1, 7 <-1,-1> <0,-1> <1,0> <0.5,1> <-0.5,0.5> <0,-1> <1,0>",
            lambda: f"blob {{ threshold {d.one('0.5', '0.3', '.6')} "
            + " ".join(
                d.one(
                    f"sphere {{ {self.place()}, {d.one('1', '1.5', '2')}, {d.one('1', '2', '-1')} {d.one('', '', t.pigment(0))} {d.one('', '', d.transform())} }}",
                    f"cylinder {{ -x, x, {d.one('0.5', '1')}, {d.one('1', '-0.5')} }}",
                )
                for _ in range(3)
            )
            + d.one("", " sturm", " hierarchy off"),
            lambda: f"sphere_sweep {{ {d.one('linear_spline 2,', 'linear_spline 3, <-1,-1,0>, 0.5,')} -x, 0.3, y, 0.2"
            + d.one("", " tolerance 1e-4"),
            lambda: "sphere_sweep { "
            + d.one("b_spline", "cubic_spline")
            + " 4, <-2,0,0>,0.2 <-1,1,0>, 0.3 <1,0,0>,0.4 <2,-1,0>,0.2",
            lambda: "isosurface { function { "
            + d.one(
                "x*x+y*y+z*z-1", "abs(x)+abs(y)+abs(z)-1", "x*x+z*z-0.5+0.1*sin(5*y)", "max(abs(x),abs(y),abs(z))-0.8"
            )
            + " } contained_by { "
            + d.one("box { -1.1, 1.1 }", "sphere { 0, 1.4 }", "box { -1, 1 }")
            + " } "
            + " ".join(
                d.some(
                    [
                        "max_gradient 4",
                        "accuracy 0.001",
                        "open",
                        "all_intersections",
                        "threshold 0.1",
                        "max_trace 2",
                        "evaluate 1, 1.2, 0.9",
                    ],
                    2,
                )
            ),
            lambda: f'text {{ ttf "{d.one("crystal.ttf", "cyrvetic.ttf")}" "{d.one("A", "ab", "xI", "O8")}" {d.one("0.5", "1", "0.2")}, {d.one("0", "0.1*x", "<0,0.1,0>")}',
            lambda: f"julia_fractal {{ <-0.1,0.6,0,-0.3> {d.one('quaternion', 'hypercomplex')} max_iteration {d.integer(3, 6)} precision 20",
            lambda: "ovus { 1, 0.5",
        )
        return pick()

    def open_shape(self):
        """A finite object without an inside."""
        d = self.d
        return d.one(
            lambda: f"triangle {{ <-1,-1,0>, <1,-1,{d.one('0', '1')}>, <0,1,0>",
            lambda: "smooth_triangle { <-1,-1,0>, <0,0,-1>, <1,-1,0>, <1,0,-1>, <0,1,0>, <0,1,-1>",
            lambda: f"disc {{ {self.place()}, {d.direction()}, {d.positive()}{d.one('', ', 0.1', ' 0.25')}",
            lambda: "polygon { "
            + d.one(
                "5, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0>, <-1,-1,0>",
                "4 <-1,0,-1> <1,0,-1> <0,0,1> <-1,0,-1>",
                "10 <-1,-1> <1,-1> <1,1> <-1,1> <-1,-1> <-0.5,-0.5> <0.5,-0.5> <0.5,0.5> <-0.5,0.5> <-0.5,-0.5>",
            ),
            lambda: f"bicubic_patch {{ type {d.one('0', '1')} flatness 0.01 u_steps {d.integer(1, 3)} v_steps {d.integer(1, 3)} "
            + ", ".join(f"<{i - 1.5},{j - 1.5},{d.one('0', '0.5', '-0.5')}>" for j in range(4) for i in range(4)),
            lambda: "mesh { " + self.mesh_triangles() + d.one("", " inside_vector y", " hierarchy off"),
            lambda: self.mesh2(),
            lambda: 'height_field { png "plasma2.png" '
            + d.one("", "smooth", "water_level 0.3", "hierarchy off")
            + " translate <-0.5,0,-0.5> scale <3,1,3>",
            lambda: "parametric { function { u } function { v } function { u*v } <-1,-1>, <1,1> contained_by { box { -1.1, 1.1 } } precompute 4 x,y,z",
            lambda: f"quadric {{ <1,{d.one('0', '1', '-1')},1>, <0,0,0>, <0,0,0>, -1 {d.one('', 'clipped_by { box { -1.5, 1.5 } }')}",
            lambda: "cubic { <1,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0> "
            + d.one("", "sturm")
            + " clipped_by { sphere { 0, 1.5 } }",
            lambda: "poly { 2, <1,0,0,0,1,0,0,1,0,-1> " + d.one("", "sturm"),
            lambda: f"plane {{ {d.direction()}, {d.one('0', '-1', '-1', '-0.5')}",
        )()

    def mesh_triangles(self):
        d = self.d
        out = []
        for a, b, c in MESH_FACES[: d.random.randint(1, 3)]:
            texture = f" texture {{ {d.name('texture')} }}" if d.name("texture") and d.chance(0.3) else ""
            uv = " uv_vectors <0,0>, <1,0>, <0,1>" if d.chance(0.3) else ""
            if d.chance(0.3):
                out.append(f"smooth_triangle {{ {a}, y, {b}, x, {c}, -z{uv}{texture} }}")
            else:
                out.append(f"triangle {{ {a}, {b}, {c}{uv}{texture} }}")
        return " ".join(out)

    def mesh2(self):
        d = self.d
        parts = ["vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0.5> }"]
        if d.chance(0.4):
            parts.append("normal_vectors { 4, -z, <1,0,-1>, <0,1,-1>, -z }")
        if d.chance(0.4):
            parts.append("uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1> }")
        if d.chance(0.3):
            parts.append(f"texture_list {{ 2, {self.t.texture(0)} {self.t.texture(0)} }}")
            parts.append("face_indices { 2, <0,1,2>, 0, <0,2,3>, " + d.one("1", "0", "0,1,1"))
        else:
            parts.append("face_indices { 2, <0,1,2>, <0,2,3>")
        return "mesh2 { " + " ".join(parts) + " }" + d.one("", " inside_vector y")

    def csg(self, depth):
        d = self.d
        kind = d.one("union", "union", "merge", "intersection", "difference", "difference")
        members = [
            self.object(depth - 1, solid=kind != "union" and d.chance(0.9))
            for _ in range(d.random.randint(1 if d.odd else 2, 3))
        ]
        if kind == "union" and d.chance(0.05):
            members.append(self.light())
        extra = d.one("split_union off", "split_union on") if kind == "union" and d.chance(0.1) else ""
        extra = "cutaway_textures" if kind in ("intersection", "difference") and d.chance(0.15) else extra
        return f"{kind} {{ " + "\n".join(members) + " " + extra

    def light(self):
        d = self.d
        place = d.one(
            "<-4,6,-5>", "<3,4,-6>", "<0,10,0>", "<5,5,-5>", "<-10,20,-30>", "-10*z", "<0,3,0>", "<100,200,-300>"
        )
        colour = d.one("rgb 1", "color rgb 0.8", "rgb <1,0.9,0.7>", "color red 1 green 1 blue 1", "rgb 0.5")
        parts = d.some(
            [
                lambda: "shadowless",
                lambda: f"spotlight point_at 0 radius {d.one('10', '20')} falloff {d.one('25', '40')}"
                + d.one("", " tightness 5"),
                lambda: "cylinder point_at <0,0,0> radius 1 falloff 2",
                lambda: "parallel point_at 0",
                lambda: f"fade_distance {d.one('5', '10')} fade_power {d.one('1', '2')}",
                lambda: f"area_light x, z, {d.integer(1, 3)}, {d.integer(1, 3)} "
                + " ".join(d.some(["jitter", "adaptive 1", "circular", "orient", "area_illumination"], 2)),
                lambda: "media_attenuation on",
                lambda: "media_interaction off",
                lambda: f"translate {d.one('x', 'y')}",
                lambda: "rotate 20*y",
                lambda: f"looks_like {{ sphere {{ 0, 0.3 {self.t.pigment(0)} }} }}",
                lambda: "projected_through { box { -1, <1,1,-0.9> } }",
            ],
            2 if d.chance(0.5) else 0,
        )
        return f"light_source {{ {place}{d.comma()}{colour} " + " ".join(p() for p in parts) + " }"

    def modifiers(self, most=3):
        d, t = self.d, self.t
        flag = lambda word: lambda: word + (d.one(" on", " off", "") if word == "hollow" else "")  # noqa: E731
        choices = [
            lambda: t.texture(),
            lambda: t.texture(),
            t.pigment,
            t.pigment,
            t.normal,
            t.finish,
            d.transform,
            d.transform,
            d.transform,
            t.interior,
            t.material,
            flag("no_shadow"),
            flag("no_image"),
            flag("no_reflection"),
            flag("double_illuminate"),
            lambda: "inverse",
            flag("hollow"),
            lambda: f"{t.texture(0)} interior_texture {{ {t.texture_body(0)} }}",
            lambda: f"clipped_by {{ {self.clip()} }}",
            lambda: f"bounded_by {{ {self.clip()} }}",
            lambda: "bounded_by { clipped_by }",
            lambda: "clipped_by { bounded_by }",
            lambda: "photons { target reflection on refraction on }",
        ]
        return " ".join(c() for c in d.some(choices, most))

    def clip(self):
        return self.d.one(
            "plane { y, 0.25 }",
            "box { -2, 2 }",
            "sphere { 0, 1.2 }",
            "plane { x, 0 }",
            "plane { z, 0 inverse }",
            "box { <-3,-3,-3>, <3,0.5,3> rotate 20*z }",
            "plane { y, 0 } plane { x, 0.5 }",
            "cylinder { -2*y, 2*y, 1 }",
        )

    def object(self, depth=2, solid=False):
        d = self.d
        r = d.random.random()
        if r < 0.15 and d.name("object"):
            body = f"object {{ {d.name('object')}"
        elif r < 0.2 and d.name("object_macro"):
            body = f"object {{ {self.macro_call()}"
        elif r < 0.4 and depth > 0:
            body = self.csg(depth)
        elif r < 0.85 or solid:
            body = self.solid()
        else:
            body = self.open_shape()
        return f"{body} {self.modifiers(3 if depth == 2 else 2)} }}"

    def macro_call(self):
        d = self.d
        name, kinds = d.of(d.declared["object_macro"])
        draw = {
            "f": d.number,
            "v": d.vector,
            "c": lambda: d.one("rgb 1", "rgb <1,0,0.5>", "color rgb x") if not d.name("colour") else d.name("colour"),
            "t": lambda: d.name("texture") or "Plain",
        }
        return f"{name}({d.comma().join(draw[k]() for k in kinds)})"
