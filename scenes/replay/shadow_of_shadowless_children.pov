// What casts no shadow by itself, but does in CSG that is not dissolved, is not remembered as what blocked the light last
// (spec 08 D), though the CSG around it has an opaque texture of its own: it filters the light once, the others twice.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at 0 angle 50 }
light_source { <-10, 20, -30>, rgb 1 }
#declare Glass = pigment { brick rgb <0.9, 0.6, 0.4>, rgbft <0.1, 1, 0.5, 0.2, 0.6> brick_size <0.9, 0.5, 0.9> mortar 0.1 }
#macro Hat(Flag)
  lathe {
    cubic_spline 5 <1, -1>, <0.5, -0.5>, <1, 0>, <0.5, 1>, <0, 1.5>
    pigment { Glass }
    #if (Flag) no_shadow #end
  }
#end
difference { Hat(yes) pigment { rgb 1 } translate <-2.5, 1, 0> }
difference { Hat(no) pigment { rgb 1 } translate <2.5, 1, 0> }
merge { difference { Hat(yes) } box { <-1, -1, -1>, <-0.5, 1, 0.3> pigment { Glass } } pigment { rgb 1 } translate <0, 1, 1> }
plane { y, -0.5 pigment { rgb <1, 0.9, 0.8> } }
