// two cylinders in the same place: merge
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0 emission 1 } }
camera { location <0.3,4,-5> look_at <0.1,-0.05,-0.2> angle 30 right x up y }
background { rgb <0,0,1> }
#declare R = texture { pigment { rgb <1,0,0> } }
#declare G = texture { pigment { rgb <0,1,0> } }
merge { cylinder { -y, y, 1 texture { R } } cylinder { -y, y, 1 texture { G } } }
