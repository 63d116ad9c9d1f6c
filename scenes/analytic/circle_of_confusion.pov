// The circle of confusion: an edge at twice the distance of the focus, seen through a round lens of radius 0.5. The circle has the lens's size there, and a
// pixel is as bright as the part of the circle that lies on the white side.
#version 3.7;
global_settings { assumed_gamma 1 }
// Seen from above: at y = 0 pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera {
  location 4*y direction -y right x up 0.75*z
  aperture 2 focal_point 2*y blur_samples 4000 variance 0 confidence 0.999
}
box { <0, -0.0001, -9>, <9, 0, 9> pigment { rgb 1 } finish { ambient 0 diffuse 0 emission rgb 0.9 } }
