// the clip moves with its object
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0 emission 1 } }
camera { orthographic location <0,0.03,-5> direction z right 4*x up y*0.0001 }
background { rgb <0,0,1> }
#declare R = texture { pigment { rgb <1,0,0> } }
#declare G = texture { pigment { rgb <0,1,0> } }
#declare W = texture { pigment { rgb 1 } }
sphere { 0, 1 texture { R } clipped_by { plane { x, 0 } } translate 0.5*x }
