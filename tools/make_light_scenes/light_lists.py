"""Lights, finishes, interiors, shadows, light groups and atmosphere: group -> (stage, {name: what takes the place of @it@})."""

HEAD = """// @title@
#version @version@;
global_settings { assumed_gamma 1 @settings@ }
"""
FLOOR = "plane { y, 0 pigment { checker rgb 0.85, rgb <0.55, 0.6, 0.7> } }"

# Things that catch light and cast shadows.
LIGHTS = HEAD + """
camera { location <0, 3.2, -7.5> look_at <0, 0.7, 0> angle 45 }
@it@
""" + FLOOR + """
sphere { <-1.5, 0.8, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.3> } finish { specular 0.5 roughness 0.02 } }
box { <0.6, 0, -0.5>, <1.7, 1.3, 0.6> rotate 15*y pigment { rgb <0.4, 0.7, 0.5> } finish { phong 0.4 } }
cone { <0, 0.02, -1.6>, 0.5, <0, 1.1, -1.6>, 0 pigment { rgbf <0.8, 0.8, 1, 0.6> } }
@objects@
"""

# One sphere and one box with the finish that is looked at.
FINISH = HEAD + """
camera { location <0, 2.6, -6> look_at <0, 0.75, 0> angle 45 }
light_source { <-4, 6, -5> rgb 0.9 }
light_source { <5, 3, -2> rgb <0.3, 0.35, 0.5> }
background { rgb <0.3, 0.4, 0.6> }
""" + FLOOR + """
#declare Coat = texture { pigment { rgb <0.85, 0.55, 0.25> } finish { @it@ } }
sphere { <-1.1, 0.95, 0>, 0.95 texture { Coat } }
box { -0.65, 0.65 rotate <15, 35, 0> translate <1.2, 0.95, 0.1> texture { Coat } }
@objects@
"""

# A glass ball and a glass prism before a striped wall.
INTERIOR = HEAD + """
camera { location <0, 2, -6.5> look_at <0, 0.9, 0> angle 42 }
light_source { <-3, 7, -4> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.9, 0.8>] [1 rgb <0.2, 0.4, 0.8>] } } }
""" + FLOOR + """
plane { -z, -4 pigment { gradient x color_map { [0.5 rgb 0.9] [0.5 rgb <0.2, 0.3, 0.5>] } scale 0.6 rotate 20*z } }
#declare Glass = texture { pigment { rgbf <0.97, 0.99, 0.98, 0.9> } finish { ambient 0 diffuse 0.05 specular 0.5 roughness 0.01 reflection 0.08 } }
#declare Inside = interior { @it@ }
sphere { <-1.2, 1, 0>, 1 texture { Glass } interior { Inside } }
intersection { plane { -z, 0.7 } plane { z, 0.7 } plane { <1, 0.7, 0>, 0.55 } plane { <-1, 0.7, 0>, 0.55 } plane { -y, 0.7 } rotate 25*y translate <1.3, 0.75, 0> texture { Glass } interior { Inside } }
@objects@
"""

# A row of posts that goes far away, a mirror and a clear pane, under the atmosphere that is looked at.
ATMOSPHERE = HEAD + """
camera { location <0, 1.6, -6> look_at <0, 1.7, 0> angle 60 }
light_source { <-30, 60, -20> rgb 1 }
@it@
plane { y, 0 pigment { checker rgb 0.7, rgb <0.3, 0.45, 0.25> scale 1.5 } }
#declare I = 0;
#while (I < 6)
  cylinder { <-2.2, 0, I*5>, <-2.2, 2.6, I*5>, 0.3 pigment { rgb <0.8, 0.3, 0.2> } }
  sphere { <2.4, 0.9, I*5 - 1>, 0.7 pigment { rgb <0.3, 0.4, 0.8> } finish { reflection 0.4 } }
  #declare I = I + 1;
#end
box { <-0.7, 0.2, 1>, <0.7, 1.8, 1.1> pigment { rgbt <1, 1, 1, 0.8> } finish { reflection 0.2 } hollow }
@objects@
"""

KEY = "light_source { <-4, 6, -5> rgb 1 }"
AREA = "light_source { <-3, 6, -4> rgb 1 area_light %s }"

LIGHT_KINDS = {
    "point": KEY,
    "point_colour": "light_source { <-4, 6, -5> rgb <1, 0.6, 0.3> } light_source { <4, 5, -5> rgb <0.2, 0.4, 0.9> }",
    "negative": KEY + " light_source { <3, 4, -3> rgb -0.4 }",
    "bright": "light_source { <-4, 6, -5> rgb 3 }",
    "many": "#declare I = 0; #while (I < 7) light_source { <5*cos(I), 5, 5*sin(I)> rgb 0.2 } #declare I = I + 1; #end",
    "shadowless": KEY + " light_source { <4, 5, -5> rgb 0.5 shadowless }",
    "spotlight_default": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> }",
    "spotlight_radius_falloff": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> radius 12 falloff 22 }",
    "spotlight_tightness": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> radius 0 falloff 40 tightness 10 }",
    "spotlight_hard_edge": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> radius 22 falloff 20 }",
    "spotlight_wide": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> radius 95 falloff 100 tightness 1.5 }",
    "spotlight_without_point_at": "light_source { <0, 2, -6> rgb 1 spotlight radius 10 falloff 25 }",
    "spotlight_shadowless": "light_source { <-2, 5, -3> rgb 1 spotlight point_at <0, 0.5, 0> radius 12 falloff 22 shadowless }",
    "shadowless_spotlight": "light_source { <-2, 5, -3> rgb 1 shadowless spotlight point_at <0, 0.5, 0> radius 12 falloff 22 }",
    "spotlight_moved": "light_source { 0 rgb 1 spotlight point_at <0, -1, 0.4> radius 12 falloff 25 scale 2 rotate 15*z translate <0, 5, -3> }",
    "cylinder_default": "light_source { <-1, 5, -2> rgb 1 cylinder point_at <0, 0, 0> }",
    "cylinder_radius_falloff": "light_source { <-1, 5, -2> rgb 1 cylinder point_at <0, 0, 0> radius 1.2 falloff 2.2 }",
    "cylinder_tightness": "light_source { <-1, 5, -2> rgb 1 cylinder point_at <0, 0, 0> radius 0 falloff 3 tightness 3 }",
    "cylinder_parallel": "light_source { <-1, 5, -2> rgb 1 parallel cylinder point_at <0, 0, 0> radius 1.2 falloff 2.2 }",
    "parallel": "light_source { <-4, 6, -5> rgb 1 parallel point_at <0, 0, 0> }",
    "parallel_behind": "light_source { <0, 0.9, 0> rgb 1 parallel point_at <0.3, 0, 0.2> }",
    "parallel_spotlight": "light_source { <-2, 5, -3> rgb 1 parallel spotlight point_at 0 radius 12 falloff 22 }",
    "parallel_fade": "light_source { <-4, 6, -5> rgb 1 parallel point_at 0 fade_distance 5 fade_power 2 }",
    "fade_power_1": "light_source { <-3, 4, -3> rgb 1 fade_distance 3 fade_power 1 }",
    "fade_power_2": "light_source { <-3, 4, -3> rgb 1 fade_distance 4 fade_power 2 }",
    "fade_power_fraction": "light_source { <-3, 4, -3> rgb 1 fade_distance 4 fade_power 1.7 }",
    "fade_distance_only": "light_source { <-3, 4, -3> rgb 1 fade_distance 4 }",
    "fade_spotlight": "light_source { <-2, 5, -3> rgb 1.5 spotlight point_at 0 radius 15 falloff 25 fade_distance 4 fade_power 2 }",
    "looks_like": "light_source { <0.2, 1.9, -1> rgb 1 looks_like { sphere { 0, 0.25 pigment { rgb <1, 0.9, 0.5> } finish { ambient 1 diffuse 0 } } } fade_distance 3 fade_power 1 }",
    "looks_like_scaled": "light_source { 0 rgb 1 looks_like { box { -0.2, 0.2 pigment { rgb <1, 0.9, 0.5> } finish { ambient 1 } } } scale <1, 2, 1> rotate 30*z translate <0.2, 2, -1> }",
    "projected_through": "light_source { <-3, 6, -4> rgb 1 projected_through { disc { <-1.5, 3, -2>, <1.5, 3, 2>, 0.7, 0.2 } } }",
    "projected_through_shadowless": "light_source { <-3, 6, -4> rgb 1 shadowless projected_through { box { <-2.4, 2.6, -2.6>, <-1, 2.7, -1.2> } } }",
    "in_a_union": "union { light_source { <-4, 6, -5> rgb 0.8 } sphere { <0, 0.4, 1.5>, 0.4 pigment { rgb 0.6 } } rotate 20*y }",
    "declared": "#declare L = light_source { <-4, 6, -5> rgb 0.8 } light_source { L } light_source { L rotate -80*y }",
    "no_light": "",
    "ambient_light": {"it": KEY, "settings": "ambient_light rgb <2, 0.5, 1>"},
    "global_lights_many_old": {"it": KEY, "version": "3.5"},
}

AREA_LIGHTS = {
    "grid_4_4": AREA % "3*x, 3*y, 4, 4",
    "grid_5_3": AREA % "3*x, 2*z, 5, 3",
    "grid_9_9": AREA % "3*x, 3*z, 9, 9",
    "grid_7_1": AREA % "4*x, y, 7, 1",
    "grid_1_6": AREA % "x, 4*z, 1, 6",
    "grid_1_1": AREA % "x, y, 1, 1",
    "skew": AREA % "<3, 1, 0>, <0, 1, 2>, 6, 5",
    "adaptive_0": AREA % "3*x, 3*y, 9, 9 adaptive 0",
    "adaptive_1": AREA % "3*x, 3*y, 9, 9 adaptive 1",
    "adaptive_3": AREA % "3*x, 3*y, 17, 17 adaptive 3",
    "adaptive_dim": "light_source { <-3, 6, -4> rgb 0.05 area_light 3*x, 3*y, 9, 9 adaptive 1 } light_source { <4, 5, -5> rgb 0.6 shadowless }",
    "adaptive_bright": "light_source { <-3, 6, -4> rgb 20 area_light 3*x, 3*y, 9, 9 adaptive 1 fade_distance 1 fade_power 2 }",
    "circular": AREA % "3*x, 3*y, 6, 6 circular",
    "circular_adaptive": AREA % "3*x, 3*y, 9, 9 circular adaptive 1",
    "orient": AREA % "3*x, 3*y, 5, 5 circular orient",
    "orient_not_circular": AREA % "3*x, 3*y, 5, 5 orient",
    "orient_unequal": AREA % "2*x, 4*y, 5, 4 circular orient adaptive 1",
    "illumination": AREA % "4*x, 4*z, 4, 4 area_illumination on",
    "illumination_adaptive": AREA % "4*x, 4*z, 5, 5 adaptive 1 area_illumination",
    "illumination_fade": AREA % "4*x, 4*z, 3, 3 area_illumination fade_distance 4 fade_power 2",
    "illumination_circular": AREA % "4*x, 4*z, 5, 5 circular orient area_illumination on",
    "illumination_spotlight": "light_source { <-3, 6, -4> rgb 1 spotlight point_at 0 radius 15 falloff 25 area_light 2*x, 2*z, 3, 3 area_illumination }",
    "illumination_off": AREA % "4*x, 4*z, 4, 4 area_illumination off",
    "illumination_without_area": "light_source { <-3, 6, -4> rgb 1 area_illumination on }",
    "illumination_backside": {"it": AREA % "4*x, 4*z, 3, 3 area_illumination", "objects": "disc { <2.4, 1, -1.5>, <1, 0.2, 1>, 0.6 pigment { rgb 0.8 } finish { diffuse 0.3, 0.6 } }"},
    "spotlight": "light_source { <-3, 6, -4> rgb 1 spotlight point_at 0 radius 15 falloff 25 area_light 2*x, 2*z, 5, 5 adaptive 1 }",
    "cylinder": "light_source { <-1, 5, -2> rgb 1 cylinder point_at <0, 0, 0> radius 1.6 falloff 2.6 area_light 1.5*x, 1.5*z, 4, 4 }",
    "parallel": "light_source { <-3, 6, -4> rgb 1 parallel point_at 0 area_light 2*x, 2*z, 4, 4 }",
    "shadowless": "light_source { <-3, 6, -4> rgb 1 shadowless area_light 4*x, 4*z, 4, 4 area_illumination }",
    "projected_through": "light_source { <-3, 6, -4> rgb 1 area_light 2*x, 2*z, 4, 4 projected_through { disc { <-1.5, 3, -2>, <1.5, 3, 2>, 0.9, 0.2 } } }",
    "scaled": "light_source { 0 rgb 1 area_light x, z, 5, 5 scale 3 rotate 30*z translate <-3, 6, -4> }",
    "jitter": AREA % "3*x, 3*y, 4, 4 jitter",
    "jitter_adaptive": AREA % "3*x, 3*y, 9, 9 jitter adaptive 1",
    "jitter_circular": AREA % "3*x, 3*y, 6, 6 circular orient jitter",
    "jitter_illumination": AREA % "3*x, 3*y, 3, 3 jitter area_illumination",
    "jitter_one_row": AREA % "4*x, y, 6, 1 jitter",
    "jitter_spotlight": "light_source { <-3, 6, -4> rgb 1 spotlight point_at 0 radius 15 falloff 25 area_light 2*x, 2*z, 4, 4 jitter }",
}

FINISHES = {
    "default": "",
    "ambient": "ambient 0.4",
    "ambient_colour": "ambient rgb <0.4, 0.1, 0.3>",
    "emission": "emission rgb <0.1, 0.3, 0.2>",
    "ambient_and_emission": {"it": "ambient 0.3 emission 0.2", "settings": "ambient_light rgb <0.5, 1, 2>"},
    "diffuse": "diffuse 0.9",
    "diffuse_albedo": "diffuse albedo 0.7 brilliance 3",
    "diffuse_back": {"it": "diffuse 0.5, 0.4", "objects": "disc { <0, 1.4, 0.8>, <0.4, 0.3, 1>, 0.8 texture { Coat } }"},
    "brilliance": "brilliance 3",
    "brilliance_low": "brilliance 0.4",
    "phong": "phong 0.8",
    "phong_size": "phong 0.9 phong_size 120",
    "phong_small": "phong 0.9 phong_size 5",
    "phong_albedo": "phong albedo 0.2 phong_size 30",
    "specular": "specular 0.7",
    "roughness": "specular 0.7 roughness 0.005",
    "roughness_wide": "specular 0.7 roughness 0.4",
    "specular_albedo": "specular albedo 0.3 roughness 0.03",
    "phong_and_specular": "phong 0.4 phong_size 10 specular 0.6 roughness 0.01",
    "metallic": "specular 0.8 roughness 0.03 metallic",
    "metallic_half": "phong 0.8 phong_size 20 metallic 0.5",
    "reflection": "reflection 0.4",
    "reflection_colour": "reflection rgb <0.6, 0.3, 0.1>",
    "reflection_range": "reflection { 0.05, 0.8 }",
    "reflection_falloff": "reflection { 0.05, 0.8 falloff 4 }",
    "reflection_exponent": "reflection { 0.6 exponent 0.6 }",
    "reflection_exponent_old": "reflection 0.6 reflection_exponent 1.8",
    "reflection_metallic": "reflection { 0.3, 0.8 metallic }",
    "reflection_metallic_part": "reflection { 0.6 metallic 0.4 }",
    "reflection_fresnel": {"it": "reflection { 0, 1 fresnel on } conserve_energy", "objects": "sphere { <0, 0.45, -1.7>, 0.45 texture { Coat } interior { ior 1.6 } }"},
    "reflection_many": {"it": "reflection 0.85 diffuse 0.1", "settings": "max_trace_level 12"},
    "reflection_adc": {"it": "reflection 0.5", "settings": "max_trace_level 12 adc_bailout 0.2"},
    "conserve_energy": {"it": "reflection { 0.2, 0.9 } conserve_energy", "objects": "sphere { <0, 0.5, -1.6>, 0.5 pigment { rgbt <1, 0.9, 0.8, 0.7> } finish { reflection { 0.2, 0.9 } conserve_energy } }"},
    "no_conserve_energy": {"it": "reflection { 0.2, 0.9 }", "objects": "sphere { <0, 0.5, -1.6>, 0.5 pigment { rgbt <1, 0.9, 0.8, 0.7> } finish { reflection { 0.2, 0.9 } } }"},
    "irid": "irid { 0.6 thickness 0.4 } phong 0.3",
    "irid_turbulence": "irid { 0.6 thickness 0.4 turbulence 0.6 }",
    "irid_reflection": "irid { 0.5 thickness 0.7 } reflection 0.5",
    "irid_wavelength": {"it": "irid { 0.6 thickness 0.4 }", "settings": "irid_wavelength rgb <0.25, 0.18, 0.14>"},
    "crand": "crand 0.3",
    "identifier": {"it": "Shiny diffuse 0.3", "settings": "} #declare Shiny = finish { specular 0.6 reflection 0.2 ambient 0.2"},
    "default_finish": {"it": "phong 0.5", "settings": "} #default { finish { ambient 0.35 diffuse 0.3 }"},
    "double_illuminate": {"it": "", "objects": "disc { <0, 1.4, 0.8>, <0.4, 0.3, 1>, 0.8 texture { Coat } double_illuminate }"},
    "layered": {"it": "specular 0.4", "objects": "sphere { <0, 0.5, -1.6>, 0.5 texture { pigment { rgb <0.7, 0.2, 0.1> } finish { reflection 0.2 } } texture { pigment { checker rgbt <1, 1, 1, 0.9>, rgbf <0.2, 0.9, 0.3, 0.6> scale 0.3 } finish { phong 0.6 reflection 0.1 } } }"},
    "texture_map": {"it": "", "objects": "sphere { <0, 0.5, -1.6>, 0.5 texture { gradient y texture_map { [0.2 pigment { rgb 0.9 } finish { reflection 0.5 }] [0.8 pigment { rgbt <1, 0.5, 0.2, 0.7> } finish { specular 1 }] } } }"},
    "normal_and_reflection": {"it": "reflection 0.6", "objects": "sphere { <0, 0.6, -1.6>, 0.6 pigment { rgb 0.3 } normal { bumps 0.7 scale 0.15 } finish { reflection 0.7 specular 0.5 } }"},
    "interior_texture": {"it": "", "objects": "sphere { <0, 0.6, -1.5>, 0.6 clipped_by { plane { y, 0.6 } } texture { Coat } interior_texture { pigment { rgb <0.2, 0.8, 0.9> } finish { reflection 0.3 } } }"},
}

INTERIORS = {
    "none": "",
    "ior_1": "ior 1.0",
    "ior_1_5": "ior 1.5",
    "ior_2_4": {"it": "ior 2.4", "settings": "max_trace_level 10"},
    "ior_below_1": "ior 0.8",
    "fade_power_1": "ior 1.5 fade_distance 0.8 fade_power 1",
    "fade_power_2": "ior 1.3 fade_distance 0.6 fade_power 2 fade_color rgb <0.9, 0.5, 0.3>",
    "fade_power_exponential": "ior 1.5 fade_distance 1.2 fade_power 1001 fade_color rgb <0.3, 0.8, 0.6>",
    "fade_distance_only": "ior 1.2 fade_distance 1",
    "fade_straight": "fade_distance 1 fade_power 1001 fade_colour rgb <0.8, 0.3, 0.6>",
    "caustics": "ior 1.5 caustics 1",
    "caustics_strong": "ior 1.3 caustics 3 fade_distance 1 fade_power 1",
    "dispersion": "ior 1.5 dispersion 1.1",
    "dispersion_samples": "ior 1.5 dispersion 1.15 dispersion_samples 15",
    "dispersion_few": "ior 1.6 dispersion 0.9 dispersion_samples 2",
    "dispersion_without_ior": "dispersion 1.1",
    "dispersion_deep": {"it": "ior 1.7 dispersion 1.05 dispersion_samples 5", "settings": "max_trace_level 10"},
    "identifier": {"it": "Water fade_distance 1 fade_power 2", "settings": "} #declare Water = interior { ior 1.33 fade_color rgb <0.6, 0.8, 1>"},
    "nested": {"it": "ior 1.5", "objects": "sphere { <-1.2, 1, 0>, 0.5 texture { Glass } interior { ior 1.1 } }"},
    "bubble_in_union": {"it": "ior 1.5", "objects": "union { sphere { <0, 0.5, -1.4>, 0.5 } sphere { <0.4, 0.5, -1.4>, 0.5 } texture { Glass } interior { ior 1.4 } }"},
    "overlap": {"it": "ior 1.5", "objects": "sphere { <-0.6, 0.7, -0.9>, 0.7 texture { Glass } interior { ior 1.2 } }"},
    "merge": {"it": "ior 1.5", "objects": "merge { sphere { <0, 0.5, -1.4>, 0.5 } box { <0.1, 0.1, -1.8>, <0.9, 0.7, -1> } texture { Glass } interior { ior 1.4 fade_distance 0.5 fade_power 1 } }"},
    "material": {"it": "ior 1.5", "objects": "sphere { <0, 0.5, -1.6>, 0.5 material { texture { pigment { rgbf <1, 0.8, 0.8, 0.95> } finish { specular 0.5 } } interior { ior 1.7 } } }"},
    "open_surface": {"it": "ior 1.5", "objects": "disc { <0, 0.8, -1.5>, <0.3, 0.2, -1>, 0.7 pigment { rgbt 0.9 } finish { reflection 0.1 } interior { ior 1.3 } }"},
    "finish_ior": {"it": "ior 1.2 dispersion 1.2", "objects": "sphere { <0, 0.5, -1.6>, 0.5 pigment { rgbt 0.9 } finish { ior 1.6 specular 0.4 } }"},
    "finish_refraction": {"it": "ior 1.5", "objects": "sphere { <0, 0.5, -1.6>, 0.5 pigment { rgbt 0.9 } finish { refraction 0.6 ior 1.3 } }"},
    "bumpy": {"it": "ior 1.5", "objects": "box { <-0.6, 0.1, -1.6>, <0.6, 1.2, -1.4> texture { Glass normal { ripples 0.6 frequency 3 scale 0.4 } } interior { ior 1.3 } }"},
    "transmit_and_filter": {"it": "ior 1.5", "objects": "box { <-0.6, 0.1, -1.6>, <0, 1.2, -1.4> pigment { rgbf <1, 0.3, 0.2, 0.8> } } box { <0, 0.1, -1.6>, <0.6, 1.2, -1.4> pigment { rgbt <1, 0.3, 0.2, 0.8> } }"},
    "max_trace_level_2": {"it": "ior 1.5", "settings": "max_trace_level 2"},
    "adc_bailout_high": {"it": "ior 1.5", "settings": "adc_bailout 0.4"},
    "version_3_6": {"it": "ior 1.5 fade_distance 1 fade_power 1", "version": "3.6"},
}

SHADOWS = {
    "no_shadow": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.5 pigment { rgb <1, 0.2, 0.2> } no_shadow }"},
    "no_image": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.5 pigment { rgb <1, 0.2, 0.2> } no_image } plane { -z, -3 pigment { rgb 0.2 } finish { reflection 0.6 } }"},
    "no_reflection": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.5 pigment { rgb <1, 0.2, 0.2> } no_reflection } plane { -z, -3 pigment { rgb 0.2 } finish { reflection 0.6 } }"},
    "filtered": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.6 pigment { rgbf <1, 0.3, 0.2, 0.9> } }"},
    "transmitted": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.6 pigment { rgbt <1, 0.3, 0.2, 0.7> } }"},
    "patterned": {"it": KEY, "objects": "box { <-1.5, 2.4, -2>, <0.5, 2.45, 0> pigment { checker rgb <1, 0.2, 0.1>, rgbf <0.3, 1, 0.5, 0.9> scale 0.25 } }"},
    "texture_map": {"it": KEY, "objects": "box { <-1.5, 2.4, -2>, <0.5, 2.45, 0> texture { gradient x texture_map { [0.3 pigment { rgb <1, 0.2, 0.1> }] [0.7 pigment { rgbf <0.3, 1, 0.5, 0.9> }] } } }"},
    "layered": {"it": KEY, "objects": "box { <-1.5, 2.4, -2>, <0.5, 2.45, 0> texture { pigment { rgbf <1, 0.8, 0.2, 0.9> } } texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgb <0.1, 0.1, 0.6>] } scale 0.3 } } }"},
    "caustics": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.7 pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { diffuse 0.1 } interior { ior 1.5 caustics 0.8 } }"},
    "fading": {"it": KEY, "objects": "sphere { <0.2, 2.2, -1>, 0.7 pigment { rgbt <1, 1, 1, 0.95> } interior { fade_distance 0.6 fade_power 1 fade_color rgb <0.8, 0.3, 0.1> } }"},
    "thin_pane": {"it": KEY, "objects": "box { <-1.5, 2.4, -2>, <0.5, 2.4005, 0> pigment { rgbf <1, 0.5, 0.2, 0.7> } } box { <0.5, 2.4, -2>, <2, 2.45, 0> pigment { rgbf <1, 0.5, 0.2, 0.7> } }"},
    "through_many": {"it": KEY, "objects": "#declare I = 0; #while (I < 8) disc { <-0.3, 2 + 0.2*I, -1>, y, 0.9 - 0.1*I pigment { rgbt <1, 1, 1, 0.85> } } #declare I = I + 1; #end"},
    "csg": {"it": KEY, "objects": "difference { box { <-1.2, 2, -1.8>, <0.4, 2.6, -0.4> } cylinder { <-0.4, 1, -1.1>, <-0.4, 3, -1.1>, 0.45 } pigment { rgb 0.7 } }"},
    "clipped": {"it": KEY, "objects": "sphere { <-0.2, 2.3, -1>, 0.8 clipped_by { box { <-1, 2.2, -2>, <1, 2.9, 0> } } pigment { rgb <0.8, 0.7, 0.2> } }"},
    "bounded": {"it": KEY, "objects": "sphere { <-0.2, 2.3, -1>, 0.6 bounded_by { box { <-1, 1.6, -2>, <1, 3, 0> } } pigment { rgb <0.8, 0.7, 0.2> } }"},
    "inverse": {"it": KEY, "objects": "sphere { 0, 30 inverse pigment { gradient y color_map { [0 rgb <0.2, 0.3, 0.5>] [1 rgb 0.8] } scale 20 } }"},
    "union_flags": {"it": KEY, "objects": "union { sphere { <-0.5, 2.2, -1>, 0.4 no_shadow } sphere { <0.7, 2.2, -1>, 0.4 } pigment { rgb <1, 0.4, 0.2> } }"},
    "merge_flags": {"it": KEY, "objects": "merge { sphere { <-0.5, 2.2, -1>, 0.4 no_shadow } sphere { <0.1, 2.2, -1>, 0.4 } pigment { rgb <1, 0.4, 0.2> } }"},
    "self_shadow": {"it": "light_source { <8, 2.5, -2> rgb 1 }", "objects": "blob { threshold 0.5 sphere { <0, 1.8, 0>, 0.9, 1 } sphere { <0.8, 2, -0.5>, 0.7, 1 } pigment { rgb 0.8 } }"},
}

GROUP_LIGHTS = {
    "own_light": KEY + " light_group { light_source { <4, 5, -4> rgb <0.2, 0.3, 1> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } }",
    "global_lights": KEY + " light_group { light_source { <4, 5, -4> rgb <0.2, 0.3, 1> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } global_lights on }",
    "without_lights": KEY + " light_group { sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } }",
    "area_light": KEY + " light_group { light_source { <4, 5, -4> rgb 1 area_light 2*x, 2*y, 5, 5 adaptive 1 } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } box { <0.8, 1.8, -1>, <1, 2.4, -0.2> pigment { rgb 0.7 } } }",
    "nested": "light_group { light_group { light_source { <4, 5, -4> rgb <0.2, 0.3, 1> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } } light_source { <-4, 5, -4> rgb <0.8, 0.3, 0.2> } box { <0.8, 1.8, -1>, <1.4, 2.4, -0.2> pigment { rgb 0.7 } } } light_source { <0, 8, -2> rgb 0.4 }",
    "nested_declared": "#declare G = light_group { light_source { <4, 5, -4> rgb <0.2, 0.3, 1> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } } light_group { light_source { <-4, 5, -4> rgb <0.8, 0.3, 0.2> } light_group { G } } light_source { <0, 8, -2> rgb 0.4 }",
    "moved": KEY + " light_group { light_source { <4, 3, -3> rgb 1 spotlight point_at 0 radius 8 falloff 14 } sphere { 0, 0.5 pigment { rgb 0.9 } } translate <0, 2.1, -0.6> global_lights on }",
    "in_union": KEY + " union { light_group { light_source { <4, 5, -4> rgb <0.2, 0.9, 0.3> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } } box { <0.8, 1.8, -1>, <1.4, 2.4, -0.2> pigment { rgb 0.7 } } rotate 5*y }",
    "light_in_union_is_global": KEY + " light_group { union { light_source { <4, 5, -4> rgb <0.5, 0.2, 0.2> } sphere { <0, 2.1, -0.6>, 0.5 pigment { rgb 0.9 } } } }",
    "shared_interior": KEY + " light_group { light_source { <4, 5, -4> rgb 0.8 } sphere { <-0.2, 2, -1>, 0.5 pigment { rgbt 0.9 } } sphere { <0.3, 2, -1>, 0.5 pigment { rgbt 0.9 } } global_lights on }",
}

SKY = "sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.2, 0.4, 0.9>] } } }"
ATMOSPHERES = {
    "background": "background { rgb <0.4, 0.6, 0.8> }",
    "background_transmit": "background { rgbt <0.4, 0.6, 0.8, 0.5> }",
    "background_filter": "background { rgbf <0.4, 0.6, 0.8, 0.5> }",
    "background_old": {"it": "background { rgbt <0.4, 0.6, 0.8, 0.5> }", "version": "3.6"},
    "sky_sphere": SKY,
    "sky_sphere_two_layers": "sky_sphere { pigment { gradient y color_map { [0 rgb 0.9] [1 rgb <0.1, 0.3, 0.9>] } } pigment { bozo turbulence 0.6 color_map { [0.4 rgbt 1] [0.7 rgbt <1, 1, 1, 0.1>] } scale <0.4, 0.15, 0.4> } }",
    "sky_sphere_two_layers_old": {"it": "sky_sphere { pigment { gradient y color_map { [0 rgb 0.9] [1 rgb <0.1, 0.3, 0.9>] } } pigment { bozo turbulence 0.6 color_map { [0.4 rgbt 1] [0.7 rgbt <1, 1, 1, 0.1>] } scale <0.4, 0.15, 0.4> } }", "version": "3.6"},
    "sky_sphere_emission": "sky_sphere { pigment { gradient y color_map { [0 rgb <0.8, 0.85, 0.9>] [0.6 rgb <0.2, 0.4, 0.9>] } } emission rgb <0.5, 0.8, 1.3> }",
    "sky_sphere_over_background": "background { rgb <0.9, 0.5, 0.2> } sky_sphere { pigment { gradient y color_map { [0 rgbt <0, 0, 0, 1>] [0.7 rgbf <0.2, 0.4, 0.9, 0.3>] } } }",
    "sky_sphere_moved": "sky_sphere { pigment { radial frequency 12 color_map { [0 rgb <0.8, 0.85, 0.9>] [1 rgb <0.2, 0.4, 0.9>] } } rotate <70, 20, 0> scale <1, 2, 1> translate 0.3*x }",
    "fog": SKY + " fog { distance 15 rgb <0.7, 0.75, 0.8> }",
    "fog_filter": SKY + " fog { distance 15 rgbf <0.7, 0.6, 0.4, 0.6> }",
    "fog_transmit": SKY + " fog { distance 8 rgbt <0.7, 0.75, 0.8, 0.4> }",
    "fog_type_1": SKY + " fog { fog_type 1 distance 10 rgbft <0.5, 0.7, 0.8, 0.3, 0.2> }",
    "fog_ground": SKY + " fog { fog_type 2 distance 6 rgb <0.8, 0.8, 0.85> fog_offset 0.3 fog_alt 0.4 }",
    "fog_ground_up": SKY + " fog { fog_type 2 distance 6 rgb <0.8, 0.8, 0.85> fog_offset 0.3 fog_alt 0.4 up <0.3, 1, 0.1> }",
    "fog_ground_rotated": SKY + " fog { fog_type 2 distance 6 rgb <0.8, 0.8, 0.85> fog_offset 0.5 fog_alt 0.6 rotate 25*z }",
    "fog_ground_negative_offset": SKY + " fog { fog_type 2 distance 4 rgbt <0.8, 0.8, 0.85, 0.1> fog_offset -0.4 fog_alt 1.2 }",
    "fog_turbulence": SKY + " fog { distance 12 rgb <0.7, 0.75, 0.8> turbulence 0.6 turb_depth 0.8 }",
    "fog_turbulence_options": SKY + " fog { fog_type 2 distance 5 rgb <0.8, 0.8, 0.85> fog_offset 0.6 fog_alt 0.8 turbulence <1, 0.3, 0.6> turb_depth 0.6 octaves 3 omega 0.7 lambda 1.6 }",
    "fog_two": SKY + " fog { distance 20 rgb <0.7, 0.4, 0.3> } fog { fog_type 2 distance 5 rgb <0.5, 0.7, 0.9> fog_offset 0.2 fog_alt 0.5 }",
    "fog_declared": "#declare Mist = fog { distance 15 rgb <0.7, 0.75, 0.8> } " + SKY + " fog { Mist fog_type 2 fog_alt 0.5 }",
    "fog_media_attenuation": "fog { distance 25 rgb <0.7, 0.75, 0.8> } light_source { <3, 6, -4> rgb 1 media_attenuation on }",
    "fog_media_interaction_off": "fog { distance 25 rgb <0.7, 0.75, 0.8> } light_source { <3, 6, -4> rgb 1 media_attenuation on media_interaction off }",
    "fog_not_hollow": {"it": SKY + " fog { distance 10 rgb <0.7, 0.75, 0.8> }", "objects": "box { <-1.6, 0.1, -3>, <0.2, 1.9, 4> pigment { rgbt 0.95 } }"},
    "fog_hollow": {"it": SKY + " fog { distance 10 rgb <0.7, 0.75, 0.8> }", "objects": "box { <-1.6, 0.1, -3>, <0.2, 1.9, 4> pigment { rgbt 0.95 } hollow }"},
    "camera_inside_solid": {"it": SKY + " fog { distance 10 rgb <0.7, 0.75, 0.8> }", "objects": "sphere { <0, 1.6, -6>, 4 pigment { rgbt 0.95 } }"},
    "rainbow": SKY + " rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [0.5 rgbt <0.1, 0.9, 0.2, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }",
    "rainbow_arc": SKY + " rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> arc_angle 120 falloff_angle 60 color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [0.5 rgbt <0.1, 0.9, 0.2, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }",
    "rainbow_up": SKY + " rainbow { angle 25 width 6 distance 30 direction <0, -0.25, 1> up <1, 1, 0> arc_angle 180 falloff_angle 90 color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }",
    "rainbow_filter": SKY + " rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> color_map { [0 rgbft <0.6, 0.1, 0.9, 0.5, 0.2>] [1 rgbf <1, 0.2, 0.1, 0.7>] } }",
    "rainbow_distance": SKY + " rainbow { angle 30 width 8 distance 5 direction <0, -0.25, 1> color_map { [0 rgbt <0.6, 0.1, 0.9, 0.3>] [1 rgbt <1, 0.2, 0.1, 0.3>] } }",
    "rainbow_two": SKY + " rainbow { angle 25 width 5 distance 30 direction <0, -0.25, 1> color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } } rainbow { angle 33 width 6 distance 50 direction <0, -0.25, 1> color_map { [0 rgbt <1, 0.2, 0.1, 0.7>] [1 rgbt <0.6, 0.1, 0.9, 0.7>] } }",
    "rainbow_jitter": SKY + " rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> jitter 0.2 color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [0.5 rgbt <0.1, 0.9, 0.2, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }",
    "rainbow_and_fog": SKY + " fog { distance 30 rgb 0.7 } rainbow { angle 30 width 8 distance 30 direction <0, -0.25, 1> color_map { [0 rgbt <0.6, 0.1, 0.9, 0.6>] [1 rgbt <1, 0.2, 0.1, 0.6>] } }",
}

GROUPS = {
    "lights": (LIGHTS, LIGHT_KINDS), "area": (LIGHTS, AREA_LIGHTS), "finish": (FINISH, FINISHES), "interior": (INTERIOR, INTERIORS),
    "shadows": (LIGHTS, SHADOWS), "groups": (LIGHTS, GROUP_LIGHTS), "atmosphere": (ATMOSPHERE, ATMOSPHERES),
}
