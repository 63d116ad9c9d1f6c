// The last digits of what carries a matrix, or takes one into its own numbers, in mirrors before a backdrop whose grains
// are 1e-11 wide: inverses of matrices and of transformations, scaled planes, moved quadrics, polygons, smooth triangles
// alone and in meshes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at 0 }
box { -9, 9 hollow pigment { function { mod(abs(x + y + z) * 1e11, 1) > 0.5 } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
#default { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
#declare Skew = transform { matrix <1.1, 0.2, 0, 0.1, 0.9, 0.3, -0.4, 0.3, 0.8, -2.2, 1.4, 0.3> }
#declare Mesh = mesh { smooth_triangle { <-0.9, 0, 0.2>, <0, 0.2, 1>, <0.9, -0.8, 0>, <0.2, 0, 1>, <0.3, 0.9, 0.4>, <0.1, 0.3, 0.9> } }
sphere { 0, 0.7 transform { Skew } }
box { -0.5, 0.5 transform { rotate <10, 20, 30> scale <1, 0.8, 1.3> translate <0.1, -1.5, -0.2> inverse } }
plane { <1, 2, -0.3>, -1.9 scale <1.1, 1.3, 0.7> }
quadric { <1, 1, 0.4>, <0.1, 0, 0>, <0, 0.2, 0>, -0.4 rotate <10, 20, 30> translate <2.3, -0.6, 0.2> }
polygon { 4, <-0.9, -0.8, 0.2>, <0.8, -0.9, 0.4>, <0.7, 0.9, -0.2>, <-0.9, -0.8, 0.2> rotate <10, 20, 30> translate <0.2, -1.4, -1> }
object { Mesh translate <2.4, 1.4, 0> }
smooth_triangle { <-0.9, 0, 0.2>, <0, 0.2, 1>, <0.9, -0.8, 0>, <0.2, 0, 1>, <0.3, 0.9, 0.4>, <0.1, 0.3, 0.9> translate <-2.2, -0.9, 0> }
