#version 3.1
#declare Red = color red 1 green 0
camera { location <0,1,-5> direction <0,0,1.5> up y right <4/3,0,0> look_at 0 }
light_source { <10,10,-10> color red 1 green 1 blue 1 }
#default { finish { ambient .2 } }
#declare A = array[2]{1,2}
mesh { triangle { <0,0,0>,<1,0,0>,<0,1,0> } smooth_triangle { <0,0,0>,y,<1,0,0>,y,<0,1,0>,y } }
mesh2 { vertex_vectors { 3, <0,0,0>,<1,0,0>,<0,1,0> } face_indices { 1, <0,1,2> } uv_vectors { 1, <0,0> } }
object { union { sphere { 0,1 } box { 0, 1 rotate <1,2,3> } } matrix <1,0,0,0,1,0,0,0,1,0,0,0> pigment { checker color Red color rgbf <1,1,1,.5> } }
fog { distance 10 colour rgb .5 } sky_sphere { pigment { gradient y color_map { [0 rgb 1][1 rgb 0] } } }
blob { threshold .6 sphere { 0,1,1 } cylinder { 0,y,1,1 } component 1,1,x }
isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0,2 } } }
julia_fractal { <-.1,.2,.3,.4> } lathe { linear_spline 3,<0,0>,<1,1>,<0,2> } sor { 4,<0,0>,<1,1>,<1,2>,<0,3> }
prism { 0,1,4,<0,0>,<1,0>,<1,1>,<0,0> } text { ttf "timrom.ttf" "a" 1,0 } height_field { function 4,4 { x } }
parametric { function{u} function{v} function{0} <0,0>,<1,1> } bicubic_patch { type 1 flatness .1 u_steps 2 v_steps 2 <0,0,0><1,0,0><2,0,0><3,0,0><0,0,1><1,0,1><2,0,1><3,0,1><0,0,2><1,0,2><2,0,2><3,0,2><0,0,3><1,0,3><2,0,3><3,0,3> }
sphere_sweep { b_spline 4,<0,0,0>,1,<1,0,0>,1,<2,0,0>,1,<3,0,0>,1 } poly { 2,<1,0,0,0,1,0,0,1,0,-1> } quadric { 1,0,0,-1 } superellipsoid { <.5,.5> } torus { 1,.2 }
light_group { light_source { 0 rgb 1 spotlight point_at y } sphere { 0,1 } global_lights on } polygon { 4,0,x,x+y,y } disc { 0,y,1,.2 } cone { 0,1,y,0 } plane { y,0 } ovus { 1,.5 }
sphere { 0,1 hollow interior { ior 1.5 media { scattering { 1, rgb 1 } density { spherical density_map { [0 rgb 0][1 rgb 1] } } } } photons { target reflection on } }
