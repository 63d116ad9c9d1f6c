#declare v2 = <1,2,3>;
#declare P = pigment { color rgb v2 }
sphere { v2, 1 pigment { P } finish { Dull } }
