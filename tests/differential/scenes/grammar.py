"""Draws one scene: settings, defaults, declarations of every kind, cameras, lights, atmosphere and objects that use them."""
import draw
import objects

VERSIONS = ["3.7"] * 6 + ["3.6", "3.5", "3.1", "3.0", "1.0", ""]
INCLUDES = {
    "colors.inc": {"colour": ["Red", "White", "NeonPink", "Gray50", "Clear", "CornflowerBlue"]},
    "textures.inc": {
        "texture": ["Jade", "Cork", "DMFWood4", "Chrome_Metal", "Glass", "Brushed_Aluminum"],
        "pigment": ["Blue_Agate", "Red_Marble"],
        "finish": ["Shiny", "Dull", "Metal", "Mirror", "Phong_Glossy"],
    },
    "metals.inc": {"texture": ["T_Chrome_3C", "T_Brass_2A"], "finish": ["F_MetalB"]},
    "golds.inc": {"texture": ["T_Gold_1C"]},
    "stones.inc": {"texture": ["T_Stone10", "T_Grnt12"]},
    "woods.inc": {"texture": ["T_Wood3", "T_Wood20"]},
    "glass.inc": {"material": ["M_Glass3"], "interior": ["I_Glass1"], "finish": ["F_Glass4"]},
    "finish.inc": {"finish": ["Glossy"]},
    "skies.inc": {"pigment": ["P_Cloud1"]},
}


class Scene:
    def __init__(self, seed):
        self.d = draw.Draw(seed)
        self.o = objects.Objects(self.d)
        self.t = self.o.t
        self.version = self.d.of(VERSIONS)

    def text(self):
        d = self.d
        parts = [self.settings()] + self.includes() + self.defaults()
        parts += [self.declaration() for _ in range(d.random.randint(0, 5))]
        parts += [self.camera()] + [self.o.light() for _ in range(d.one(1, 1, 1, 2, 0))]
        parts += [self.atmosphere()] if d.chance(0.5) else []
        for _ in range(d.random.randint(1, 4)):
            parts.append(self.wrapped(self.o.object()))
        if d.chance(0.5):
            parts.append(f"plane {{ y, {d.one('-1', '0', '-0.5', '-1')} {self.o.modifiers(2)} }}")
        if d.chance(0.3):
            parts.append(self.probe())
        if d.odd and d.chance(0.3):
            parts.insert(
                d.random.randint(0, len(parts)),
                d.of(
                    [
                        "#version 3.5;",
                        "#version 3.7;",
                        "#version 3.1;",
                        "#version 1.0",
                        "#default { finish { ambient 0.4 } }",
                    ]
                ),
            )
        return "\n".join(p for p in parts if p) + "\n"

    def settings(self):
        d = self.d
        parts = d.some(
            [
                lambda: f"max_trace_level {d.one('1', '3', '5')}",
                lambda: f"ambient_light {d.one('rgb 2', 'rgb <0.5,1,1>', '0')}",
                lambda: "adc_bailout 0.05",
                lambda: f"noise_generator {d.integer(1, 3)}",
                lambda: "number_of_waves 4",
                lambda: "irid_wavelength rgb <0.7,0.5,0.4>",
                lambda: "mm_per_unit 10",
                lambda: f"radiosity {{ count {d.one('10', '20')} pretrace_start 0.08 pretrace_end 0.04 recursion_limit 1 "
                + " ".join(
                    d.some(
                        [
                            "normal on",
                            "brightness 0.8",
                            "error_bound 0.5",
                            "gray_threshold 0.3",
                            "media on",
                            "always_sample off",
                        ],
                        2,
                    )
                )
                + " }",
                lambda: f"photons {{ {d.one('spacing 0.1', 'count 1000')} }}",
            ],
            2 if d.chance(0.5) else 0,
        )
        gamma = d.one(
            "assumed_gamma 1 ",
            "assumed_gamma 1 ",
            "assumed_gamma 1.0 ",
            "assumed_gamma 2.2 ",
            "assumed_gamma srgb ",
            "",
        )
        d.srgb = bool(gamma)
        return "global_settings { " + gamma + " ".join(p() for p in parts) + " }"

    def includes(self):
        d = self.d
        out = []
        if d.chance(0.2):
            for name in d.random.sample(list(INCLUDES), d.random.randint(1, 2)):
                if "colors.inc" not in out and name != "colors.inc":
                    out.append("colors.inc")
                    INCLUDED = INCLUDES["colors.inc"]
                    for kind, names in INCLUDED.items():
                        d.declared.setdefault(kind, []).extend(names)
                if name not in out:
                    out.append(name)
                    for kind, names in INCLUDES[name].items():
                        d.declared.setdefault(kind, []).extend(names)
        return [f'#include "{name}"' for name in out]

    def defaults(self):
        d, t = self.d, self.t
        if not d.chance(0.25):
            return []
        body = d.one(t.pigment, t.finish, lambda: t.texture(0), t.normal, lambda: t.finish() + " " + t.pigment(1))
        return ["#default { " + body() + " }"]

    def declaration(self):
        d, o, t = self.d, self.o, self.t
        makers = {
            "float": d.number,
            "vector": lambda: d.triple(),
            "colour": lambda: d.colour(0.1),
            "texture": t.texture,
            "pigment": t.pigment,
            "normal": t.normal,
            "finish": t.finish,
            "material": t.material,
            "interior": t.interior,
            "object": lambda: o.object(2),
            "color_map": t.colour_map,
            "transform": lambda: f"transform {{ {d.transform()} {d.transform()} }}",
        }
        kind = d.of([*makers, "object", "texture", "object_macro"])
        if kind == "object_macro" and self.version in ("1.0", "3.0"):
            kind = "object"
        name = d.new_name(kind)
        if kind == "object_macro":
            return self.macro(name)
        text = f"#{d.one('declare', 'declare', 'local')} {name} = {makers[kind]()}"
        d.add(kind, name)
        if kind in ("float", "vector", "colour"):
            text += ";" if d.chance(0.95) else ""
        return text + d.one("", "", ";") if not text.endswith(";") and d.odd else text

    def macro(self, name):
        d = self.d
        kinds = d.one("f", "fv", "cv", "ff", "", *(["t", "ft"] if d.name("texture") else []))
        arguments = [f"{k.upper()}{i}" for i, k in enumerate(kinds, 1)]
        use = {
            "f": lambda a: f"scale 0.5+abs({a})*0.5",
            "v": lambda a: f"translate {a}",
            "c": lambda a: f"pigment {{ {a} }}",
            "t": lambda a: f"texture {{ {a} }}",
        }
        uses = " ".join(use[k](a) for k, a in zip(kinds, arguments))
        text = f"#macro {name}({', '.join(arguments)})\n{self.o.solid()} {uses} }}\n#end"
        d.add("object_macro", (name, kinds))
        return text

    def camera(self):
        d = self.d
        place = d.one("<0,1,-6>", "<0,0,-5>", "<3,3,-5>", "-6*z", "<0,2,-7>", "<0,5,0.01>", "<-4,1,-4>")
        kind = (
            "spherical"
            if self.version > "3.5" and d.chance(0.05)
            else d.one(
                "",
                "",
                "",
                "",
                "",
                "perspective",
                "orthographic",
                "fisheye",
                "ultra_wide_angle",
                "omnimax",
                "panoramic",
                "cylinder 1",
                "cylinder 2",
                "cylinder 3",
            )
        )
        parts = [f"location {place}"] + [
            p()
            for p in d.some(
                [
                    lambda: f"angle {d.one('40', '60', '90', '120')}",
                    lambda: "right x*4/3",
                    lambda: "up y",
                    lambda: "direction 1.5*z",
                    lambda: "sky <0,1,0.2>",
                    lambda: d.transform(),
                    lambda: "right -x*1.33",
                    lambda: "rotate 10*y",
                    lambda: "aperture 0.2 blur_samples 4 focal_point 0",
                    lambda: f"normal {{ bumps 0.1 }}",
                ],
                2,
            )
        ]
        if d.odd and d.chance(0.3):
            d.random.shuffle(parts)
        return (
            "camera { "
            + f"{kind} "
            + " ".join(parts)
            + d.one(" look_at 0", " look_at 0", " look_at <0,0.5,0>", "")
            + " }"
        )

    def atmosphere(self):
        d, t = self.d, self.t
        return d.one(
            lambda: f"background {{ {d.colour(0)} }}",
            lambda: f"background {{ {d.colour(0.2)} }}",
            lambda: f"sky_sphere {{ {t.pigment(1)} {d.one('', t.pigment(1))} {d.transforms(1)} }}",
            lambda: f"fog {{ distance {d.one('5', '10')} {d.colour(0.3)} {d.one('', 'turbulence 0.3 turb_depth 0.2', 'fog_type 2 fog_offset 0 fog_alt 0.5')} }}",
            lambda: "rainbow { angle 30 width 10 distance 100 direction <0,-0.3,1> color_map { [0 rgbt 1] [0.5 rgbt <1,0,0,0.5>] [1 rgbt 1] } }",
            lambda: f"media {{ {d.one('absorption 0.05', 'emission 0.03', 'scattering {1, 0.02}')} intervals 2 samples 3 method {d.integer(1, 3)} }}",
        )()

    def wrapped(self, text):
        """An object in a directive, now and then."""
        d = self.d
        if not d.chance(0.12):
            return text
        return d.one(
            f"#if (1) {text} #else sphere {{ 0, 9 }} #end",
            f"#for (I,0,1) object {{ {text} translate I*x }} #end",
            f"#local K = 0; #while (K < 2) object {{ {text} rotate K*90*y }} #local K = K + 1; #end",
            f"#switch (2) #case (1) sphere {{ 0, 5 }} #break #range (2,3) {text} #break #else #end",
            f"union {{ {text} }}",
            f"#ifdef (Nothing) #else {text} #end",
        )

    def probe(self):
        """Prints a value: what a scene says must agree, too."""
        d = self.d
        value = d.one(
            lambda: f"str({d.number()}, 0, 6)",
            lambda: f"str(vlength({d.vector()} + <0,0,0>), 0, 5)",
            lambda: f'vstr(3, {d.triple()}, ",", 0, 4)',
            lambda: f'concat("ab", substr("hello", {d.integer(1, 3)}, {d.integer(0, 2)}), strupr("q"))',
            lambda: f"vstr(3, max_extent({d.name('object')}), \",\", 0, 3)"
            if d.name("object")
            else "str(version, 0, 2)",
            lambda: f"str(inside({d.name('object')}, <0.1,0.2,0.3>), 0, 0)" if d.name("object") else "str(pi, 0, 9)",
            lambda: f"vstr(3, trace({d.name('object')}, <0.1,0.2,-9>, z), \",\", 0, 4)"
            if d.name("object")
            else "str(clock, 0, 1)",
        )
        return f'#debug concat({value()}, "\\n")'


def scene(seed):
    """(version of the language, text without its #version line)."""
    s = Scene(seed)
    return s.version, s.text()
