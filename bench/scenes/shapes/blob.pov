// A creature of forty balls and cylinders.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 3, -9> look_at <0, 0.4, 0> angle 45 }
light_source { <-8, 12, -10>, rgb 1 }
#default { finish { ambient 0.1 diffuse 0.7 specular 0.3 } }
blob {
  threshold 0.5
  #for (I, 0, 29)
    sphere { <2.2 * cos(I * 0.7), 0.5 + sin(I * 0.9), 1.6 * sin(I * 0.5)>, 0.9, 1 pigment { rgb <0.8, 0.4 + 0.01 * I, 0.3> } }
  #end
  #for (I, 0, 9)
    cylinder { <0, 0.5, 0>, <2.6 * cos(I * 0.63), 0.5 + 0.8 * sin(I * 1.7), 2.6 * sin(I * 0.63)>, 0.5, 0.9 pigment { rgb <0.3, 0.6, 0.3> } }
  #end
}
plane { y, -1.2 pigment { rgb <0.5, 0.6, 0.5> } }
