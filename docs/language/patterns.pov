// The patterns of the reference, each on a tile; in rows from the upper left, in the order of the names below.
// verisim render docs/language/patterns.pov +W660 +H309 +A0.1 +Odocs/language/patterns.png
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Columns = 11;
#declare Rows = 4;
camera { orthographic location <Columns/2, -Rows*1.18/2, -10> right (Columns + 0.3)*x up (Rows*1.18 + 0.3)*y direction z }
background { srgb <0.96, 0.96, 0.95> }

#declare Ramp = color_map { [0 srgb <0.07, 0.16, 0.29>] [0.35 srgb <0.16, 0.47, 0.58>] [0.65 srgb <0.91, 0.80, 0.55>] [1 srgb <0.80, 0.32, 0.20>] }
#declare A = srgb <0.07, 0.16, 0.29>;
#declare B = srgb <0.91, 0.80, 0.55>;
#declare C = srgb <0.80, 0.32, 0.20>;
#declare D = srgb <0.16, 0.47, 0.58>;

#declare Names = array[44] {
  "agate", "boxed", "bozo", "brick", "bumps", "cells", "checker", "crackle", "cubic", "cylindrical", "dents",
  "function", "gradient", "granite", "hexagon", "image_pattern", "julia", "leopard", "magnet", "mandel", "marble", "object",
  "onion", "pavement", "planar", "quilted", "radial", "ripples", "spherical", "spiral1", "spiral2", "spotted", "square",
  "tiling", "triangular", "waves", "wood", "wrinkles", "turbulence", "solid", "frequency", "sine_wave", "warp", "phase" }
#declare Tile = array[44] {
  pigment { agate color_map { Ramp } scale 0.5 }
  pigment { boxed color_map { Ramp } scale 1.6 }
  pigment { bozo color_map { Ramp } scale 0.3 }
  pigment { brick color B color C scale 0.09 }
  pigment { bumps color_map { Ramp } scale 0.2 }
  pigment { cells color_map { Ramp } scale 0.5 }
  pigment { checker color A color B scale 0.5 }
  pigment { crackle color_map { Ramp } scale 0.4 }
  pigment { cubic color A color B color C color D color rgb 0.9 color rgb 0.2 }
  pigment { cylindrical color_map { Ramp } rotate 90*x scale 1.1 }
  pigment { dents color_map { Ramp } scale 0.2 }
  pigment { function { (1 + sin(9*x)*sin(9*y))/2 } color_map { Ramp } }
  pigment { gradient x color_map { Ramp } }
  pigment { granite color_map { Ramp } scale 0.8 }
  pigment { hexagon color A color B color C rotate 90*x scale 0.25 }
  pigment { image_pattern { function 64, 64 { abs(sin(12*x*y)) } } color_map { Ramp } translate -0.5 scale 2 }
  pigment { julia <0.353, 0.288>, 40 color_map { Ramp } scale 0.75 }
  pigment { leopard color_map { Ramp } scale 0.12 }
  pigment { magnet 1 mandel 40 color_map { Ramp } translate -1.3*x scale 0.38 }
  pigment { mandel 40 color_map { Ramp } translate 0.6*x scale 0.75 }
  pigment { marble turbulence 0.6 color_map { Ramp } scale 0.5 }
  pigment { object { text { internal 2 "A" 2, 0 translate <-0.36, -0.35, -1> scale <2, 2, 1> } color B color C } }
  pigment { onion color_map { Ramp } scale 0.4 }
  pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 2 color_map { Ramp } rotate 90*x scale 0.2 }
  pigment { planar color_map { Ramp } }
  pigment { quilted color_map { Ramp } scale 0.5 translate 0.1*z }
  pigment { radial color_map { Ramp } rotate 90*x }
  pigment { ripples color_map { Ramp } scale 0.4 }
  pigment { spherical color_map { Ramp } scale 1.2 }
  pigment { spiral1 5 color_map { Ramp } scale 0.5 }
  pigment { spiral2 5 color_map { Ramp } scale 0.5 }
  pigment { spotted color_map { Ramp } scale 0.3 }
  pigment { square color A color B color C color D rotate 90*x scale 0.4 }
  pigment { tiling 17 color_map { Ramp } rotate 90*x scale 0.25 }
  pigment { triangular color A color B color C color D color rgb 0.9 color rgb 0.2 rotate 90*x scale 0.5 }
  pigment { waves color_map { Ramp } scale 0.2 }
  pigment { wood color_map { Ramp } scale 0.4 translate 0.3*x }
  pigment { wrinkles color_map { Ramp } scale 0.4 }
  pigment { wood turbulence 0.25 color_map { Ramp } scale 0.4 }
  pigment { crackle solid color_map { Ramp } scale 0.4 }
  pigment { onion frequency 3 color_map { Ramp } scale 0.8 }
  pigment { onion sine_wave color_map { Ramp } scale 0.4 }
  pigment { gradient x color_map { Ramp } scale 0.5 warp { black_hole <0.1, 0, 0>, 0.8 strength 1.4 } }
  pigment { onion phase 0.5 color_map { Ramp } scale 0.4 } }

#for (I, 0, 43)
  #local Corner = <mod(I, Columns) + 0.5, -div(I, Columns)*1.18 - 0.5, 0>;
  box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1>
    pigment { Tile[I] scale 0.46 } finish { ambient 0 diffuse 0 emission 1 } translate Corner }
  text { internal 2 Names[I] 0.01, 0 scale 0.13 translate Corner + <-0.46, -0.6, 0>
    pigment { srgb <0.1, 0.12, 0.16> } finish { ambient 0 diffuse 0 emission 1 } }
#end
