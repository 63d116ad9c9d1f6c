// A camera of oblique triangles that face both ways, between walls of grains in the last bits of where its rays begin
// (spec 02, 1.7): the area of a triangle is measured from the corner that POV-Ray has first.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare N = 6;
#declare Shift = function(a, b, c) { 0.06 * sin(37 * a + 91 * b + c) * select(-a * b * (N - a) * (N - b), 1, 0, 0) }
#macro Place(I, J) <2 * sin(7 * I + 3 * J), 1.5 * sin(5 * I - 11 * J + 1), 1> #end
#macro Mapped(I, J) <I / N + Shift(I, J, 0), J / N + Shift(I, J, 2)> #end
#macro Corners(A, B, C, D, E, F)
  triangle { Place(A, B), Place(C, D), Place(E, F) uv_vectors Mapped(A, B), Mapped(C, D), Mapped(E, F) }
#end
camera {
  mesh_camera {
    1 3
    mesh {
      #for (J, 0, N - 1)
        #for (I, 0, N - 1)
          Corners(I, J, I + 1, J, I + 1, J + 1)
          Corners(I, J + 1, I, J, I + 1, J + 1)
        #end
      #end
    }
  }
  location 0
}
#macro Grains(Z)
  plane {
    z, Z
    pigment { function { mod(abs(x + 4) * pow(2, 50), 8) / 8 + mod(abs(y + 4) * pow(2, 50), 8) / 64 } color_map { [0 rgb 0] [1 rgb 1] } }
    finish { ambient 0 emission 1 diffuse 0 }
  }
#end
Grains(5)
Grains(-5)
