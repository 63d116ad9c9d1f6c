#version 3.0
#declare Glass = texture { finish { ambient 0 diffuse 0 reflection .25 refraction on ior 1.33 caustics .5 fade_distance 1 fade_power 2 } pigment { color rgbf <1,1,1,.9> } }
sphere { 0, 1 texture { Glass } }
