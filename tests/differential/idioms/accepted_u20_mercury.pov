// created by Mercury
#version 3.7;
global_settings { assumed_gamma 2.2 ambient_light rgb < 1, 1, 1 > max_trace_level 20 }
#declare mercury_solid_plastic = finish { ambient 0.2 diffuse 0.6 specular 0.4 roughness 0.01 };
#declare showcell = 1;
#declare zoom = 1.0;
#declare cell_a = < 5.43, 0.0, 0.0 >;
#declare cell_b = < 0.0, 5.43, 0.0 >;
#declare cell_c = < 0.0, 0.0, 5.43 >;
#declare view_scale = zoom * 0.1;
#declare global_transform = transform { matrix < 0.8, 0.1, -0.2,  -0.1, 0.9, 0.1,  0.2, -0.1, 0.9,  0, 0, 0 > scale view_scale };
#macro atom( pos, rad, col, lbl )
 #if ( strlen(lbl) > 0 ) #debug concat( "atom ", lbl, " at ", vstr( 3, pos, " ", 0, 3 ), "\n" ) #end
 sphere { pos, rad pigment { color col } finish { mercury_solid_plastic } }
#end
#macro bond( p1, p2, r, c1, c2 )
 #local mid = (p1 + p2) * 0.5;
 cylinder { p1, mid, r pigment { color c1 } finish { mercury_solid_plastic } }
 cylinder { mid, p2, r pigment { color c2 } finish { mercury_solid_plastic } }
#end
#declare mol = union {
 atom( < 0, 0, 0 >, 0.5, rgb < 0.5, 0.5, 0.5 >, "C1" )
 atom( < 1.5, 0.3, 0.1 >, 0.45, rgb < 1, 0, 0 >, "O1" )
 bond( < 0, 0, 0 >, < 1.5, 0.3, 0.1 >, 0.12, rgb < 0.5, 0.5, 0.5 >, rgb < 1, 0, 0 > )
 #if ( showcell )
  #local cc = array[2] { 0, 1 };
  #local i1 = 0;
  #while ( i1 < 2 ) #local i2 = 0; #while ( i2 < 2 )
   cylinder { cc[i1]*cell_b + cc[i2]*cell_c, cell_a + cc[i1]*cell_b + cc[i2]*cell_c, 0.05 pigment { color rgb 0.2 } }
  #local i2 = i2 + 1; #end #local i1 = i1 + 1; #end
 #end
};
object { mol transform { global_transform } }
camera { orthographic location < 0, 0, -10 > direction < 0, 0, 1 > right < 1.6, 0, 0 > up < 0, 1.2, 0 > sky < 0, 1, 0 > }
light_source { < 10, 10, -20 > color rgb < 1, 1, 1 > }
background { color rgb < 0.95, 0.95, 1 > }
