"""Cameras, camera normals and focal blur: group -> (stage, {name: the camera statement})."""

# A room of coloured things all around the origin, each direction with another one.
ROUND = """// @title@
#version @version@;
global_settings { assumed_gamma 1 @settings@ }
@it@
light_source { <2, 8, -4> rgb 1 }
light_source { <-3, 3, 3> rgb 0.3 shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.85, 0.8, 0.7>] [1 rgb <0.2, 0.4, 0.8>] } scale 2 translate -y } }
plane { y, -1.5 pigment { checker rgb 0.85, rgb <0.5, 0.6, 0.4> } }
#declare I = 0;
#while (I < 12)
  sphere { <0, -0.7, 4>, 0.7 pigment { rgb <mod(I, 2)*0.8, mod(I, 3)*0.4, 0.2 + mod(I, 5)*0.15> } rotate 30*I*y }
  box { <-0.25, 0, 3.6>, <0.25, 1.2, 4.1> pigment { rgb <0.9, 0.2 + mod(I, 4)*0.2, 0.2> } rotate (30*I + 15)*y }
  #declare I = I + 1;
#end
torus { 2.2, 0.12 rotate 15*x translate 1.7*y pigment { rgb <0.9, 0.7, 0.2> } finish { phong 0.5 } }
@objects@
"""

AT = "location <0.2, 0.4, -1> right 4/3*x up y"
LOOK = AT + " look_at <0.3, -0.2, 4>"
FRONT = "location <0.5, 1, -2.5> right 4/3*x up y look_at <0, 0, 3>"

KINDS = {
    "none": "",
    "perspective": f"camera {{ perspective {FRONT} }}",
    "perspective_angle": f"camera {{ {FRONT} angle 75 }}",
    "perspective_direction": f"camera {{ {FRONT} direction 2*z }}",
    "perspective_left_handed": "camera { location <0.5, 1, -2.5> right -4/3*x up y look_at <0, 0, 3> }",
    "perspective_sheared": "camera { location <0.5, 0.5, -2.5> right <1.3, 0.2, 0> up <0.1, 1, 0> direction <0.1, 0, 1.2> }",
    "sky": "camera { location <0.5, 1, -2.5> sky <0.4, 1, 0.2> right 4/3*x up y look_at <0, 0, 3> }",
    "z_up": "camera { location <0, -2, 1> sky z up z right 4/3*x look_at <0, 1, 0> rotate -90*x }",
    "transformed": f"camera {{ {FRONT} rotate <5, 20, 10> translate <0.2, 0.3, -0.4> scale <1, 1.1, 0.9> matrix <1, 0.1, 0, 0, 1, 0, 0.05, 0, 1, 0, 0.1, 0> }}",
    "declared": f"#declare C = camera {{ {FRONT} angle 60 }} camera {{ C rotate 40*y }}",
    "default": f"#default {{ camera {{ {FRONT} angle 50 }} }} camera {{ rotate 20*y }}",
    "two": f"camera {{ {AT} }} camera {{ {FRONT} angle 40 }}",
    "old_order": {"it": "camera { location <0.5, 1, -2.5> look_at <0, 0, 3> right 4/3*x translate 0.2*y angle 60 }", "version": "3.1"},
    "orthographic": "camera { orthographic location <1, 2, -5> look_at <0, 0, 3> right 4/3*x up y }",
    "orthographic_angle": "camera { orthographic angle 50 location <1, 2, -5> look_at <0, 0, 3> right 4/3*x up y }",
    "orthographic_size": "camera { orthographic location <1, 2, -5> right 8*x up 6*y direction <-0.2, -0.4, 1.5> }",
    "orthographic_bare_angle": "camera { orthographic angle location <1, 2, -5> look_at <0, 0, 3> right 2*x up 1.5*y }",
    "fisheye": f"camera {{ fisheye {LOOK} angle 180 }}",
    "fisheye_wide": f"camera {{ fisheye {AT} angle 300 }}",
    "fisheye_narrow": f"camera {{ fisheye {LOOK} right x up y angle 60 }}",
    "ultra_wide_angle": f"camera {{ ultra_wide_angle {LOOK} angle 120 }}",
    "ultra_wide_angle_half": f"camera {{ ultra_wide_angle {AT} angle 220 }}",
    "omnimax": f"camera {{ omnimax {LOOK} }}",
    "omnimax_square": "camera { omnimax location <0.2, 0.4, -1> right x up y }",
    "omnimax_narrow": "camera { omnimax location <0.2, 0.4, -1> right 1.2*x up y look_at <0, 1, 3> }",
    "panoramic": f"camera {{ panoramic {LOOK} }}",
    "panoramic_wide": "camera { panoramic location <0.2, 0.4, -1> right 2*x up 0.8*y direction 0.7*z }",
    "cylinder_1": f"camera {{ cylinder 1 {LOOK} angle 160 }}",
    "cylinder_2": f"camera {{ cylinder 2 {LOOK} angle 140 }}",
    "cylinder_3": "camera { cylinder 3 location <0.2, 0.4, -1> right 4/3*x up 3*y angle 200 }",
    "cylinder_4": "camera { cylinder 4 location <0.2, 0.4, -1> right 4*x up y angle 150 }",
    "spherical": f"camera {{ spherical {AT} }}",
    "spherical_angle": f"camera {{ spherical {LOOK} angle 200 100 }}",
    "spherical_one_angle": f"camera {{ spherical {AT} angle 150 }}",
    "inside_glass": {"it": f"camera {{ {FRONT} }}", "objects": "sphere { <0.5, 1, -2.5>, 1 pigment { rgbt <0.9, 1, 0.95, 0.95> } interior { ior 1.3 } }"},
    "mesh_camera_0": {"it": """
mesh { @grid@ }
camera { mesh_camera { 1 0 mesh { Screen } } }"""},
    "mesh_camera_1": {"it": "camera { mesh_camera { 2 1 mesh { Screen } mesh { Screen } } }"},
    "mesh_camera_2": {"it": "camera { mesh_camera { 1 2 mesh { Screen } } }"},
    "mesh_camera_3": {"it": "camera { mesh_camera { 1 3 mesh { Sheet rotate <3, 2, 0> } } location 0 direction z }"},
    "mesh_camera_3_smooth": {"it": "camera { mesh_camera { 1 3 mesh { Sheet rotate <3, 2, 0> } smooth } location <0, 0, 0.1> }"},
}
# One small face for every pixel of 160x120, and one sheet with texture coordinates.
SCREEN = """#declare Screen = mesh {
  #declare J = 0;
  #while (J < 120)
    #declare I = 0;
    #while (I < 160)
      #declare P = <(I - 80)/60, (60 - J)/60, -1>;
      #declare D = vnormalize(<P.x, P.y + 0.1*sin(I/9), 1>);
      #declare A = vnormalize(vcross(D, y))*0.001;
      #declare B = vnormalize(vcross(A, D))*0.001;
      triangle { P + A, P - A - B, P - A + B }
      #declare I = I + 1;
    #end
    #declare J = J + 1;
  #end
}"""
SHEET = """#declare Sheet = mesh {
  smooth_triangle { <-1, -0.7, -2>, <-0.4, -0.31, 1>, <1, -0.7, -2>, <0.42, -0.3, 1>, <1, 0.7, -2>, <0.4, 0.33, 1> uv_vectors <0, 0>, <1, 0>, <1, 1> }
  smooth_triangle { <-1, -0.7, -2>, <-0.4, -0.31, 1>, <1, 0.7, -2>, <0.4, 0.33, 1>, <-1, 0.7, -2>, <-0.38, 0.3, 1> uv_vectors <0, 0>, <1, 1>, <0, 1> }
}"""
for _name, _entry in KINDS.items():
    if _name.startswith("mesh_camera"):
        _entry["it"] = (SHEET if "Sheet" in _entry["it"] else SCREEN) + "\n" + _entry["it"].replace("mesh { @grid@ }", "")

NORMALS = {
    "bumps": f"camera {{ {FRONT} normal {{ bumps 0.2 scale 0.1 }} }}",
    "ripples": f"camera {{ {FRONT} normal {{ ripples 0.4 frequency 8 }} }}",
    "gradient_slope_map": f"camera {{ {FRONT} normal {{ gradient x 0.3 slope_map {{ [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] }} scale 0.2 }} }}",
    "fisheye": f"camera {{ fisheye {LOOK} angle 180 normal {{ waves 0.3 frequency 4 }} }}",
    "spherical": f"camera {{ spherical {AT} normal {{ bumps 0.3 scale 0.3 }} }}",
    "panoramic": f"camera {{ panoramic {LOOK} normal {{ bumps 0.3 scale 0.3 }} }}",
    "cylinder": f"camera {{ cylinder 1 {LOOK} angle 160 normal {{ wrinkles 0.5 scale 0.3 }} }}",
    "orthographic": "camera { orthographic location <1, 2, -5> look_at <0, 0, 3> right 8*x up 6*y normal { quilted 0.3 scale 0.1 } }",
    "with_blur": f"camera {{ {FRONT} normal {{ bumps 0.2 scale 0.2 }} aperture 0.3 blur_samples 7 focal_point <0, 0, 3> }}",
}

BLUR = f"{FRONT} focal_point <0, -0.7, 2.5>"
BLURS = {
    "samples_4": f"camera {{ {BLUR} aperture 0.4 blur_samples 4 }}",
    "samples_7": f"camera {{ {BLUR} aperture 0.4 blur_samples 7 }}",
    "samples_19": f"camera {{ {BLUR} aperture 0.4 blur_samples 19 }}",
    "samples_37": f"camera {{ {BLUR} aperture 0.4 blur_samples 37 }}",
    "samples_50": f"camera {{ {BLUR} aperture 0.6 blur_samples 50 }}",
    "samples_minimum": f"camera {{ {BLUR} aperture 0.4 blur_samples 10, 30 }}",
    "wide_aperture": f"camera {{ {BLUR} aperture 2 blur_samples 24 }}",
    "confidence": f"camera {{ {BLUR} aperture 0.4 blur_samples 30 confidence 0.5 variance 1/1000 }}",
    "confidence_high": f"camera {{ {BLUR} aperture 0.4 blur_samples 30 confidence 0.99 variance 1/100 }}",
    "variance_0": f"camera {{ {BLUR} aperture 0.4 blur_samples 16 variance 0 }}",
    "variance_high": f"camera {{ {BLUR} aperture 0.4 blur_samples 40 variance 0.05 }}",
    "without_focal_point": "camera { location <0.5, 1, -2.5> right 4/3*x up y look_at <0, 0, 3> angle 60 aperture 0.2 blur_samples 12 }",
    "bokeh": f"camera {{ {BLUR} aperture 0.6 blur_samples 24 bokeh {{ pigment {{ object {{ cylinder {{ 0.5, <0.5, 0.5, 1>, 0.4 }} color rgb 0, color rgb 1 }} }} }} }}",
    "bokeh_gradient": f"camera {{ {BLUR} aperture 0.6 blur_samples 18 bokeh {{ pigment {{ gradient x color_map {{ [0 rgb 0] [1 rgb 1] }} }} }} }}",
    "fisheye": f"camera {{ fisheye {LOOK} angle 160 aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "orthographic": "camera { orthographic location <1, 2, -5> look_at <0, 0, 3> right 4/3*x up y aperture 0.4 blur_samples 7 focal_point <0, 0, 3> }",
    "panoramic": f"camera {{ panoramic {LOOK} aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "ultra_wide_angle": f"camera {{ ultra_wide_angle {LOOK} angle 120 aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "omnimax": f"camera {{ omnimax {LOOK} aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "cylinder_1": f"camera {{ cylinder 1 {LOOK} angle 160 aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "spherical": f"camera {{ spherical {AT} aperture 0.4 blur_samples 12 focal_point <0, 0, 3> }}",
    "area_light": {"it": f"camera {{ {BLUR} aperture 0.4 blur_samples 7 }}", "objects": "light_source { <-3, 6, -2> rgb 0.6 area_light 2*x, 2*z, 3, 3 }"},
    "scaled": f"camera {{ {BLUR} aperture 0.4 blur_samples 12 scale 1.3 rotate 10*y }}",
}

GROUPS = {"kinds": (ROUND, KINDS), "normal": (ROUND, NORMALS), "focal_blur": (ROUND, BLURS)}
