#version 3.1;
global_settings { assumed_gamma 1 }
#declare galaxy_seed = seed(77);
#declare galaxy_colour1 = color rgb <.4,.6,1>;
#declare galaxy_colour2 = colour red 1 green .5 blue .3;
#ifdef (galaxy_rotate) #else #declare galaxy_rotate = <0, 30, 0>; #end
#declare StarBG = union {
  #declare c = 0; #while (c < 60)
   #declare p = vnormalize(<rand(galaxy_seed)-.5, rand(galaxy_seed)-.5, rand(galaxy_seed)-.5>);
   triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> scale 0.5+rand(galaxy_seed)*2 translate z*1000
     rotate <degrees(asin(p.y)), degrees(atan2(p.x, p.z+0.000001)), 0>
     pigment { color rgb (galaxy_colour1*rand(galaxy_seed) + galaxy_colour2*rand(galaxy_seed)) } finish { ambient 1 diffuse 0 } }
   #declare c = c + 1;
  #end
}
object { StarBG rotate galaxy_rotate }
sphere { 0, 1 hollow pigment { color rgbt 1 } no_shadow
  interior { media { emission rgb 0.5 intervals 5 samples 2, 5 confidence 0.9 variance 1/128
     density { spherical ramp_wave color_map { [0 rgb 0] [.4 galaxy_colour2*.3] [1 rgb 1] } }
     density { spiral2 3 turbulence .3 rotate x*90 scale .5 color_map { [0 rgb .1][1 galaxy_colour1] } } } }
  scale <60,20,60> translate z*300 rotate x*20 }
camera { location 0 direction z*1.5 }
