// Objects whose boxes end exactly where rays go.
#version 3.7;
global_settings { assumed_gamma 1 }
// Pixel centres are multiples of 1/2 at 160x120: some rays run exactly within the faces of boxes.
camera { orthographic location <0.25, 0.25, -100> right 80*x up 60*y look_at <0.25, 0.25, 0> }
background { rgb <0.1, 0.2, 0.3> }
#default { finish { ambient 0.7 diffuse 0.3 } }
light_source { <30, 50, -100>, rgb 1 }
difference { box { <-30, 10, -2>, <-20, 20, 2> } sphere { <-25, 15, -2>, 2 } pigment { rgb <1, 0.6, 0.4> } }
intersection { box { <-10, 10, -2>, <0, 20, 2> } box { <-10, 10, -2>, <0, 22, 2> } pigment { rgb <0.5, 1, 0.4> } }
union { box { <10, 10, -2>, <20, 20, 2> } cylinder { <10, 5, 0>, <20, 5, 0>, 2 } clipped_by { sphere { 0, 60 } } pigment { rgb <0.5, 0.6, 1> } }
cylinder { <-30, -5, 0>, <-20, -5, 0>, 3 pigment { rgb <1, 1, 0.4> } }
cone { <-10, -5, 0>, 3, <0, -5, 0>, 2 pigment { rgb <1, 0.4, 1> } }
quadric { <0, 1, 1>, 0, 0, -9 clipped_by { box { <10, -5, -5>, <20, 5, 5> } } translate -10*y pigment { rgb <0.4, 1, 1> } }
box { <-30, -25, -2>, <-20, -15, 2> pigment { rgb 0.8 } }
mesh { triangle { <-10, -25, 0>, <0, -25, 0>, <0, -15, 0> } triangle { <-10, -25, 0>, <0, -15, 0>, <-10, -15, 0> } pigment { rgb <1, 0.8, 0.6> } }
bicubic_patch { type 1 flatness 0 u_steps 2 v_steps 2
  #for (J, 0, 3) #for (I, 0, 3) <10 + 10*I/3, -25 + 10*J/3, 0> #if (I + J < 6) , #end #end #end
  pigment { rgb <0.6, 0.8, 1> } }
