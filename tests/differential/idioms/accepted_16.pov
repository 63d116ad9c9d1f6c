// RasMol
camera { location <300,300,-1500> sky -y right -x*image_width/image_height angle 11 look_at <300,300,0> }
#declare DensitySurface = 0;
object { light_source { <1,2,3> color rgb<1,1,1> } }
sphere { <-10.5, 22.5, 0.0> 5.0 texture { pigment { color red 0.78 green 0.78 blue 0.78 } finish { phong 1.0 } } }
