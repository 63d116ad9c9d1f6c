// Transformations in a material move its texture, not the interior_texture; those of the object move both (spec 05 11).
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 8 }
camera { location <0.2, 0.3, -3> }
#declare Skin = material {
  texture { pigment { checker rgb x rgb y } }
  interior_texture { pigment { checker rgb 1 rgb z } }
  rotate 20*y
}
cylinder { -y, y, 0.8 open material { Skin scale 0.7 } rotate <50, 0, 10> translate -1.1*x }
cylinder { -y, y, 0.8 open material { Skin } rotate <50, 0, -20> translate 0.9*x }
