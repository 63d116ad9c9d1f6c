// Arguments without a comma between them: the first becomes the second, where both are identifiers (spec 08 H).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -10>, 1 }

#macro Ball(Radius, Place) sphere { Place*x, Radius pigment { rgb <1, 0.6, 0.2> } } #end
#declare Small = 0.3;
#declare Far = 1.2;
Ball(Small, Far)
Ball(Far Small)
