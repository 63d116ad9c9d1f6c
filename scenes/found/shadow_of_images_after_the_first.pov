// That an image in an entry of a pigment's map filters is known from the second object on that has the map, whatever
// shares it: the first blocks all light. A pigment that has taken the place of such a map counts, too (spec 06 9.3).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -9> look_at <0, 0, 0.3> angle 42 }
light_source { <-3, 12, -6>, 0.8 }
plane { y, -1 pigment { rgb 1 } }
#declare Shown = pigment {
  checker pigment { rgb <1, 0.4, 0.4> }, pigment { image_map { function 8, 8 { x } filter all 0.9 } }
  scale 0.7
};
#declare Pane = box { <-0.8, 1, -0.6>, <0.8, 1.1, 0.6> };
object { Pane pigment { Shown } translate <-2.2, 0, 1> }
object { Pane pigment { Shown } translate <0, 0, 1> }
object { Pane pigment { Shown rgb <0.5, 0.6, 1> } translate <2.2, 0, 1> }
difference { object { Pane } sphere { <0, 1.1, 0>, 0.3 } pigment { Shown rotate 45 * y } translate <-2.2, 0, -0.7> }
object { Pane texture { wood texture_map { [0 pigment { Shown }] [1 pigment { rgbt 0.5 }] } } translate <0, 0, -0.7> }
// The parts of a union are ready together.
union {
  object { Pane translate <-0.9, 0, 2.6> }
  object { Pane translate <0.9, 0, 2.6> }
  pigment { gradient y pigment_map { [0 rgb <0.6, 1, 0.6>] [1 image_map { function 8, 8 { y } filter all 0.8 }] } }
}
object { Pane pigment { checker pigment { rgb 1 }, pigment { image_map { function 8, 8 { x } filter all 0.9 } } } translate <2.2, 0, -0.7> }
