#declare Glass = texture { finish { ambient 0 diffuse 0 reflection .25 refraction 1 ior 1.33 } pigment { color rgbf <1,1,1,.9> } }
sphere { 0, 1 texture { Glass } }
