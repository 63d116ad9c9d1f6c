#version 3.5;
#include "colors.inc"
#include "functions.inc"
global_settings { assumed_gamma 2.2 noise_generator 2 }
#declare Land = height_field {
  function 60,60 { min(1, max(0, f_ridged_mf(x*3,0,y*3, 0.8, 2.2, 5, 0.95, 1.8, 1)*0.4)) }
  smooth translate -0.5*(x+z) scale <20,3,20>
}
object { Land
 texture { pigment { slope { y 0.2,0.7 altitude y, 0, 3 } color_map { [0.0 color DarkGreen][0.4 rgb <0.4,0.35,0.25>][0.7 Gray60][1 White] } } }
}
plane { y, 0.35 texture { pigment { rgbt <0.1,0.25,0.3,0.4> } normal { ripples 0.2 frequency 8 turbulence 0.4 } finish { reflection { 0.1, 0.6 fresnel on } conserve_energy specular 0.6 } } interior { ior 1.33 fade_distance 1.5 fade_power 1001 fade_color <0.1,0.3,0.3> } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8,0.85,1>] [0.5 rgb <0.25,0.4,0.8>] } }
 pigment { wrinkles turbulence 0.6 octaves 5 omega 0.6 lambda 2.2 color_map { [0 rgbt 1][0.5 rgbt 1][1 rgbt <1,1,1,0.2>] } scale <0.5,0.1,0.5> } }
fog { fog_type 2 distance 60 color rgbt <0.7,0.75,0.85,0.1> fog_offset 0.3 fog_alt 0.8 turbulence 0.2 turb_depth 0.3 }
light_source { <200,80,-100> rgb <1.4,1.2,0.9> parallel point_at 0 }
camera { location <0,4,-12> look_at <0,1,0> angle 60 }
