#version 3.6;
#declare Hole = cylinder { -2*z, 2*z, .3 }
#declare Plate = difference { box { <-2,-1,-.2>, <2,1,.2> } #declare i = -1; #while (i <= 1) object { Hole translate i*1.2*x } #declare i = i+1; #end texture { pigment { rgb <.7,.7,.8> } finish { metallic phong .6 reflection .15 } } }
#declare Half = intersection { object { Plate } plane { x, .2 } }
#declare Joined = merge { object { Half } object { Half rotate 180*z translate .1*z } }
object { Joined rotate <20,30,0> }
intersection { sphere { 0,1 texture { pigment { rgb x } } } box { -.8,.8 } plane { <1,1,-1>, .4 texture { pigment { rgb y } } } cutaway_textures texture { pigment { rgb z } } translate <0,-1.8,-1> scale .7 }
difference { sphere { <2.2,-1.2,0>, .7 } sphere { <2.2,-1.2,-.5>, .5 inverse inverse } pigment { rgb <.9,.5,.9> } clipped_by { plane { y, -1 } } }
camera { location <0,.5,-7> look_at <0,-.3,0> } light_source { <3,6,-8> 1 }
