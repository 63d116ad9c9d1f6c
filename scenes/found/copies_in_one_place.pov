// Copies of a mesh in one place, in many colours: POV-Ray's order of them decides which is seen. Some are mirrored, in
// the same box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 2.2, -5> look_at <0, 0.3, 0> angle 40 }
light_source { <-6, 9, -8>, rgb 1 }
light_source { <7, 5, -3>, rgb 0.5 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.4, 0.6> } finish { reflection 0.2 } }

#declare Thing = mesh {
  triangle { <-1, -1, -1>, <1, -1, -1>, <-1, 1, 0.5> }
  triangle { <1, -1, -1>, <1, -1, 1>, <-1, 1, 0.5> }
  triangle { <1, -1, 1>, <-1, -1, -1>, <-1, 1, 0.5> }
  triangle { <-1, -1, -1>, <1, -1, 1>, <1, -1, -1> }
}
#declare I = 0;
#while (I < 24)
  object {
    Thing
    #if (mod(I, 3) = 1) scale <-1, 1, 1> #end
    #if (mod(I, 4) = 3) hollow interior { ior 1.2 } #end
    pigment { rgbt <mod(I, 2), mod(I, 5)/4, mod(I, 7)/6, (mod(I, 4) = 3 ? 0.6 : 0)> }
  }
  #declare I = I + 1;
#end
