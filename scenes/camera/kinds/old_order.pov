// kinds: old order
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1, -2.5> look_at <0, 0, 3> right 4/3*x translate 0.2*y angle 60 }
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
