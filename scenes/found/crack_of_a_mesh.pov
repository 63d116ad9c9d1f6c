// A round mesh seen along its axis by rays that leave the plane x = 0 by 1e-8 a unit, in a picture that is 4e-7 wide:
// faces of POV-Ray's boxes are off by what binary32 rounds away, so some of these rays fall through between triangles
// that meet there, and show the other wall or the sky (spec 08 C).
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = 16;
#declare Rings = 40;
#declare Around = function(i) { 2 * pi * i / N }
#declare Wide = function(j) { 0.7 + 0.31 * sin(0.69 * j) }
#declare High = function(j) { 0.055 * j - 1.1 }
#macro Ring(I, J) <Wide(J) * sin(Around(I)), High(J), Wide(J) * cos(Around(I))> #end
mesh {
  #for (J, 0, Rings - 1)
    #for (I, 0, N - 1)
      triangle { Ring(I, J), Ring(I + 1, J), Ring(I + 1, J + 1) }
      triangle { Ring(I, J), Ring(I + 1, J + 1), Ring(I, J + 1) }
    #end
  #end
  pigment { gradient z color_map { [0 rgb <1, 0.2, 0.1>] [1 rgb <0.1, 0.3, 1>] } scale 2 translate -z }
  finish { ambient 1 diffuse 0 }
}
background { rgb <1, 1, 0> }
camera { orthographic location <0, 0, -4> right 4e-7 * x up 2.2 * y direction <1e-8, 0, 1> }
