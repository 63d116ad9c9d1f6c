// Snell: a ruler of brightness 0.25 + x / 8 seen through a slab of glass (n = 1.5, 1 thick) that is turned by 30 degrees. The slab moves a ray sideways by
// t sin(a) (1 - cos(a) / sqrt(n^2 - sin(a)^2)), so the ruler's brightness tells the angle.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 6*y direction -y right 4*x up 3*z }
plane {
  y, -4
  pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 8 translate -2*x }
  finish { ambient 0 diffuse 0 emission rgb 1 }
}
box { <-9, -0.5, -9>, <9, 0.5, 9> rotate 30*z pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
