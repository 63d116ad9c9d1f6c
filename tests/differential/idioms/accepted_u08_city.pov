#version 3.1;
#include "colors.inc"
#include "textures.inc"
// City generator idiom
#declare buildings_per_block = <3, 0, 2>;
#declare block_size = <10,0,8>;
#declare block_count = <2,0,2>;
#declare street_width = 3;
#declare pavement_width = .6;
#declare city_seed = seed(123);
#declare building_types = 3;
#declare building_1 = box { <0,0,0>, <1,1,1> texture { pigment { brick color Gray75, color rgb <.6,.2,.1> scale .02 } } }
#declare building_2 = union { box { 0, 1 } cylinder { <.5,1,.5>, <.5,1.2,.5>, .2 } pigment { White } }
#declare building_3 = difference { box { 0,1 } #declare q=0; #while (q<4) box { <.1+q*.2,.1,-.1>, <.2+q*.2,.9,.02> } #declare q=q+1; #end texture { pigment { Gray50 } finish { Metal } } }
#declare BX = 0;
#while (BX < block_count.x)
 #declare BZ = 0;
 #while (BZ < block_count.z)
  #declare NX = 0; #while (NX < buildings_per_block.x)
   #declare NZ = 0; #while (NZ < buildings_per_block.z)
    #declare H = 2 + rand(city_seed)*6;
    #declare T = int(rand(city_seed)*building_types)+1;
    object {
     #switch (T) #case (1) building_1 #break #case (2) building_2 #break #case (3) building_3 #break #end
     scale <block_size.x/buildings_per_block.x*.8, H, block_size.z/buildings_per_block.z*.8>
     translate <BX*(block_size.x+street_width) + NX*block_size.x/buildings_per_block.x, 0, BZ*(block_size.z+street_width) + NZ*block_size.z/buildings_per_block.z>
    }
   #declare NZ = NZ+1; #end
  #declare NX = NX+1; #end
 #declare BZ = BZ+1; #end
#declare BX = BX+1; #end
plane { y, 0 pigment { Gray25 } }
sky_sphere { pigment { gradient y color_map { [0 color LightBlue][1 color Blue] } } }
light_source { <-100,150,-80> White }
camera { location <-8,14,-18> look_at <10,2,8> }
