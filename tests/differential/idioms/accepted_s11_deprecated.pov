#version 3.6;
#declare deprecated "Old is out of fashion" Old = 2;
#declare deprecated once OldTex = texture { pigment { rgb <1,.5,0> } }
#declare A = Old + 1;
#declare B = Old*2;
sphere { 0, A/3 texture { OldTex } }
sphere { 2*x, B/5 texture { OldTex } }
#ifdef (Old) #debug "still there\n" #end
#undef Old
#ifndef (Old) #debug "gone\n" #end
camera { location -6*z look_at x } light_source { <2,3,-6> rgb 1 }
