#version 3.6;
#declare f = function(x) { x*x }
#declare Arr = array[2][2] { {1,2},{3,4} }
#declare s = concat("a", str(f(2),0,0), vstr(3, <1,2,3>, ",", 0, 1))
text { ttf "cyrvetic.ttf" s 1, 0 pigment { rgb 1 } }
photons_test
