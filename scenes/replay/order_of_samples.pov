// The tip of a cone, in the penumbra of a bar. Its own far side is nearer than where shadows begin (0.001): it shades
// only samples of an area light that come after one that the cone has shaded, before the bar shades another. The order of
// samples shows, quarter after quarter of the grid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at <0, 1.999, 0> angle 0.06 }
light_source { <-2, 7, 1>, 1 area_light 3 * x, 3 * y, 5, 5 }
cone { 0, 1, 2 * y, 0 pigment { rgb <1, 0.8, 0.5> } finish { ambient 0.1 diffuse 0.9 } normal { bumps 0.8 scale 0.0004 } }
box { <-1.2, 4.2, -1>, <-0.7, 4.4, 1> }
