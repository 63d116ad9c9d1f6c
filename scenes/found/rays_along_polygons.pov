// Rays along the edges of polygons, which run aslant in the polygons' own frames: products of the last bits decide.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.8, 0.6, -5> look_at <0.8, 0.6, 0> right 1.6 * x up 1.2 * y }
#declare Square = polygon { 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> pigment { rgb 1 } finish { ambient 1 } }
#declare I = 0;
#while (I < 16)
  object { Square scale <0.09, 0.105 + I * 0.07, 1> translate 0.1 * I * x }
  #declare I = I + 1;
#end
