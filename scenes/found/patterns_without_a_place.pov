// Where a warp has no place for a point, patterns are asked for what is no number: lists show their first entry but for
// triangular (the fifth) and cubic (the last), maps the first but for agate and tiling (spec 05 6). A `mesh2` without
// uv_vectors is at the origin all over, which a cubic warp does not know.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -8 * z direction z right 8 * x up 6 * y }
#default { finish { ambient 1 diffuse 0 } }
#declare Row = 0;
#declare Column = 0;
#macro Show(Pigment)
  mesh2 {
    vertex_vectors { 3, 0, 0.9 * x, 0.9 * y }
    face_indices { 1, <0, 1, 2> }
    texture { uv_mapping pigment { Pigment warp { cubic } } }
    translate <Column - 4, 2 - Row, 0>
  }
  #declare Column = mod(Column + 1, 8);
  #if (Column = 0) #declare Row = Row + 1; #end
#end
#macro Map(Pigment) Show(pigment { Pigment color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } }) #end
Map(pigment { agate }) Map(pigment { boxed }) Map(pigment { bozo }) Map(pigment { crackle }) Map(pigment { dents })
Map(pigment { gradient x }) Map(pigment { granite }) Map(pigment { leopard }) Map(pigment { mandel 50 })
Map(pigment { marble }) Map(pigment { onion }) Map(pigment { quilted }) Map(pigment { radial }) Map(pigment { ripples })
Map(pigment { spiral1 3 }) Map(pigment { spiral2 3 }) Map(pigment { waves }) Map(pigment { wood })
Map(pigment { wrinkles }) Map(pigment { tiling 7 }) Map(pigment { julia <0.3, 0.5>, 20 }) Map(pigment { cells })
Map(pigment { density_file df3 "spiral.df3" interpolate 1 })
Show(pigment { checker rgb x, rgb y })
Show(pigment { brick rgb x, rgb y })
Show(pigment { hexagon rgb x, rgb y, rgb z })
Show(pigment { square rgb x, rgb y, rgb z, rgb 1 })
Show(pigment { triangular rgb x, rgb y, rgb z, rgb 1, rgb 0.5, rgb x + y })
Show(pigment { cubic rgb x, rgb y, rgb z, rgb 1, rgb 0.5, rgb x + y })
