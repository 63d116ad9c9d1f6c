#version 3.1;
// Moray 3.x export with include files and UDOs
global_settings { adc_bailout 0.003922 ambient_light <1.0,1.0,1.0> assumed_gamma 1.9 hf_gray_16 off irid_wavelength <0.247059,0.176471,0.137255> max_intersections 64 max_trace_level 10 number_of_waves 10 radiosity { brightness 3.3 count 100 error_bound 0.4 gray_threshold 0.5 low_error_factor 0.8 minimum_reuse 0.015 nearest_count 6 recursion_limit 1 } }
background { color <0.000,0.000,0.000> }
camera {  //  Camera StdCam
  location  <      4.978,     -12.054,       5.005>
  sky       <    0.00000,    0.00000,    1.00000> // Use right handed-system
  up        <        0.0,        0.0,        1.0> // Where Z is up
  right     <    1.35836,        0.0,        0.0> // Aspect ratio
  angle         40.00000    // Vertical      30.000
  look_at   <      0.000,       0.000,       0.000>
}
#declare Grey_Sphere = material { texture { pigment { color rgb <0.5,0.5,0.5> } finish { ambient 0.2 } } }
light_source { <0.0, 0.0, 0.0> color rgb <1.000, 1.000, 1.000> fade_distance 10.0 fade_power 1.0 translate <4.0, -4.0, 8.0> }
#declare Group001 = union {
  sphere { <0,0,0>,1 material { Grey_Sphere } scale <1.2, 1.0, 0.8> rotate <0.0, -15.0, 0.0> translate <-1.0, 0.0, 0.5> }
  box { <-1, -1, -1>, <1, 1, 1> material { texture { pigment { bozo color_map { [ 0.0 rgbft <1.0, 0.4, 0.1, 0.0, 0.0> ] [ 1.0 rgbft <0.3, 0.4, 0.9, 0.0, 0.0> ] } turbulence 0.3 scale 0.4 } } } scale <0.6, 0.6, 0.6> translate x*1.2 }
  #declare Bez001 = prism { bezier_spline linear_sweep -0.2, 0.2, 16
   <0.0,1.0>, <0.55,1.0>, <1.0,0.55>, <1.0,0.0>, <1.0,0.0>, <1.0,-0.55>, <0.55,-1.0>, <0.0,-1.0>, <0.0,-1.0>, <-0.55,-1.0>, <-1.0,-0.55>, <-1.0,0.0>, <-1.0,0.0>, <-1.0,0.55>, <-0.55,1.0>, <0.0,1.0>
   rotate -90*x scale <0.7,0.7,1> translate -z }
  object { Bez001 material { Grey_Sphere } }
  bounded_by { sphere { 0, 4 } }
}
object { Group001 }
plane { z,0 hollow on texture { pigment { checker color rgb <1.0,1.0,1.0> color rgb <0.3,0.3,0.3> } } translate -1.2*z }
