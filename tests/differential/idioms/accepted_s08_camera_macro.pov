#version 3.7;
#macro Cam(From, To, Zoom) camera { perspective location From right x*image_width/image_height up y look_at To angle Zoom } #end
#macro Light(P, C) light_source { P color C fade_distance 8 fade_power 2 } #end
#default { finish { ambient 0.1 diffuse 0.7 } }
#default { pigment { rgb <.7,.7,.9> } }
Cam(<2,2,-5>, <0,.5,0>, 42)
Light(<4,6,-6>, rgb 1.5) Light(<-5,2,-3>, rgb <.3,.2,.1>)
global_settings { assumed_gamma 1.0 max_trace_level 6 }
sphere { .5*y, .5 }
#default { texture { pigment { rgb <1,.4,.2> } finish { phong .6 } } }
box { <-1.6,0,-.4>, <-.8,.9,.4> }
superellipsoid { <.3,.3> scale .4 translate <1.2,.4,0> }
plane { y, 0 texture { pigment { rgb .6 } } }
