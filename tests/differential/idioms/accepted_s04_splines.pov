#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Path = spline { cubic_spline -0.25, <-3,0,1> 0, <-2.5,0,0> .25 <-1,1,1>, .5, <0,-.5,0> .75, <1.2,.8,-1> 1, <2.5,0,0> 1.25, <3,0,1> }
#declare P2 = spline { natural_spline 0,<0,0>,1,<1,2>,2,<3,-1> }
#declare Cols = spline { linear_spline 0, <1,0,0> .5, <0,1,0> 1, <0,0,1> }
#for (T, 0, 1, 0.02)
  sphere { Path(T), .18 pigment { rgb Cols(T) } }
#end
#declare V = P2(1.5);
#debug concat(vstr(2, V, " / ", 0, 6), " ", vstr(3, Path(.6, linear_spline), ",", 0, 6), " ", str(Path(.3).y, 0, 6), "\n")
sphere_sweep { b_spline 6, <-3,-1.5,0>,.1 <-2,-1,0>,.2 <-1,-1.8,0>,.3 <0,-1,0>,.2 <1,-1.6,0>,.15 <2,-1,0>,.1 pigment { rgb 1 } }
camera { location <0,1,-6> look_at 0 }
light_source { <3,5,-8> 1 }
