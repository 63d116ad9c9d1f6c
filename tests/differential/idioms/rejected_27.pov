#version 3.1;
#declare I = 0;
#switch (I) #case (0) #debug "zero\n" #break #else #debug "other\n" #end
#fopen F "tmp_out.txt" write
#write (F, "a", 1, <1,2,3>, "\n")
#fclose F
height_field { gif "plasma2.gif" smooth }
