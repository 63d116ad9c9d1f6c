#version 3.1;
// Spiral generator idiom (Colefax)
#declare spiral_type = 1;
#declare revolutions = 3;
#declare start_width = .3; #declare end_width = .1; #declare mid_width = (start_width+end_width)/2;
#declare width_start = .8; #declare width_end = .2;
#declare length = 3;
#ifndef (spacing_type) #declare spacing_type = 1; #end
#declare start_scale = 1, #declare end_scale = .4;
#declare shape_count = 40;
#declare sshape = sphere { 0, .1 }
union {
 #declare s_loop = 0;
 #while (s_loop < shape_count)
   #declare s_p = s_loop/(shape_count-1);
   object { sshape scale start_scale + (end_scale-start_scale)*s_p
    translate x*(width_start+(width_end-width_start)*s_p)
    translate y*length*s_p
    rotate y*360*revolutions*s_p }
   #declare s_loop = s_loop + 1;
 #end
 texture { pigment { rgb <1,.8,.2> } finish { specular .7 roughness .02 metallic } }
}
camera { location <0,3,-5> look_at <0,1.4,0> }
light_source { <5,9,-9> rgb 1 }
