#version 3.6;
#macro Open(c) sphere { c, #end
#macro Close(col) pigment { rgb col } } #end
#macro Num() 0.4 #end
#macro Vec3(a) a, a*2, a*3 #end
#macro Maybe(f) #if (f) finish { phong 1 } #end #end
Open(<-1,0,0>) Num() Close(x)
Open(0) .5 Maybe(yes) Close(<Vec3(.3)>)
box { <.7, -Num(), -Num()> <1.5, Num(), Num()> Maybe(no) Close(<#if (version < 3.5) 1,0,0 #else 0,1,1 #end>)
light_source { <3,5,-6>, rgb <Vec3(.5)> }
camera { location -4*z look_at 0 }
