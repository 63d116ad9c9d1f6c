// A plane that has taken the box of what bounds it: rays that graze the box see it or not by the box's last bits (spec 08
// A).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { cylinder 1 location <0, 2, -7> look_at 0 }
light_source { <0, 10, 0>, 1 }
light_source { <100, 200, -300>, 1 }
plane { y, -0.5 pigment { checker rgb 1 rgb <1, 0.6, 0.2> scale 0.3 } bounded_by { sphere { 0, 1.2 } } }
