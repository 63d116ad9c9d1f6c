#version 3.0
#declare X = 3
#declare Y = X*2
#while (X > 0) sphere { <X,0,0>, .5 } #declare X = X-1 #end
