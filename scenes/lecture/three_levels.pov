// Left: a wall seen through a pane of glass, front (1), back (2), wall (3). Right: the same wall by way of a mirror, mirror (1), mirror (2), wall (3).
// With max_trace_level 2 both are black.
#version 3.7;
#ifndef (Levels) #declare Levels = 3; #end
global_settings { assumed_gamma 1 max_trace_level Levels adc_bailout 0 }
camera { orthographic location <0, 0, -10> direction z right 4*x up 2*y }

#declare Bright = texture { pigment { rgb <0.2, 0.6, 1> } finish { ambient 0 diffuse 0 emission 1 } }
#declare Black_Mirror = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.5 } }

box { <-2, -1, 0>, <0, 1, 0.5> pigment { rgbt <1, 1, 1, 0.5> } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
box { <-2, -1, 3>, <0, 1, 3.1> texture { Bright } }

// Two mirrors at 45 degrees send the ray up and on.
polygon { 5, <0, -1, -1>, <2, -1, -1>, <2, 1, 1>, <0, 1, 1>, <0, -1, -1> texture { Black_Mirror } }
polygon { 5, <0, 9, -1>, <2, 9, -1>, <2, 11, 1>, <0, 11, 1>, <0, 9, -1> texture { Black_Mirror } }
box { <0, 8, 3>, <2, 12, 3.1> texture { Bright } }
