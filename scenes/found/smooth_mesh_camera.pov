// A camera over the uv map of a bumpy mesh before a backdrop of grains of 1e-12: the last bits of the weights of a
// triangle's corners, and of the smooth normal there, which is moved before it is made a unit vector.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = seed(1);
#declare P = array[9][7];
#declare N = array[9][7];
#for (J, 0, 6) #for (I, 0, 8)
  #declare P[I][J] = <I * 0.5 - 2, J * 0.5 - 1.5, 0.6 * rand(S) - 0.3>;
  #declare N[I][J] = <0.6 * rand(S) - 0.3, 0.6 * rand(S) - 0.3, 1>;
#end #end
#macro Place(I, J) <I / 8 * 1.02 - 0.01, J / 6 * 1.02 - 0.01> #end
#macro Face(A, B, C, D, E, F)
  smooth_triangle {
    P[A][B], N[A][B], P[C][D], N[C][D], P[E][F], N[E][F] uv_vectors Place(A, B), Place(C, D), Place(E, F)
  }
#end
camera {
  mesh_camera {
    1 3
    mesh {
      #for (J, 0, 5) #for (I, 0, 7) Face(I, J, I + 1, J, I, J + 1) Face(I + 1, J + 1, I, J + 1, I + 1, J) #end #end
      rotate <10, 20, 30> scale <1, 2, 0.7> translate <0.1, 0.2, 0.3>
    }
    smooth
  }
  location 0.01 * z
}
box {
  -20, 20 hollow
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
