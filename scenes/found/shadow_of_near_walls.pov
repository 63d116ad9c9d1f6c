// Small glasses so near to a wall that shadow rays begin beyond their near sides. Outside CSG the search ends with the
// segment that has those: where it holds the far side, too, that filters (below), where it does not, light comes through.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <5, 0, 0> look_at 0 angle 1.6 }
light_source { <100, 60, 0>, 1 }
plane { x, -0.0203 pigment { rgb 1 } finish { ambient 0.1 diffuse 0.9 } }
#default { pigment { rgbf <0.6, 0.7, 0.8, 0.9> } }
lathe { linear_spline 4, <0.02, -0.06>, <0.02, -0.005>, <0.02, 0.005>, <0.02, 0.06> no_image translate -0.05 * z }
lathe { cubic_spline 6, <0.02, -0.1>, <0.02, -0.06>, <0.02, -0.005>, <0.02, 0.005>, <0.02, 0.06>, <0.02, 0.1> no_image }
sor { 6, <0.02, -0.1>, <0.02, -0.06>, <0.02, -0.005>, <0.02, 0.005>, <0.02, 0.06>, <0.02, 0.1> no_image translate 0.05 * z }
