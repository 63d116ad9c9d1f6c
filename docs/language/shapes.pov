// The shapes of the reference, in rows from the upper left.
// verisim render docs/language/shapes.pov +W704 +H440 +A0.1 +Odocs/language/shapes.png
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

#declare Columns = 8;
#declare Rows = 4;
camera { orthographic location <Columns/2, -Rows*1.25/2, -20> right (Columns + 0.2)*x up (Rows*1.25 + 0.2)*y direction z }
light_source { <-30, 60, -80>, rgb 1.1 }
light_source { <60, 10, -60>, rgb <0.22, 0.26, 0.34> shadowless }
background { srgb <0.96, 0.96, 0.95> }
#default { pigment { srgb <0.80, 0.42, 0.24> } finish { ambient 0.14 diffuse 0.75 specular 0.35 roughness 0.03 } }

#declare Names = array[32] {
  "sphere", "box", "cylinder", "cone", "torus", "plane", "disc", "ovus",
  "superellipsoid", "quadric", "quartic", "lathe", "sor", "prism", "sphere_sweep", "text",
  "blob", "isosurface", "parametric", "julia_fractal", "height_field", "bicubic_patch", "mesh", "smooth_triangle",
  "polygon", "union", "intersection", "difference", "merge", "clipped_by", "open", "light_source" }

#declare Ball = function (x, y, z) { x*x + y*y + z*z - 1 }
#declare Left = sphere { -0.4*x, 0.75 pigment { srgb <0.16, 0.47, 0.58> } }
#declare Right = sphere { 0.4*x, 0.75 }
#declare Shape = array[32] {
  sphere { 0, 1 }
  box { -0.7, 0.7 }
  cylinder { -0.8*y, 0.8*y, 0.65 }
  cone { -0.8*y, 0.9, 0.9*y, 0.1 }
  torus { 0.75, 0.27 }
  intersection { plane { y, 0 } box { <-0.95, -0.05, -0.95>, <0.95, 1, 0.95> } }
  disc { 0, y, 0.95, 0.4 }
  ovus { 0.7, 0.4 translate -0.4*y }
  superellipsoid { <0.3, 0.3> scale 0.75 }
  intersection { quadric { <1, -0.8, 1>, 0, 0, -0.15 } box { -0.9, 0.9 } }
  quartic { <1,0,0,0,2,0,0,2,0,-1.22,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.06,0,0,0,0,1,0,-1.22,0,0.28> sturm scale 0.9 }
  lathe { cubic_spline 7, <0.2,-1.2>, <0.7,-0.8>, <0.3,-0.3>, <0.75,0.3>, <0.4,0.75>, <0.1,0.9>, <0,1> }
  sor { 6, <0.5,-1.2>, <0.6,-0.8>, <0.3,-0.1>, <0.65,0.45>, <0.2,0.85>, <0.1,1> }
  prism { -0.4, 0.4, 11 #for (I, 0, 10) <sin(I*pi/5), cos(I*pi/5)>*(mod(I,2) ? 0.45 : 1) #if (I < 10) , #end #end rotate -60*x }
  sphere_sweep { cubic_spline 6, <-1,-1,0>, 0.1, <-0.7,-0.6,0>, 0.15, <0.6,-0.3,0.3>, 0.25, <-0.4,0.3,-0.3>, 0.2, <0.6,0.7,0>, 0.1, <1,1,0>, 0.1 }
  text { internal 2 "Ag" 0.4, 0 scale 1.3 translate <-0.75, -0.35, -0.2> }
  blob { threshold 0.5 sphere { <-0.4,-0.2,0>, 0.9, 1 } sphere { <0.45,-0.1,0>, 0.8, 1 } sphere { <0,0.5,0>, 0.7, 1 } }
  isosurface { function { Ball(x, y, z) + 0.25*sin(9*x)*sin(9*y)*sin(9*z) } contained_by { sphere { 0, 1.2 } } max_gradient 6 scale 0.9 }
  parametric { function { 0.5*v*cos(u) } function { 0.35*(u - pi) - 0.3*v*0 } function { 0.5*v*sin(u) } <0, -1.6>, <2*pi, 1.6> contained_by { box { -1.2, 1.2 } } max_gradient 2 accuracy 0.02 scale 0.8 }
  julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 60 scale 0.72 }
  height_field { function 96, 96 { pattern { bozo scale 0.22 } } smooth translate -0.5 scale <2, 0.8, 2> }
  bicubic_patch { type 1 flatness 0.01 u_steps 4 v_steps 4 <-1,0,-1>,<-0.3,1,-1>,<0.3,-1,-1>,<1,0,-1>,<-1,0.6,-0.3>,<-0.3,1.4,-0.3>,<0.3,0,-0.3>,<1,0,-0.3>,<-1,0,0.3>,<-0.3,0.4,0.3>,<0.3,-1,0.3>,<1,0.5,0.3>,<-1,0,1>,<-0.3,0.6,1>,<0.3,-0.6,1>,<1,0,1> }
  mesh { #for (I, 0, 4) triangle { <0,0.9,0>, vrotate(<0.8,-0.5,0>, I*72*y), vrotate(<0.8,-0.5,0>, (I+1)*72*y) } #end }
  smooth_triangle { <-0.9,-0.7,0>, <-1,-0.6,-1>, <0.9,-0.7,0>, <1,-0.6,-1>, <0,0.9,0>, <0,1,-1> }
  polygon { 10, <-0.9,-0.8>, <0.9,-0.8>, <0.9,0.8>, <-0.9,0.8>, <-0.9,-0.8>, <-0.5,-0.4>, <0.5,-0.4>, <0.1,0.5>, <-0.5,0.4>, <-0.5,-0.4> }
  union { object { Left } object { Right } }
  intersection { object { Left } object { Right } }
  difference { object { Right scale 1.2 } object { Left scale 1.2 translate -0.1*z } rotate 40*y }
  merge { object { Left } object { Right } pigment { srgb <0.80, 0.42, 0.24> transmit 0.6 } }
  sphere { 0, 0.95 clipped_by { plane { y + 0.3*x - 0.6*z, 0.15 } } texture { pigment { srgb <0.80, 0.42, 0.24> } } interior_texture { pigment { srgb <0.16, 0.47, 0.58> } } }
  cylinder { -0.8*y, 0.8*y, 0.65 open texture { pigment { srgb <0.80, 0.42, 0.24> } } interior_texture { pigment { srgb <0.16, 0.47, 0.58> } } rotate -20*x }
  union { sphere { 0, 0.35 pigment { rgb <1, 0.85, 0.4> } finish { ambient 0 diffuse 0 emission 1 } } #for (I, 0, 11) cylinder { 0.5*y, 0.9*y, 0.04 rotate 30*I*z pigment { srgb <0.9, 0.7, 0.3> } } #end } }

#for (I, 0, 31)
  #local Middle = <mod(I, Columns) + 0.5, -div(I, Columns)*1.25 - 0.5, 0>;
  object { Shape[I] rotate -28*y rotate -24*x scale 0.44 translate Middle }
  text { internal 2 Names[I] 0.01, 0 scale 0.13 translate Middle + <-0.42, -0.66, -3>
    pigment { srgb <0.1, 0.12, 0.16> } finish { ambient 0 diffuse 0 specular 0 emission 1 } no_shadow }
#end
