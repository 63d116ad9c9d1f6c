// A ball of glass and a mirror: rays that are reflected and refracted, until nothing more can be seen of them.
#version 3.7;
#declare Levels = 8;  // @range 1 12 1
#declare Index = 1.5;  // @range 1 2.5
global_settings { assumed_gamma 1 max_trace_level Levels }
camera { location <0, 1.5, -6> look_at <-0.1, 0.85, 0> right 4/3*x angle 42 }
light_source { <5, 8, -5> rgb 1 }

sphere { <-0.9, 1, -0.4>, 1
  pigment { rgbf <0.97, 1, 0.98, 0.95> } finish { ambient 0 diffuse 0 specular 0.6 roughness 0.002 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior Index } }
sphere { <1.25, 0.9, 0.8>, 0.9 pigment { rgb 0.05 } finish { ambient 0 diffuse 0.1 specular 0.8 roughness 0.004 reflection 0.8 } }
box { <-3.2, 0, 2.6>, <3.2, 2.2, 2.8> pigment { brick rgb 0.75, rgb <0.75, 0.3, 0.2> brick_size <0.6, 0.3, 0.6> mortar 0.04 } finish { diffuse 0.7 } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.45> scale 0.7 } finish { diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.93, 0.97>] [1 rgb <0.3, 0.45, 0.75>] } } }
