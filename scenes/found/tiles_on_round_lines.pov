// Faces that lie in borders of tiles (spec 05 9.1): of squares and hexagons or triangles (16, 17), of squares, hexagons
// and dodecagons (23, 24), and on whole numbers that are thirds of periods (11).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <-12, 5, -12> look_at <3.4, 0.3, 3.4> right 13*x up 9.75*y }
#default { finish { ambient 1 diffuse 0 } }

#macro Block(Number, Low, Height)
  box { <Low.u, Height, Low.v>, <Low.u + 7.5, Height + 0.8, Low.v + 7.5>
    pigment { tiling Number color_map { [0 rgb <0.2, 0.1, 0>] [0.4 rgb <0.9, 0.5, 0.2>] [0.7 rgb <0.2, 0.6, 0.9>] [1 rgb 1] } }
    translate -y*0.4
  }
#end
Block(16, <-0.5, 0.5>, 3)
Block(17, <-0.5, -0.5>, 2)
Block(23, <-0.5, 0.5>, 1)
Block(24, <-0.5, -0.5>, 0)
Block(24, <0.5, 0.5>, -1)
Block(11, <4, 4>, -2)
Block(11, <-5, -5>, -3)
