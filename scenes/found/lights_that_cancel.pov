// Light of 3,000,000 and of -3,000,000 from almost the same place: what the floor shines itself comes before it, so that
// the last bit of each sum shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 8, 0> look_at 0 angle 30 }
#declare Bright = 3000000;
light_source { <-10, 10, -10> rgb Bright }
light_source { <-10, 10, -10> rgb -Bright }
light_source { <4, 6, 5> rgb Bright area_light 3*x, 3*z, 2, 2 area_illumination }
light_source { <4, 6, 5> rgb -Bright area_light 3*x, 3*z, 2, 2 area_illumination }
#default { pigment { rgb <0.3, 0.4, 0.7> } finish { ambient 0.7 diffuse 0.6 } }
plane { y, -3 }
sphere { <1, -2, 0>, 1 finish { specular 0.3 } }
light_group {
  light_source { <1, 4, 3> rgb Bright }
  light_source { <1, 4, 3> rgb -Bright }
  sphere { <-1, -2, 0.5>, 0.8 }
  global_lights on
}
