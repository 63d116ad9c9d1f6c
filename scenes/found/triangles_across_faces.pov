// A face in an edge of the triangular pattern's rows: mirror rays hit it hardly above or below 0, and hardly below is
// the last row, turned over (spec 05 2.2).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-1, 2, -8> direction 1.5*z look_at <-0.3, 0.6, 0> angle 25 }
#default { finish { ambient 1 diffuse 0 } }
cone { 0, 0.2, 2*y, 1.4 pigment { rgb 0 } finish { reflection 1 } }
#declare I = 0;
#while (I < 7)
  box {
    0, <0.5, 0.5 + I/7, 0.5>
    translate (I*0.5 - 2)*x
    pigment { triangular rgb x rgb y rgb z rgb x + y rgb y + z rgb x + z }
  }
  #declare I = I + 1;
#end
