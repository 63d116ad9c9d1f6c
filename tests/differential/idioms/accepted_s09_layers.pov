#version 3.5;
#declare L1 = texture { pigment { rgb <.9,.8,.5> } finish { phong .3 } }
#declare L2 = texture { pigment { wrinkles color_map { [0 rgbt <.4,.2,.1,.2>] [.5 rgbt <.5,.3,.1,.9>] [1 rgbt 1] } scale .4 } }
#declare Both = texture { L1 } texture { L2 scale .5 };
sphere { <-1.1,0,0>, 1 texture { Both } }
sphere { <1.1,0,0>, 1 texture { L1 } texture { L2 rotate 45*z normal { dents .5 scale .2 } } texture { pigment { onion color_map { [.48 rgbt 1] [.5 rgbt <0,0,1,.4>] [.52 rgbt 1] } scale .4 } } }
box { <-2,-1.2,-1>, <2,-1,1> texture { checker texture { L1 } texture { pigment { rgb .2 } } scale .5 } }
box { <-2,1,-.2>,<2,1.3,.2> texture { gradient x texture_map { [0 L1] [.5 Both] [1 pigment { rgb z } finish { ambient .3 }] } scale 4 translate -2*x } }
light_source { <3,5,-8> 1 } camera { location <0,0,-5> look_at 0 }
