#version 3.1;
// Lens-effects idiom (Colefax): options by declared identifiers
#declare effect_type = "Rainbow2"
#declare camera_location = <0, 2, -12>;
#declare camera_look_at = <0, 1, 0>;
#declare camera_sky = <0,1,0>;
#declare effect_location = <3, 4, 20>;
#ifndef (effect_scale) #declare effect_scale = 1; #end
#ifndef (effect_brightness) #declare effect_brightness = 1; #end
#ifndef (effect_always_on_top) #declare effect_always_on_top = true; #end
#ifndef (glow_falloff) #declare glow_falloff = 1; #end
#declare _LE_d = camera_look_at - camera_location;
#declare _LE_dir = vnormalize(_LE_d);
#declare _LE_right = vnormalize(vcross(camera_sky, _LE_dir));
#declare _LE_up = vcross(_LE_dir, _LE_right);
#declare _LE_dist = vdot(effect_location - camera_location, _LE_dir);
#declare _LE_pos = camera_location + (effect_location - camera_location)/_LE_dist;
#macro _LE_Spot(Pos, Size, Col)
  disc { <0,0,0>, z, Size
    pigment { onion color_map { [0 rgbt <1,1,1,0>*effect_brightness+Col] [0.5*Size rgbt Col+<0,0,0,0.6>] [Size rgbt <0,0,0,1>] } }
    finish { ambient 1 diffuse 0 }
    hollow
    matrix < _LE_right.x, _LE_right.y, _LE_right.z,
             _LE_up.x, _LE_up.y, _LE_up.z,
             _LE_dir.x, _LE_dir.y, _LE_dir.z,
             Pos.x, Pos.y, Pos.z >
    no_shadow
  }
#end
union {
  #declare Count = 0;
  #while (Count < 5)
    _LE_Spot(_LE_pos + Count*0.1*(camera_location+_LE_dir - _LE_pos), 0.05+0.03*mod(Count,3), rgbt <0.5, 0.2*Count, 0.3, 0.5>)
    #declare Count = Count + 1;
  #end
}
#switch (0)
 #case (strcmp(effect_type, "Rainbow2")) #debug "rainbow\n" #break
 #case (strcmp(effect_type, "Sun")) #debug "sun\n" #break
 #else #warning "unknown effect\n"
#end
camera { location camera_location look_at camera_look_at sky camera_sky }
sphere { y, 1 pigment { rgb x } }
plane { y,0 pigment { hexagon rgb 1, rgb .5, rgb .2 } }
light_source { effect_location rgb 1 }
