// A ray from each of many triangles, of no order, before a backdrop of grains of 1e-12: their middles are summed up and
// their normals kept in single precision.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = seed(1);
#macro Somewhere() <6 * rand(S) - 3, 6 * rand(S) - 3, 6 * rand(S) - 3> #end
camera {
  mesh_camera {
    1 0
    mesh {
      #for (I, 1, image_width * image_height) triangle { Somewhere(), Somewhere(), Somewhere() } #end
      rotate <10, 20, 30> scale <1, 2, 0.7> translate <0.1, 0.2, 0.3>
    }
  }
  location 0.01 * z
}
box {
  -20, 20 hollow
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
