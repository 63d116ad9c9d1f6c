// Glass that fades what is in it, with a surface that shows photons: a packet fades on its way before it is stored
// where it leaves the glass (spec 07 3.6).
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 photons { spacing 0.02 } }
camera { location <0, 3, -6> look_at <0, 0.8, 0> angle 40 }
light_source { <-4, 7, 3> rgb 1.2 photons { refraction on reflection on } }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.75> } }
#declare Glass = material {
  texture { pigment { rgbt <0.9, 1, 0.95, 0.8> } finish { ambient 0 diffuse 0.4 reflection { 0.1, 0.9 fresnel } conserve_energy } }
  interior { ior 1.5 fade_power 1001 fade_distance 0.4 fade_color <0.3, 0.7, 0.5> }
}
sphere { <-1.2, 1, 0>, 1 material { Glass } photons { target refraction on reflection on } }
box { -0.7, 0.7 rotate <0, 30, 0> translate <1.3, 0.7, 0.2> material { Glass } photons { target refraction on reflection on } }
