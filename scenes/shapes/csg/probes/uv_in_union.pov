// uv_mapping of a union for its children
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0 emission 1 } }
camera { location <0.3,0.4,-5> look_at <0.1,-0.05,-1> angle 30 right x up y }
background { rgb <0,0,1> }
#declare R = texture { pigment { rgb <1,0,0> } }
#declare G = texture { pigment { rgb <0,1,0> } }
union { sphere { 0, 1 pigment { gradient x } } sphere { 9, 1 pigment { gradient x } } uv_mapping }
