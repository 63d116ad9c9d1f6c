"""Scenes that ask for more time, memory or room than there is: what strangers may send to a server.

`bombs()` yields Bomb(name, text, files, switches); names begin with the kind.
"""
import struct
import zlib
from dataclasses import dataclass, field

HEAD = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
light_source { <5, 8, -6> rgb 1 }
"""
BALL = "sphere { 0, 1 pigment { rgb 1 } }\n"


@dataclass
class Bomb:
    name: str
    text: str
    files: dict = field(default_factory=dict)
    switches: list = field(default_factory=list)


def repeated(statement, times):
    return f"#for (I, 1, {times})\n{statement}\n#end\n"


def strings():
    for n in (30, 60, 200):
        yield f"concat_{n}", HEAD + '#declare S = "aaaaaaaa";\n' + repeated("#declare S = concat(S, S);", n) + BALL
        yield f"concat_debug_{n}", HEAD + '#declare S = "a";\n' + repeated("#declare S = concat(S, S) #debug S", n)
    yield "upper_loop", HEAD + '#declare S = "a" #while (1) #declare S = strupr(concat(S, "b")) #end'
    yield "substr_loop", HEAD + '#while (1) #declare S = substr("abcdef", 2, 3) #end'
    yield "str_digits", HEAD + "#declare S = str(1/3, 1000000000, 1000000000)\n" + BALL
    yield "str_width", HEAD + "#while (1) #declare S = str(pi, 100000, 100) #end"
    yield "vstr_loop", HEAD + '#while (1) #declare S = vstr(3, <1, 2, 3>, ",", 0, 15) #end'
    yield "chr_loop", HEAD + '#declare S = "" #while (1) #declare S = concat(S, chr(65)) #end'


def loops():
    body = {"empty": "", "declare": "#declare A = 1;", "vector": "#declare A = <1, 2, 3> * 2;", "rand":
            "#declare S = seed(1); #declare A = rand(S);", "block": "sphere { 0, 1 }", "if": "#if (1) #else #end",
            "undef": "#declare B = 1; #undef B", "switch": "#switch (1) #case (1) #break #end",
            "local": "#local A = array[100];", "function": "#declare F = function { x } #undef F",
            "debug": '#debug "."', "warning": '#warning "."', "version": "#version 3.7;", "sort":
            "#declare A = pow(2, 0.5) + sin(1) + vlength(<1, 2, 3>);", "texture": "#declare T = texture { pigment { rgb 1 } }"}
    for name, text in body.items():
        yield f"while_{name}", HEAD + f"#while (1) {text} #end\n" + BALL
    for depth in (4, 8, 12):
        yield f"nested_{depth}", HEAD + "".join(f"#for (I{d}, 1, 1000)\n" for d in range(depth)) + "#end\n" * depth + BALL
    yield "for_tiny_step", HEAD + "#for (I, 0, 1, 1e-300) #end\n" + BALL
    yield "for_huge", HEAD + "#for (I, 0, 1e300) #end\n" + BALL
    yield "do_until", HEAD + "#declare A = 1; #while (A > 0) #declare A = A + 1; #end\n" + BALL


def macros():
    yield "self", HEAD + "#macro M() M() #end M()\n"
    yield "mutual", HEAD + "#macro A() B() #end\n#macro B() A() #end A()\n"
    for n in (20, 40, 90):
        yield f"tree_{n}", HEAD + f"#macro M(N) #if (N > 0) M(N - 1) M(N - 1) #end #end M({n})\n" + BALL
        yield f"tree_objects_{n}", HEAD + f"#macro M(N) #if (N > 0) M(N - 1) M(N - 1) #else sphere {{ 0, 1 }} #end #end union {{ M({n}) }}\n"
    yield "wide", HEAD + "#macro M() " + "A() " * 1000 + "#end #macro A() " + "B() " * 1000 + "#end #macro B() #local X = 1; #end " + "M() " * 1000
    yield "parameters", HEAD + "#macro M(" + ", ".join(f"P{i}" for i in range(5000)) + ") #end " + "M(" + ", ".join("1" for _ in range(5000)) + ")\n" + BALL
    yield "strings", HEAD + '#macro M(S, N) #if (N) M(concat(S, S), N - 1) #end #end M("aaaaaaaaaaaaaaaa", 90)\n' + BALL
    yield "defines_macros", HEAD + "#for (I, 1, 1e9) #macro M() sphere { 0, 1 } #end #end\n" + BALL
    yield "parse_string", HEAD + '#macro M() #fopen F "x.inc" write #write(F, "M()") #fclose F #include "x.inc" #end M()\n'


def arrays():
    yield "huge", HEAD + "#declare A = array[1000000000];\n" + BALL
    yield "many_dimensions", HEAD + "#declare A = array[1000][1000][1000][1000];\n" + BALL
    yield "negative", HEAD + "#declare A = array[-1];\n" + BALL
    yield "infinite", HEAD + "#declare A = array[1e300];\n" + BALL
    for n in (30, 60, 200):
        yield f"doubled_{n}", HEAD + "#declare A = array[2] { 1, 2 }\n" + repeated("#declare A = array[2] { A, A }", n) + BALL
    yield "loop", HEAD + "#for (I, 1, 1e9) #declare A = array[100000] #declare A[1] = 1; #end\n" + BALL
    yield "kept", HEAD + "#declare A = array[1000000];\n#for (I, 0, 999999) #declare A[I] = array[1000]; #declare A[I][0] = 1; #end\n" + BALL
    yield "of_strings", HEAD + '#declare A = array[10000000];\n#for (I, 0, 9999999) #declare A[I] = concat("abcdefghijklmnop", str(I, 0, 0)); #end\n' + BALL
    yield "symbols", HEAD + "".join(f"#declare V{i} = array[1000];\n" for i in range(20000)) + BALL


def copies():
    forms = {
        "union": "union { object { U } object { U translate I } }",
        "merge": "merge { object { U } object { U translate I/100 } }",
        "intersection": "intersection { object { U } object { U translate I/1000 } }",
        "difference": "difference { object { U } object { U translate I } }",
        "light_group": "light_group { object { U } object { U translate I } }",
        "moved": "object { union { object { U } object { U translate 1 } } rotate I }",
        "scaled": "union { object { U scale 1.01 } object { U scale 0.99 } }",
        "clipped": "sphere { 0, 1 clipped_by { object { U } } clipped_by { object { U } } }",
        "bounded": "sphere { 0, 1 bounded_by { object { U } } clipped_by { object { U } } }",
        "inverse": "intersection { object { U inverse } object { U } }",
        "textured": "union { object { U pigment { rgb 1 } } object { U } texture { pigment { rgb I } } }",
        "no_shadow": "union { object { U no_shadow } object { U no_image } }",
        "pattern": "sphere { 0, 1 pigment { object { U color rgb 1, color rgb 0 } } clipped_by { object { U } } }",
        "split": "union { object { U } object { U translate I } split_union on }",
        "cutaway": "difference { object { U } object { U translate I } cutaway_textures }",
        "hollow": "union { object { U hollow } object { U translate I } hollow }",
        "radiosity": "union { object { U } object { U } radiosity { importance 0.5 } }",
        "photons": "union { object { U } object { U } photons { target on reflection on } }"}
    for name, form in forms.items():
        for n in (24, 60):
            yield f"{name}_{n}", HEAD + "#declare U = sphere { 0, 1 pigment { rgb 1 } }\n" + repeated(f"#declare U = {form}", n) + "object { U }\n"
    for name in ("union", "difference", "clipped", "merge"):
        yield f"deep_{name}", HEAD + "#declare U = sphere { 0, 1 }\n" + repeated("#declare U = " + {
            "union": "union { object { U } sphere { I, 1 } }", "merge": "merge { object { U } sphere { I/100, 1 } }",
            "difference": "difference { object { U } sphere { I/1000, 1 } }",
            "clipped": "sphere { 0, 1 clipped_by { object { U } } }"}[name], 1000000) + "object { U pigment { rgb 1 } }\n"
    yield "extents", HEAD + "#declare U = sphere { 0, 1 }\n" + repeated("#declare U = union { object { U } object { U translate I } }", 50) + "#declare E = min_extent(U);\n" + BALL
    yield "inside", HEAD + "#declare U = sphere { 0, 1 }\n" + repeated("#declare U = difference { object { U } object { U translate I/10 } }", 40) + "#declare E = inside(U, 0);\n" + BALL
    yield "trace", HEAD + "#declare U = sphere { 0, 1 }\n" + repeated("#declare U = union { object { U } object { U translate I } }", 40) + "#declare E = trace(U, -5*z, z);\n" + BALL
    yield "trace_loop", HEAD + "#declare U = torus { 1, 0.2 } #while (1) #declare E = trace(U, -5*z, z); #end\n"


def textures():
    maps = {"texture_map": ("texture", "texture { gradient x texture_map { [0 T] [1 T] } }", "pigment { rgb 1 }"),
            "pigment_map": ("pigment", "pigment { gradient x pigment_map { [0 T] [1 T] } }", "rgb 1"),
            "normal_map": ("normal", "normal { gradient x normal_map { [0 T] [1 T] } }", "bumps 1"),
            "average": ("pigment", "pigment { average pigment_map { [1 T] [2 T] } }", "rgb 1"),
            "average_normal": ("normal", "normal { average normal_map { [1 T] [2 T] } }", "bumps 1"),
            "checker": ("texture", "texture { checker texture { T } texture { T } }", "pigment { rgb 1 }"),
            "hexagon": ("texture", "texture { hexagon texture { T } texture { T } texture { T } }", "pigment { rgb 1 }"),
            "brick": ("pigment", "pigment { brick pigment { T } pigment { T } }", "rgb 1"),
            "image_like": ("pigment", "pigment { pigment_pattern { T } pigment_map { [0 T] [1 T] } }", "rgb 1"),
            "slope": ("pigment", "pigment { slope y pigment_map { [0 T] [1 T] } }", "rgb 1")}
    for name, (kind, form, first) in maps.items():
        use = {"texture": "texture { T }", "pigment": "pigment { T }", "normal": "pigment { rgb 1 } normal { T }"}[kind]
        for n in (60, 100000):
            yield f"{name}_{n}", HEAD + f"#declare T = {kind} {{ {first} }}\n" + repeated(f"#declare T = {form}", n) + f"sphere {{ 0, 1 {use} }}\n"
    yield "layers", HEAD + "sphere { 0, 1 " + "texture { pigment { rgbt 0.9 } }\n" * 100000 + "}\n"
    yield "layers_doubled", HEAD + "#declare T = texture { pigment { rgbt 0.9 } }\n" + repeated("#declare T = texture { T } texture { T }", 40) + "sphere { 0, 1 texture { T } }\n"
    yield "map_entries", HEAD + "sphere { 0, 1 pigment { gradient x color_map { " + "".join(f"[{i / 200000:.6f} rgb 1]" for i in range(200000)) + "} } }\n"
    yield "mandel", HEAD + "plane { z, 0 pigment { mandel 2000000000 color_map { [0 rgb 0] [1 rgb 1] } } }\n"
    yield "julia_exponent", HEAD + "plane { z, 0 pigment { julia <0.3, 0.5>, 2000000000 exponent 33 color_map { [0 rgb 0] [1 rgb 1] } } }\n"
    yield "magnet", HEAD + "plane { z, 0 pigment { magnet 2 mandel 2000000000 } }\n"
    yield "crackle_form", HEAD + "plane { z, 0 pigment { crackle form <1e30, -1e30, 1e300> metric 1e-300 } }\n"
    yield "turbulence", HEAD + "plane { z, 0 pigment { bozo turbulence 1e300 octaves 1000000000 lambda 1e300 omega 1e300 } }\n"
    yield "warps", HEAD + "plane { z, 0 pigment { bozo " + "warp { turbulence 1 octaves 10 }\n" * 100000 + "} }\n"
    yield "black_holes", HEAD + "plane { z, 0 pigment { bozo " + "warp { black_hole 0, 1e300 repeat 1e-300 }\n" * 10000 + "} }\n"
    yield "facets", HEAD + "plane { z, 0 pigment { rgb 1 } normal { facets coords 1e-300 } }\n"
    yield "quilted_deep", HEAD + "plane { z, 0 pigment { rgb 1 } " + "normal { average normal_map { [1 bumps 1] [1 quilted 1] } accuracy 1e-300 } }\n"
    yield "pavement", HEAD + "plane { y, 0 pigment { pavement number_of_sides 3 number_of_tiles 6 pattern 22 scale 1e-300 } }\n"
    yield "subsurface", HEAD + "global_settings { subsurface { samples 100000000, 100000000 } }\nsphere { 0, 1 pigment { rgb 1 } finish { subsurface { translucency 1 } } interior { ior 1.3 } }\n"
    yield "crand", HEAD + "sphere { 0, 1 pigment { rgb 1 } finish { crand 1e300 phong 1e300 phong_size 1e300 reflection 1e300 } }\n"


def functions():
    twice = "#for (I, 1, 40) #undef G #declare G = function(x) { F(x) + F(x + 1) } #undef F #declare F = function(x) { G(x) + G(x + 1) } #end\n"
    yield "doubled", HEAD + "#declare F = function(x) { x + 1 }\n" + twice + "#declare Z = F(1);\n" + BALL
    yield "doubled_iso", HEAD + "#declare F = function(x) { x + 1 }\n" + twice + "isosurface { function { F(x) } }\n"
    for name in ("sum", "prod"):
        yield f"{name}_call", HEAD + f"#declare F = function(x) {{ {name}(I, 1, 1e15, x) }} #declare Z = F(1);\n" + BALL
        yield f"{name}_nested", HEAD + f"#declare F = function(x) {{ {name}(I, 1, 1e5, {name}(J, 1, 1e5, {name}(K, 1, 1e5, x))) }}\nplane {{ z, 0 pigment {{ function {{ F(x) }} }} }}\n"
        yield f"{name}_pattern", HEAD + f"plane {{ z, 0 pigment {{ function {{ {name}(I, 1, 1e12, x*I) }} }} }}\n"
    yield "long", HEAD + "#declare F = function(x) { " + "+".join(["sin(x)"] * 500000) + " }\n" + BALL
    yield "parentheses", HEAD + "#declare F = function(x) { " + "(" * 1000000 + "x" + ")" * 1000000 + " }\n" + BALL
    yield "unary", HEAD + "#declare F = function(x) { " + "-" * 1000000 + "x }\n" + BALL
    yield "powers", HEAD + "#declare F = function(x) { " + "^".join(["x"] * 200000) + " }\n" + BALL
    yield "chain", HEAD + "#declare F0 = function(x) { x }\n" + "".join(f"#declare F{i} = function(x) {{ F{i - 1}(x) + 1 }}\n" for i in range(1, 20000)) + "#declare Z = F19999(1);\n" + BALL
    yield "select", HEAD + "#declare F = function(x) { " + "select(x, " * 50000 + "1" + ", 2, 3)" * 50000 + " }\n" + BALL
    yield "of_pigments", HEAD + "#declare F = function { pigment { bozo } }\n" + repeated("#declare G = function { F(x, y, z).x + F(x, y, z).y } #undef F #declare F = function { pigment { function { G(x, y, z) } } } #undef G", 40) + "plane { z, 0 pigment { function { F(x, y, z).x } } }\n"
    yield "splines", HEAD + "#declare S = function { spline { linear_spline " + ",".join(f"{i}, <{i}, 0, 0>" for i in range(300000)) + " } }\n" + BALL
    for name, body in {"slow": "sum(I, 1, 1000000, sin(x*I)) - y", "noise": "f_noise3d(x*1e3, y*1e3, z*1e3) - 0.5", "wild": "sin(1e9*x)*sin(1e9*y) - 0.5", "nan": "0/(x-x)", "division": "1/(x*y*z)"}.items():
        yield f"isosurface_{name}", HEAD.replace("light", '#include "functions.inc"\nlight', 1) + f"isosurface {{ function {{ {body} }} max_gradient 1e30 accuracy 1e-30 contained_by {{ sphere {{ 0, 1e3 }} }} all_intersections pigment {{ rgb 1 }} }}\n"
    yield "isosurface_evaluate", HEAD + "isosurface { function { x*x + y*y - 1 } evaluate 1e-300, 1e300, 0.9999999 max_gradient 1e300 accuracy 1e-300 }\n"
    yield "parametric", HEAD + "parametric { function { sin(u*1e5) }, function { cos(v*1e5) }, function { u*v } <0, 0>, <100, 100> accuracy 1e-15 precompute 20 x, y, z max_gradient 1e30 pigment { rgb 1 } }\n"
    yield "parametric_nan", HEAD + "parametric { function { u/0 }, function { ln(-1) }, function { v } <0, 0>, <1e300, 1e300> accuracy 1e-300 }\n"


def shapes():
    yield "blob", HEAD + "blob { threshold 0.5 " + repeated("sphere { <I, 0, 0>, 1e5, 1 }", 1000000) + "}\n"
    yield "blob_overlap", HEAD + "blob { threshold 0.5 " + repeated("sphere { <mod(I, 10)/10, 0, 0>, 1, 1e-3 }", 20000) + "pigment { rgb 1 } }\n"
    yield "sphere_sweep", HEAD + "sphere_sweep { b_spline 100000 " + repeated("<sin(I), I/1e4, cos(I)>, 1", 100000) + "tolerance 1e-300 }\n"
    yield "sweep_count", HEAD + "sphere_sweep { linear_spline 2000000000 0, 1 }\n"
    yield "lathe_count", HEAD + "lathe { linear_spline 2000000000 <0, 0>, <1, 1> }\n"
    yield "prism_count", HEAD + "prism { 0, 1, 2000000000 <0, 0>, <1, 1> }\n"
    yield "sor_count", HEAD + "sor { 2000000000 <0, 0>, <1, 1> }\n"
    yield "polygon_count", HEAD + "polygon { 2000000000 <0, 0>, <1, 1> }\n"
    yield "mesh_loop", HEAD + "mesh { " + repeated("triangle { <I, 0, 0>, <0, 1, 0>, <0, 0, 1> }", 1000000000) + "}\n"
    yield "mesh2_count", HEAD + "mesh2 { vertex_vectors { 2000000000 <0, 0, 0> } face_indices { 1 <0, 0, 0> } }\n"
    yield "mesh2_faces", HEAD + "mesh2 { vertex_vectors { 3 x, y, z } face_indices { 2000000000 <0, 1, 2> } }\n"
    yield "mesh2_indices", HEAD + "mesh2 { vertex_vectors { 3 x, y, z } face_indices { 1 <0, 1, 2000000000> } }\n"
    yield "poly_order", HEAD + "poly { 35 <" + "1, " * 8435 + "1> }\n"
    yield "polynomial", HEAD + "polynomial { 35 xyz(35, 0, 0): 1 }\n"
    for n in (1000, 30000, 2000000000):
        yield f"height_function_{n}", HEAD + f"height_field {{ function {n}, {n} {{ sin(x*y) }} pigment {{ rgb 1 }} }}\n"
        yield f"image_function_{n}", HEAD + f"box {{ 0, 1 pigment {{ image_map {{ function {n}, {n} {{ sin(x*y) }} }} }} }}\n"
    yield "patch_steps", HEAD + "bicubic_patch { type 1 flatness 0 u_steps 1000000000 v_steps 1000000000 " + ",".join(f"<{i % 4}, {i // 4}, 0>" for i in range(16)) + " }\n"
    yield "patch_flatness", HEAD + "bicubic_patch { type 1 flatness 1e-300 u_steps 30 v_steps 30 " + ",".join(f"<{i % 4}, {i // 4}, {i % 3}>" for i in range(16)) + " pigment { rgb 1 } }\n"
    yield "julia_fractal", HEAD + "julia_fractal { <0.1, 0.2, 0.3, 0.4> quaternion max_iteration 2000000000 precision 1e300 pigment { rgb 1 } }\n"
    yield "julia_power", HEAD + "julia_fractal { <0.1, 0.2, 0.3, 0.4> hypercomplex pwr(1e300, 1e300) max_iteration 1000000000 precision 1000000000 pigment { rgb 1 } }\n"
    yield "superellipsoid", HEAD + "superellipsoid { <1e-300, 1e300> pigment { rgb 1 } }\n"
    yield "torus_nan", HEAD + "torus { 1e300, 1e-300 pigment { rgb 1 } }\nsphere { <1e308, 1e308, 1e308>, 1e308 }\ncone { 0, 1e308, 1e308, -1e308 }\n"
    yield "text_long", HEAD + 'text { ttf "timrom.ttf" "' + "W" * 2000000 + '" 1, 0 pigment { rgb 1 } }\n'
    yield "text_many", HEAD + repeated('text { ttf "timrom.ttf" "WWWWWWWWWWWWWWWWWWWW" 1, 0 translate I*x }', 1000000)
    yield "objects", HEAD + repeated("sphere { I*x, 1 }", 1000000000)
    yield "objects_on_another", HEAD + repeated("sphere { 0, 1 pigment { rgbt 0.99 } }", 100000)
    yield "infinite_planes", HEAD + repeated("plane { y, -I pigment { rgbt 0.999 } }", 100000)
    yield "transforms", HEAD + "sphere { 0, 1 " + "rotate 1 translate 1e-9 " * 500000 + "}\n"
    yield "scales", HEAD + "sphere { 0, 1 " + "scale 1e30 " * 100 + "matrix <0,0,0,0,0,0,0,0,0,0,0,0> pigment { rgb 1 } }\n"


def light():
    yield "area", HEAD + "light_source { y*9 rgb 1 area_light x, z, 30000, 30000 }\nplane { y, 0 pigment { rgb 1 } }\n" + BALL
    yield "area_huge", HEAD + "light_source { y*9 rgb 1 area_light x, z, 2000000000, 2000000000 adaptive 100 jitter }\n" + BALL
    yield "lights", HEAD + repeated("light_source { <I, 9, 0> rgb 1e-5 }", 1000000) + "plane { y, 0 pigment { rgb 1 } }\n"
    yield "light_groups", HEAD + repeated("light_group { light_source { <I, 9, 0> rgb 1 } sphere { I*x, 1 } }", 100000)
    yield "looks_like", HEAD + "#declare U = sphere { 0, 1 }\n" + repeated("light_source { <I, 9, 0> rgb 1 looks_like { U } projected_through { U } }", 100000)
    yield "radiosity_count", "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 1600 recursion_limit 20 error_bound 1e-9 pretrace_start 1e-5 pretrace_end 1e-5 nearest_count 20 low_error_factor 1e-9 minimum_reuse 1e-9 } }\nplane { y, -1 pigment { rgb 1 } }\n" + BALL
    yield "radiosity_bright", "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 1000000000 always_sample on brightness 1e300 } }\n" + BALL
    for n in ("1e6", "1e9", "1e15", "2147483647"):
        yield f"photons_{n}", HEAD + f"global_settings {{ photons {{ count {n} }} }}\nsphere {{ 0, 1 pigment {{ rgbt 1 }} interior {{ ior 1.5 }} photons {{ target reflection on refraction on }} }}\n"
    yield "photons_spacing", HEAD + "global_settings { photons { spacing 1e-9 gather 1, 1000000000 max_trace_level 256 adc_bailout 0 } }\nsphere { 0, 1 pigment { rgbt 1 } photons { target refraction on } }\n"
    yield "photons_media", HEAD + "global_settings { photons { count 1000000 media 1000000000, 1e-9 } }\nsphere { 0, 5 hollow pigment { rgbt 1 } interior { media { scattering { 1, 1 } } } }\nsphere { 0, 1 pigment { rgbt 1 } photons { target refraction on } }\n"
    mirrors = "box { -9, 9 hollow pigment { rgb 0 } finish { reflection 1 } }\n"
    yield "mirrors", "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }\n" + HEAD.split("\n", 2)[2] + mirrors + repeated("sphere { <mod(I, 5), mod(I, 7), 3>, 0.4 pigment { rgbt 0.99 } finish { reflection 0.99 } interior { ior 1.5 } }", 30)
    yield "trace_level", HEAD + "global_settings { max_trace_level 2000000000 max_intersections 2000000000 adc_bailout 1e-300 }\n" + mirrors + BALL
    yield "glass", "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }\n" + HEAD.split("\n", 2)[2] + repeated("sphere { I*z/10, 1 pigment { rgbt 1 } finish { reflection { 0.5 } } interior { ior 1.01 dispersion 1.1 dispersion_samples 100000000 } }", 60)
    yield "containers", HEAD + repeated("sphere { 0, 1 + I/1000 pigment { rgbt 1 } hollow interior { ior 1.001 media { emission 0.1 } } }", 3000)
    yield "fogs", HEAD + repeated("fog { distance I color rgbt 0.9 turbulence 1 turb_depth 1 }", 100000) + BALL
    yield "rainbows", HEAD + repeated("rainbow { angle 42 width 5 distance 1e5 color_map { [0 rgbt 1] [1 rgbt 0.5] } }", 100000) + BALL
    yield "skies", HEAD + "sky_sphere { " + "pigment { bozo turbulence 1 } " * 50000 + "}\n"


def media():
    box = "box {{ -1, 1 hollow pigment {{ rgbt 1 }} interior {{ media {{ {} }} }} }}\n"
    for n in ("1e4", "1e6", "1e9", "2147483647"):
        for method in (1, 2, 3):
            yield f"samples_{n}_{method}", HEAD + box.format(f"method {method} scattering {{ 1, 1 }} samples {n}, {n} intervals 10 confidence 0.99999 variance 1e-30")
    yield "intervals", HEAD + box.format("method 1 intervals 2000000000 emission 1")
    yield "aa_level", HEAD + box.format("method 3 aa_level 1000000000 aa_threshold 1e-300 emission 1 density { bozo turbulence 1 }")
    yield "many", HEAD + "box { -1, 1 hollow pigment { rgbt 1 } interior { " + "media { emission 0.1 density { bozo } }\n" * 10000 + "} }\n"
    yield "densities", HEAD + box.format("emission 1 " + "density { bozo turbulence 1 }\n" * 20000)
    yield "density_map", HEAD + "#declare D = density { rgb 1 }\n" + repeated("#declare D = density { gradient x density_map { [0 D] [1 D] } }", 60) + box.format("emission 1 density { D }")
    yield "atmosphere", HEAD + "media { scattering { 1, 0.1 } method 2 intervals 100000 samples 100000, 100000 }\nplane { y, -1 pigment { rgb 1 } }\n"
    yield "reference", HEAD + box.format("emission 1 density { df3_none }")


def texts():
    for name, (open_, close) in {"parentheses": ("(", ")"), "braces": ("union {", "}"), "vectors": ("<", ", 1>"), "ifs": ("#if (1)\n", "#end\n"), "comments": ("/*", "*/"), "functions": ("abs(", ")"), "for": ("#for (A, 1, 1)\n", "#end\n"), "minus": ("-", ""), "not": ("!", ""), "arrays": ("array[1]{", "}"), "switch": ("#switch (1) #case (1)\n", "#break #end\n")}.items():
        for n in (1000, 1000000):
            start = {"braces": "", "ifs": "", "comments": "", "for": "", "switch": ""}.get(name, "#declare A = ")
            yield f"{name}_{n}", HEAD + start + open_ * n + ("sphere { 0, 1 }" if name == "braces" else "1" if start else "") + close * n + "\n" + BALL
    yield "identifier", HEAD + "#declare " + "A" * 30000000 + " = 1;\n" + BALL
    yield "number", HEAD + "#declare A = 0." + "1" * 10000000 + ";\n" + BALL
    yield "string", HEAD + '#declare A = "' + "x" * 30000000 + '"\n' + BALL
    yield "unclosed_string", HEAD + '#declare A = "' + "x\n" * 1000000
    yield "unclosed_comment", HEAD + "/*" * 1000000
    yield "names", HEAD + "".join(f"#declare N{i} = {i};\n" for i in range(500000)) + BALL
    yield "errors", HEAD + "sphere { 0, 1 pigmet { } }\n" * 50000
    yield "undeclared", HEAD + "".join(f"object {{ Undeclared{i} }}\n" for i in range(20000))
    yield "nuls", HEAD + "\0" * 1000000
    yield "bytes", HEAD + "".join(chr(33 + i * 7919 % 90) for i in range(1000000))
    yield "blank", HEAD + " " * 50000000 + BALL
    yield "newlines", HEAD + "\n" * 30000000 + "sphere { 0, 1 pigmet }\n"
    yield "defaults", HEAD + "#default { pigment { rgb 1 } }\n" * 200000 + BALL
    yield "include_self", HEAD + '#include "scene.pov"\n'
    yield "debug", HEAD + '#while (1) #debug "all work and no play makes a dull scene\\n" #end\n'
    yield "warning", HEAD + '#for (I, 1, 1e9) #warning concat(str(I, 0, 0), " bottles\\n") #end\n'
    yield "render", HEAD + '#while (1) #render "x" #statistics "x" #end\n'
    yield "write", HEAD + '#fopen F "out.txt" write #while (1) #write(F, "all work and no play\\n") #end\n', {}, ["--allow-write=out.txt"]
    yield "files", HEAD + '#for (I, 1, 1e6) #fopen F concat("f", str(I, 0, 0)) write #fclose F #end\n', {}, ["--allow-write=."]
    yield "open_files", HEAD + '#declare N = array[100000]; #macro M(I) #if (I > 0) #local F = 1; #fopen G concat("f", str(I, 0, 0)) write #undef G M(I - 1) #end #end M(90)\n' + BALL, {}, ["--allow-write=."]
    yield "read_self", HEAD + '#fopen F "scene.pov" read #while (1) #read(F, A) #end\n'
    yield "read_loop", HEAD + '#while (1) #fopen F "data.txt" read #fclose F #end\n', {"data.txt": b"1, 2, 3"}


def pictures():
    for w, h in ((8000, 6000), (100000, 100000), (2147483647, 1), (2147483647, 2147483647)):
        yield f"size_{w}_{h}", HEAD + BALL, {}, [f"+W{w}", f"+H{h}"]
    yield "antialias", HEAD + BALL, {}, ["+A0.0", "+R50"]
    yield "antialias_2", HEAD + "plane { z, 0 pigment { bozo scale 1e-9 } }\n", {}, ["+A0.0", "+R9", "+AM2", "+W640", "+H480"]
    yield "focal_blur", HEAD.replace("look_at 0", "look_at 0 aperture 1e9 blur_samples 1000000000 variance 0 confidence 0.99999999") + BALL
    yield "frames", HEAD + BALL, {}, ["+KFF2000000000"]
    yield "frames_loop", HEAD + "#while (1) #end", {}, ["+KFF10"]
    yield "mesh_camera", "#version 3.7; global_settings { assumed_gamma 1 } camera { mesh_camera { 1000000000 0 mesh { triangle { x, y, z } } } }\n" + BALL
    yield "user_camera", "#version 3.7; global_settings { assumed_gamma 1 } camera { user_defined location { function { sum(I, 1, 1e12, 1) }, function { 0 }, function { -5 } } direction { function { u }, function { v }, function { 1 } } }\n" + BALL
    yield "blocks", HEAD + BALL, {}, ["+BS1", "+W1000", "+H1000"]
    yield "threads", HEAD + BALL, {}, ["+WT100000"]


def png(width, height, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(bytes(rows * (width + 1)), 9)) + chunk(b"IEND", b"")


def images():
    big = 0x7fffffff
    heads = {
        "png": png(big, big, 0), "png_rows": png(30000, 30000, 30000 // 8), "png_bomb": png(20000, 20000, 20000),
        "gif": b"GIF89a" + struct.pack("<HHBBB", 65535, 65535, 0xF7, 0, 0) + bytes(768) + b"," + struct.pack("<HHHHB", 0, 0, 65535, 65535, 0) + b"\x08\x01\x00\x00;",
        "gif_frames": b"GIF89a" + struct.pack("<HHBBB", 1, 1, 0x80, 0, 0) + bytes(6) + (b"," + struct.pack("<HHHHB", 0, 0, 1, 1, 0) + b"\x02\x02\x44\x01\x00") * 200000 + b";",
        "tga": struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 65535, 65535, 32, 0),
        "tga_rle": struct.pack("<BBBHHBHHHHBB", 0, 0, 10, 0, 0, 0, 0, 0, 65535, 65535, 24, 0) + b"\xff\x00\x00\x00" * 100000,
        "ppm": b"P6 2000000000 2000000000 255\n", "ppm_text": b"P3 60000 60000 255\n" + b"1 " * 100000, "pgm": b"P5 65535 65535 65535\n" + bytes(1000),
        "sys": b"BM" + struct.pack("<IHHIIiiHHIIiiII", 54, 0, 0, 54, 40, big, big, 1, 24, 0, 0, 0, 0, 0, 0),
        "iff": b"FORM\x7f\xff\xff\xffILBMBMHD\x00\x00\x00\x14" + struct.pack(">HHhhBBBB", 65535, 65535, 0, 0, 24, 0, 1, 0) + bytes(8) + b"BODY\x7f\xff\xff\xff",
        "jpeg": bytes.fromhex("ffd8ffe000104a46494600010101004800480000ffc0001108ffffffff03012200021101031101ffda000c03010002110311003f00"),
        "tiff": b"II*\x00\x08\x00\x00\x00" + struct.pack("<H", 3) + b"".join(struct.pack("<HHII", t, 4, 1, v) for t, v in ((256, big), (257, big), (273, 8))) + bytes(4),
        "tiff_loop": b"II*\x00\x08\x00\x00\x00" + struct.pack("<H", 2) + b"".join(struct.pack("<HHII", t, 4, 1, v) for t, v in ((256, 10), (257, 10))) + struct.pack("<I", 8),
        "exr": b"v/1\x01\x02\x00\x00\x00" + b"dataWindow\x00box2i\x00\x10\x00\x00\x00" + struct.pack("<iiii", 0, 0, big - 1, big - 1) + b"\x00",
        "hdr": b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000000 +X 1000000000\n" + bytes(1000)}
    for name, data in heads.items():
        kind = name.split("_")[0]
        scene = HEAD + f'box {{ 0, 1 pigment {{ image_map {{ {kind} "image.{kind}" }} }} }}\n'
        yield name, scene, {f"image.{kind}": data}
        if kind in ("png", "tga", "gif", "ppm", "sys"):
            yield f"height_{name}", HEAD + f'height_field {{ {kind} "image.{kind}" pigment {{ rgb 1 }} }}\n', {f"image.{kind}": data}
    yield "many", HEAD + repeated('box { 0, 1 pigment { image_map { png "image.png" } } }', 100000), {"image.png": png(1000, 1000, 1000)}
    yield "interpolated", HEAD + 'box { 0, 1 pigment { image_map { png "image.png" interpolate 4 } } normal { bump_map { png "image.png" bump_size 1e300 } } }\n', {"image.png": png(9000, 9000, 9000)}
    yield "missing", HEAD + "".join(f'box {{ 0, 1 pigment {{ image_map {{ png "no{i}.png" }} }} }}\n' for i in range(3000))


def data():
    df3 = 'box { 0, 1 hollow pigment { rgbt 1 } interior { media { emission 1 density { density_file df3 "d.df3" } } } }\n'
    yield "df3_header", HEAD + df3, {"d.df3": struct.pack(">HHH", 65535, 65535, 65535)}
    yield "df3_short", HEAD + df3, {"d.df3": struct.pack(">HHH", 500, 500, 500) + bytes(1000)}
    yield "df3_zero", HEAD + df3, {"d.df3": struct.pack(">HHH", 0, 1, 1)}
    font = 'text { ttf "f.ttf" "Hello" 1, 0 pigment { rgb 1 } }\n'
    tables = {b"glyf": bytes(64), b"loca": b"\xff" * 64, b"head": bytes(54), b"maxp": b"\x00\x01\x00\x00\xff\xff" + bytes(26), b"cmap": b"\x00\x00\xff\xff" + bytes(60), b"hhea": bytes(34) + b"\xff\xff", b"hmtx": bytes(8), b"name": bytes(6)}
    head, body, offset = struct.pack(">IHHHH", 0x10000, len(tables), 128, 3, 0), b"", 12 + 16 * len(tables)
    for tag, content in tables.items():
        head += tag + struct.pack(">III", 0, offset + len(body), len(content))
        body += content
    yield "font", HEAD + font, {"f.ttf": head + body}
    yield "font_empty", HEAD + font, {"f.ttf": b""}
    yield "font_offsets", HEAD + font, {"f.ttf": head.replace(struct.pack(">I", 64), struct.pack(">I", 0xFFFFFFFF)) + body}
    yield "font_collection", HEAD + font, {"f.ttf": b"ttcf" + struct.pack(">IIII", 0x10000, 0xFFFFFFFF, 12, 12) + bytes(100)}
    photons = 'global_settings { photons { load_file "p.ph" } }\n' + BALL
    yield "photon_file", HEAD + photons, {"p.ph": b"\xff" * 4096}
    yield "photon_empty", HEAD + photons, {"p.ph": b""}
    yield "include_binary", HEAD + '#include "b.inc"\n', {"b.inc": bytes(range(256)) * 1000}
    yield "include_utf16", HEAD + '#include "b.inc"\n', {"b.inc": b"\xff\xfe" + ("sphere { 0, 1 }" * 10000).encode("utf-16-le")}
    yield "include_long", HEAD + '#include "b.inc"\n' * 3, {"b.inc": b"#declare A = 1;\n" * 3000000}


KINDS = {"string": strings, "loop": loops, "macro": macros, "array": arrays, "copies": copies, "texture": textures,
         "function": functions, "shape": shapes, "light": light, "media": media, "text": texts, "picture": pictures,
         "image": images, "data": data}


def bombs():
    for kind, make in KINDS.items():
        for name, text, *rest in make():
            yield Bomb(f"{kind}_{name}", text, *rest)
