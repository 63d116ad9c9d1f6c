// Level with the end of a Bezier outline, points between it and its farthest control point count as inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 5, -0.2> direction -y up 2.4*z right 3.2*x }
light_source { <2, 8, -3>, rgb 1 }
#declare P = prism { bezier_spline 0, 0.5, 8 <0.1, -1>, <1.2, -0.9>, <0.9, 0.8>, <0, 1>, <0, 1>, <-0.7, 0.6>, <-1.1, -0.7>, <0.1, -1> }
object { P pigment { rgb <0.8, 0.4, 0.2> } }
#declare X = -1.3;
#while (X < 1.3)
  #declare Z = -1.25;
  #while (Z < 1.3)
    sphere { <X, 0.6, Z>, 0.02 pigment { rgb inside(P, <X, 0.2, Z>) } finish { ambient 1 diffuse 0 } }
    #declare Z = Z + 0.25;
  #end
  #declare X = X + 0.05;
#end
