// In the manner of Moray for Windows: persistence of vision 3.0, no semicolons, names with the program's prefix.
#version 3.0
global_settings {
  adc_bailout 0.003922
  ambient_light rgb <1.0,1.0,1.0>
  assumed_gamma 1.9
  hf_gray_16 off
  irid_wavelength rgb <0.247059,0.176471,0.137255>
  max_intersections 64
  max_trace_level 10
  number_of_waves 10
}
background { color rgb <0.000,0.000,0.200> }
camera {  //  Camera Camera01
  location  <  5.500,  -7.500,  3.000>
  direction <  0.0,     0.0,  1.8317>
  sky       <  0.0,     0.0,  1.0>
  up        <  0.0,     0.0,  1.0>
  right     <  1.3333,  0.0,  0.0>
  look_at   <  0.000,   0.000,  0.500>
}
light_source {   // Light1
  <5.0, -12.5, 12.5>
  color rgb <1.000, 1.000, 1.000>
}
light_source {
  <0.0, 0.0, 0.0>
  color rgb <0.6, 0.5, 0.4>
  spotlight
  point_at <0.0, 0.0, -1.0>
  tightness 10.0
  radius 15.0
  falloff 25.0
  translate <0.0, 0.0, 8.0>
}
#declare Plain_Red =
   texture
   {
      pigment
      {
         color red 1.0
      }
      finish
      {
         ambient 0.15
         diffuse 0.7
         phong 0.8
         phong_size 60.0
      }
   }
#declare Checked =
  texture { pigment { checker color rgb <0.9,0.9,0.9>, color rgb <0.2,0.3,0.4> } finish { ambient 0.2 } scale <0.5,0.5,0.5> }
#declare Knob = sphere { // Sph001
  <0,0,0>,1
  texture {
    Plain_Red
  }
  scale 0.6
}
union { // CSG001
  object { Knob translate <-1.0, 0.0, 0.6> }
  object { Knob
    rotate    <30.0, 0.0, 0.0>
    scale     <1.0, 0.7, 1.4>
    translate <0.7, 0.0, 0.9>
  }
  merge { // Merge001
    cylinder { <0,0,1>, <0,0,0>, 1 scale <0.3,0.3,1.5> }
    cone { <0,0,0>, 0.0, <0,0,1>, 0.5 translate 1.2*z }
    texture { Checked }
  }
  bounded_by { box { <-2.5,-2.5,-0.5>, <2.5,2.5,3.5> } }
}
plane { z,0 texture { Checked } }
#declare Bez = bicubic_patch {
  type 1 flatness 0.0100 u_steps 3 v_steps 3,
  <-1.5, 1.5, 0>, <-.5, 1.5, .3>, <.5, 1.5, .3>, <1.5, 1.5, 0>,
  <-1.5, .5, .2>, <-.5, .5, 1.3>, <.5, .5, 1.1>, <1.5, .5, .2>,
  <-1.5, -.5, .2>, <-.5, -.5, .9>, <.5, -.5, 1.2>, <1.5, -.5, .2>,
  <-1.5, -1.5, 0>, <-.5, -1.5, .2>, <.5, -1.5, .2>, <1.5, -1.5, 0>
}
object { Bez texture { Plain_Red } translate <-2.5, 2.5, 0> }
