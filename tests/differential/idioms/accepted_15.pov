// VMD
#declare VMD_objq_translate = 0.5;
#macro VMDC_sphere (SP, SR, SC) sphere { SP, SR pigment { rgbt SC } } #end
#declare VMD_line_width=0.0020;
#macro VMDC(C1) texture { pigment { rgbt C1 }} #end
#macro VMD_point(P1, R1, C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  #if(VMD_point_visible) sphere {P1, R1 texture {T} no_shadow} #end
#end
#declare VMD_point_visible = on;
#macro VMD_line(P1,P2,C1)
  #local T = texture { finish { ambient 1.0 diffuse 0.0 phong 0.0 specular 0.0 } pigment { C1 } }
  cylinder {P1, P2, VMD_line_width texture {T} no_shadow}
#end
#macro VMD_sphere(P1, R1, C1)
  #local T = texture { pigment { C1 } }
  #if(VMD_clip_on[1]) #local T2 = texture { T } sphere {P1, R1 texture {T2} } #else sphere {P1, R1 texture {T} } #end
#end
#declare VMD_clip_on=array[3] {0, 0, 0};
#declare VMD_clip=array[3];
#macro VMD_triangle(P1, P2, P3, N1, N2, N3, C1)
  smooth_triangle {P1, N1, P2, N2, P3, N3 texture { pigment { C1 } } }
#end
camera { up <0, 3.0000, 0> right <3.0000, 0, 0> location <0.0000, 0.0000, -2.0000> look_at <0.0000, 0.0000, 2.0000> direction <0.0000, 0.0000, 4.0000> }
light_source { <-0.1000, 0.1000, -1.0000> color rgb<1.000, 1.000, 1.000> parallel point_at <0.0, 0.0, 0.0> }
background { color rgb<0.000, 0.000, 0.000> }
fog { distance 1.76 fog_type 1 color rgb<0.000, 0.000, 0.000> }
#default { texture { finish { ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.000 specular 0.500 } } }
VMD_sphere(<0.1,0.2,0.3>,0.05,rgbt<1,0,0,0>)
VMD_line(<0,0,0>,<1,1,1>,rgbt<1,0,0,0>)
VMD_triangle(<0,0,0>,<1,0,0>,<0,1,0>,<0,0,1>,<0,0,1>,<0,0,1>,rgbt<1,0,0,0>)
VMD_point(<0,0,0>,.1,rgbt<1,1,1,0>)
