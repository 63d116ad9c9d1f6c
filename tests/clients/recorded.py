"""The calls of clients.py, and vapory's, as they were recorded, on scenes of our own that use the language as the clients do: they run where
no client is installed."""
import re
import subprocess

from clients import Failed, call, write


def of(name, scene, words, picture, ini=None, to_standard_output=False):
    """A recorded call as a client: `words` follow `povray`; the files are NAME.pov and NAME.ini."""

    def run(self):
        write(name + ".pov", scene)
        if ini:
            write(name + (".pov.ini" if name == "jmol" else ".ini"), ini)
        if not to_standard_output:
            call("povray", *words)
            return [picture]
        with open(picture, "wb") as out:
            ended = subprocess.run(["povray", *words], stdout=out, stderr=subprocess.PIPE, timeout=120)
        said = ended.stderr.decode(errors="replace")
        if ended.returncode != 0:
            raise Failed(said)
        if name == "leocad" and not re.search(r"Rendered \d+ of \d+ pixels \(100%\)", said):  # its bar
            raise Failed("no progress to read:\n" + said)
        return [picture]

    return type(name.title(), (), {"__doc__": f"The call of {name}.", "package": None, "needs": [], "noisy": "radiosity" in scene, "run": run})


# Macros with textures as arguments; `color` twice where a name stands for a colour; fog as depth.
ASE = """
#declare Paper = color rgb 1;
#declare Ink = rgb <0.1, 0.1, 0.15>;
global_settings {assumed_gamma 1 max_trace_level 6}
background {color Paper}
camera {orthographic right -10.39*x up 7.51*y direction 1.00*z location <0,0,50.00> look_at <0,0,0>}
light_source {<  5.00,   5.00,  20.00> color Paper}
fog {fog_type 1 distance 50.0000 color color Paper}
#declare dull = finish {ambient 0.05 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15}
#declare shiny = finish {ambient 0.05 diffuse 0.3 specular 1.0 roughness 0.001 reflection {color color Paper*0.2}}
#macro ball(WHERE, R, COL, TRANS, FIN)
  sphere{WHERE, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
ball(<  0.99,  -0.48,  -5.00>, 0.76, rgb <0.56, 0.56, 0.56>, 0.3, dull)
ball(< -1.05,   0.47,  -4.44>, 1.26, rgb <1.00, 0.05, 0.05>, 0.0, shiny)
ball(< -2.25,  -1.47,  -14.44>, 1.26, color Ink, 0.0, shiny)
cylinder {<  0.99,  -0.48,  -5.00>, < -1.05,   0.47,  -4.44>, 0.1 pigment {Ink}}
"""
ASE_INI = """Input_File_Name=ase.pov
Output_to_File=True
Output_File_Type=N
Output_Alpha=off
; if you adjust Height, and width, you must preserve the ratio
; Width / Height = 1.383489
Width=160
Height=115.64885496183206
Antialias=True
Antialias_Threshold=0.1
Display=False
Pause_When_Done=False
Verbose=False
"""

# No #version, a negative phong, primitives with bare pigments.
PYMOL = """camera {direction<0.0,0.0,  -2.835>
 location <0.0 , 0.0 , 0.0>
 right 1.3333333731*x up y
 }
#default { finish{phong   -1.000 ambient    0.500 diffuse    0.450 phong_size 13.750000}}
light_source{<4000.0000,4000.0000,9960.0000>  rgb<1.0,1.0,1.0>}
cylinder{<-2.7,-1.2,-50.5>,
<1.3,3.5,-50.5>,
 1.2500000000
open
pigment{color rgb<0.20001,0.2000,1.0000>}}
sphere{<1.3,3.5,-50.5>, 1.9
pigment{color rgb<0.20001,1.0000,0.2000>}}
#declare Skin = texture{pigment{color rgb<1,.5,.5>}};
mesh { smooth_triangle { <-5,-5,-52>, <0,0,1>, <5,-5,-52>, <0.5,0,1>, <0,5,-56>, <0,0.5,1> texture{Skin} } }
"""

# A mesh2 with a texture list, radiosity, an area of the sky that is a gradient.
BLENDER = """#version 3.7;
#declare Default_texture = texture{pigment {rgb 0.8} finish {brilliance 3.8} };
global_settings {
    assumed_gamma 1
    max_trace_level 5
    ambient_light rgb<1,1,1>
    radiosity { adc_bailout 0.0039 brightness 1 count 30 error_bound 0.4 gray_threshold 0.0 low_error_factor 0.5 maximum_reuse 0.2
      minimum_reuse 0.015 nearest_count 5 pretrace_start 0.04 pretrace_end 0.01 recursion_limit 2 normal off }
}
background {rgbt<0.05, 0.05, 0.05, 0.75>}
camera {
    location  <0, 0, 0>
    look_at  <0, 0, -1>
    right <-1.777, 0, 0>
    up <0, 1, 0>
    angle  39.597755
    rotate  <-26.440719, -46.692417, 0.000000>
    translate <7.358891, 4.958309, 6.925791>
}
light_source {
    < 0,0,0 >
    color srgb<1.2, 1.2, 1.2>
    looks_like { sphere {0, 0.25 hollow material {texture {pigment {rgbt 1}} interior {ior 1}} } }
    fade_distance 15.0
    fade_power 2
    matrix <-0.290865, -0.055189, 0.955171,  -0.771101, 0.604525, -0.199883,  -0.566393, -0.794672, -0.218391,  4.076245, 5.903862, -1.005454>
}
#declare Shape =
mesh2 {
    vertex_vectors { 8, <1,1,1>, <1,1,-1>, <1,-1,1>, <1,-1,-1>, <-1,1,1>, <-1,1,-1>, <-1,-1,1>, <-1,-1,-1> }
    normal_vectors { 6, <0,1,0>, <0,0,1>, <-1,0,0>, <0,-1,0>, <1,0,0>, <0,0,-1> }
    texture_list { 2, texture{pigment {rgb<0.8, 0.3, 0.2>} finish {diffuse 0.8 specular 0.4 roughness 0.02} }, texture{Default_texture} }
    face_indices { 12, <0,4,5>,0, <0,1,5>,0, <0,2,6>,0, <0,4,6>,0, <4,5,7>,1, <4,6,7>,1, <2,3,7>,0, <2,6,7>,0, <0,1,3>,0, <0,2,3>,0, <1,3,7>,1, <1,5,7>,1 }
    normal_indices { 12, <0,0,0>, <0,0,0>, <1,1,1>, <1,1,1>, <2,2,2>, <2,2,2>, <3,3,3>, <3,3,3>, <4,4,4>, <4,4,4>, <5,5,5>, <5,5,5> }
}
object{ Shape hollow matrix <1,0,0, 0,1,0, 0,0,1, 0,0.2,0> }
plane { y, -1 texture { Default_texture } }
"""
BLENDER_INI = """Version=3.7
All_File=1
Input_File_Name='blender.pov'
Output_File_Name='blender.png'
Width=160
Height=120
Bounding_Method=2
Display=1
Pause_When_Done=0
Output_File_Type=N
Output_Alpha=1
Antialias=on
Antialias_Depth=2
Antialias_Threshold=0.03
Sampling_Method=2
Antialias_Gamma=2.5
Jitter=off
"""

# Colours as macros, bricks as meshes of hundreds of triangles, a floor, four lights.
LEOCAD = """// Generated By LeoCAD 21.06
#version 3.7;

global_settings { assumed_gamma 1.0 }

#declare lg_quality = 3;
#ifndef (SkipWriteLightsMacro)
#macro WriteLight(Where, Power)
light_source { Where color rgb Power area_light <20, 0, 0>, <0, 0, 20>, 2, 2 circular orient }
#end
#end
#ifndef (Brick_Red) #declare Brick_Red = texture { pigment { rgb <0.7, 0.02, 0.02> filter 0 } finish { ambient 0.1 diffuse 0.7 phong 0.4 phong_size 40 reflection { 0.02, 0.1 } } } #end
camera {
  perspective
  right -image_width / image_height * x
  sky<0,0,1>
  location <150, -250, 150>
  look_at <0, 0, 10>
  angle 30
}
WriteLight(<200, -300, 400>, 0.7)
WriteLight(<-300, -100, 300>, 0.4)
background { color rgb <1, 1, 1> }
#declare Stud = union { cylinder { 0, 4*z, 6 } torus { 5.5, 0.5 rotate 90*x translate 4*z } }
#declare Brick = mesh {
#local I = 0;
#while (I < 4)
  triangle { vrotate(<20, 40, 0>, 90*I*z)*<1,1,1>, vrotate(<-20, 40, 0>, 90*I*z), vrotate(<-20, 40, 24>, 90*I*z) }
  triangle { vrotate(<20, 40, 0>, 90*I*z), vrotate(<20, 40, 24>, 90*I*z), vrotate(<-20, 40, 24>, 90*I*z) }
  #local I = I + 1;
#end
}
merge {
  object { Brick matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> }
  box { <-40, -20, 0>, <40, 20, 24> }
  #local I = -30; #while (I <= 30) object { Stud translate <I, 10, 24> } object { Stud translate <I, -10, 24> } #local I = I + 20; #end
  texture { Brick_Red }
}
"""

# A state in comments, macros for every kind of thing, numbers as the program prints them.
JMOL = """/****** Jmol Embedded Script ****
function _setState() { set ambientPercent 45; }
***** /not the end of a comment/ ****/
#declare Width = 160;
#declare Height = 120;
#declare minScreenDimension = 120;
#declare showAtoms = true;
#declare noShadows = true;
camera{
  orthographic
  location < Width/2, -Height/2, 0>
  direction <0, 0,  10>
  sky <0, -1, 0>
  right < -Width, 0, 0>
  up < 0, Height, 0>
  look_at < Width/2, Height/2, 1000 >
}
background { color rgb <0,0,0> }
light_source { <-100,-100,-200>  rgb <1,1,1> }
#macro b(X,Y,Z,RADIUS,R,G,B,T)
 sphere{<X,Y,Z>,RADIUS
  pigment{rgbt<R,G,B,T>}
  translate<0,0,0>
  finish { ambient 0.45 diffuse 0.84 specular 0.22 roughness .00001 metallic phong 0.9 phong_size 120 }
  #if (noShadows) no_shadow #end
  }
#end
#macro c(X1,Y1,Z1,X2,Y2,Z2,RADIUS,R,G,B,T)
 cylinder{<X1,Y1,Z1>,<X2,Y2,Z2>,RADIUS open pigment{rgbt<R,G,B,T>} finish { ambient 0.45 diffuse 0.84 } no_shadow}
#end
b(80.0,60.0,1000.0,31.25,0.56,0.56,0.56,0.0)
b(120.50,41.0,1020.0,21.25,1.0,0.05,0.05,0.5)
b(40.0,90.0,980.0,11.25,1.0,1.0,1.0,0.0)
c(80.0,60.0,1000.0,40.0,90.0,980.0,6.5,0.9,0.9,0.9,0.0)
"""
JMOL_INI = """; Created by: Jmol 14.32.83  2023-01-07 08:24
; Creation date: Wed, 25 Nov 2026 02:18:03 +0000


; Jmol state: (embedded in input file)
Input_File_Name=jmol.pov
Output_to_File=true
Output_File_Type=N
Output_File_Name=jmol.pov.png
Width=160
Height=120
Antialias=true
Antialias_Threshold=0.1
Display=true
Pause_When_Done=true
Warning_Level=5
Verbose=false
"""

# Messages with control characters, logic on switches, #version in the middle.
OPEN_BABEL = """#declare Balls = true;
#ifndef (Sticks) #declare Sticks = false; #end
#if (!((Balls | Sticks) | Sticks))
 #error "Select a model"
#end
light_source { <3.9,3.0,-8.2> color rgb <1,1,1>    // light's color
}
background { color rgb <0.95 0.95 0.95> }
camera { location  <1.9,0.03,-10.2> look_at   <1.9,0.03,-0.26> right     x*image_width/image_height }
#version 3.6;
#render "\\b\\b \\n\\n"
#declare Where_1 = <1.07827,-0.0643226,-0.0318495>;
#declare Atom = sphere { <0,0,0>, 0.7 pigment { color rgb <0.4,0.4,0.4> } finish { ambient 0.2 diffuse 0.8 phong 1.0 phong_size 80 } }
#declare Bond = cylinder { <0,0,0>, <1,0,0>, 0.1 texture { pigment { color rgb <0.6, 0.6, 0.6> } } }
#declare mol_0 = union {
  object { Atom translate Where_1 }
  #if (Balls) object { Bond scale <1.51431,1.0000,1.0000> rotate <0.0000,0.0000,39.98> rotate <0.0000,0.26976,0.0000> translate Where_1 } #end
  no_shadow
}
union { object { mol_0 rotate <0, 10, 0> } }
"""

# Boxes and spheres by matrices, alpha as transmit, dents of depth 0.
STRUCTURE_SYNTH = """global_settings { max_trace_level 5 ambient_light rgb <1,1,1> }
#declare Finish = finish { ambient 0.1 diffuse 0.5 specular 0.5 };
#declare Normal = normal { dents 0 scale 0.01 };
plane { z, 100.0 texture { pigment { color rgb <0.0,0.0,0.0> } finish { ambient 1 } } hollow }
camera { location <4,3,-20> look_at <0,0,0> direction <-0.18,-0.14,0.97> right <0.98*1.33333,0*1.33333,0.18*1.33333> up <-0.02,0.99,0.14> angle 60 }
light_source { <500,500,-1000> rgb <1,1,1> shadowless }
light_source { <-500,-500,-1000> rgb <1,1,1> shadowless }
#declare I = 0;
#while (I < 30)
object { box { <0,  0.0, 0>, <1,  1,  1> } matrix < cos(I/4), sin(I/4), 0, -sin(I/4), cos(I/4), 0, 0, 0, 1, 6*cos(I/4), 5*sin(I/4), I/5 >
  texture { pigment { color rgbt <I/30,1-I/30,0.5,I/60> } finish { Finish } normal { Normal } } }
object { sphere { <5*cos(I/4), 4*sin(I/4), I/5>, 0.5 } texture { pigment { color rgbt <1,I/30,0.2,0> } finish { Finish } normal { Normal } } }
#declare I = I + 1;
#end
"""

RECORDED = {
    "ase": of("ase", ASE, ["ase.ini"], "ase.png", ini=ASE_INI),
    "pymol": of("tmp_pymol", PYMOL, "+FN -D +Itmp_pymol.pov +Otmp_pymol.png +W160 +H120 +A".split(), "tmp_pymol.png"),
    "blender": of("blender", BLENDER, ["blender.ini", "-d"], "blender.png", ini=BLENDER_INI),
    "leocad": of("leocad", LEOCAD, '+I"leocad.pov" +W160 +H90 -O- +Q11 +R3 +A0.1 +J0.5 +FN -D'.split(), "leocad.png", to_standard_output=True),
    "openbabel": of("openbabel", OPEN_BABEL, "+Iopenbabel.pov +W160 +H120 -D".split(), "openbabel.png"),
    "jmol": of("jmol", JMOL, ["jmol.pov.ini"], "jmol.pov.png", ini=JMOL_INI),
    "structure_synth": of("structure_synth", STRUCTURE_SYNTH, "+Istructure_synth.pov +Ostructure_synth.png +W160 +H120 +A -D".split(), "structure_synth.png"),
    "vapory": of("__temp__", PYMOL, "__temp__.pov +H120 +W160 +Q9 +A0.010000 -D Output_File_Type=N +O-".split(), "vapory.png", to_standard_output=True),
}
