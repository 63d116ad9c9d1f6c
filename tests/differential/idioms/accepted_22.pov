#include "colors.inc"
#include "textures.inc"
#include "shapes.inc"
camera { location <0, 2, -3> look_at <0, 1, 2> }
sphere { <0, 1, 2>, 2 texture { pigment { color Yellow } } }
light_source { <2, 4, -3> color White}
object { UnitBox texture { White_Marble scale .5 } }
plane { y, 0 texture { DMFWood4 } }
