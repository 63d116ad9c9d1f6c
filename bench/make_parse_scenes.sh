#!/usr/bin/env bash
# make_parse_scenes.sh FOLDER: the scenes of bench/parse that are made rather than kept.
set -euo pipefail
folder=$1
head='#version 3.7;\nglobal_settings { assumed_gamma 1 }\n'
here=$(cd "$(dirname "$0")" && pwd)
cp "$here/scenes/while_loop.pov" "$folder/while_loop.pov"
[ -s "$folder/mesh.pov" ] || bash "$here/make_mesh.sh" "$folder/mesh.pov"

printf "$head"'// A hundred thousand calls of a small macro.
#macro M(A, B)
  A*B + 1
#end
#declare S = 0;
#declare I = 0;
#while (I < 100000)
  #declare S = S + M(I, 2);
  #declare I = I + 1;
#end
#debug concat(str(S, 0, 0), "\\n")
sphere { 0, 1 }
' > "$folder/macro_calls.pov"

printf "$head"'// Fifty thousand copies of a declared object.
#declare Thing = union {
  sphere { 0, 1 }
  cylinder { 0, 2*y, 0.3 }
  box { <-1, -0.1, -1>, <1, 0.1, 1> }
  pigment { rgb <0.9, 0.6, 0.3> }
}
#declare I = 0;
#while (I < 50000)
  object { Thing rotate 7*I*y translate <mod(I, 250), 0, div(I, 250)> }
  #declare I = I + 1;
#end
' > "$folder/copies.pov"

awk -v head="$head" 'BEGIN {
  printf head; srand(1)
  print "// Two hundred thousand spheres, each with a colour of its own, as exporters write them."
  for (i = 0; i < 200000; ++i)
    printf "sphere { <%.4f, %.4f, %.4f>, %.4f pigment { rgb <%.3f, %.3f, %.3f> } }\n", rand()*100, rand()*100, rand()*100, rand(), rand(), rand(), rand()
}' > "$folder/spheres_200000.pov"

printf "$head"'// A user function of twenty operations, called half a million times.
#declare F = function(x, y, z) { (x*x + y*y - z*z)*(x - y + z) + x*y*z - (x + y)*(y + z)*(z + x) + x*2 - y*3 + z*x - y }
#declare S = 0;
#declare I = 0;
#while (I < 500000)
  #declare S = S + F(I*0.001, 0.5, 0.25);
  #declare I = I + 1;
#end
#debug concat(str(S, 0, 0), "\\n")
sphere { 0, 1 }
' > "$folder/function_loop.pov"
