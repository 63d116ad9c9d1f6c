// 10,000 random spheres lit by two lights that cast shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -30> look_at 0 angle 45 }
light_source { <-40, 50, -40> rgb 0.7 }
light_source { <50, 20, -30> rgb 0.5 }
background { rgb <0.1, 0.1, 0.2> }
#declare R = seed(1);
#declare I = 0;
#while (I < 10000)
  sphere {
    <rand(R) * 24 - 12, rand(R) * 24 - 12, rand(R) * 24 - 12>, 0.05 + 0.2 * rand(R)
    pigment { rgb <rand(R), rand(R), rand(R)> }
  }
  #declare I = I + 1;
#end
