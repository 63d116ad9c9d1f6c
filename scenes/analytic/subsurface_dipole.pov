// Subsurface scattering: a thick slab without a refracting surface, evenly lit from above. Of the light the dipole of Jensen, Marschner, Levoy and Hanrahan
// (2001) returns rho, the colour of the surface, which its reduced albedo a is chosen for; single scattering adds a / 24. The colour grows with x.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 1500, 200 } }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 4*y direction -y right 4*x up 3*z }

light_source { 9*y, rgb 0.8 parallel point_at 0 }
box {
  <-40, -40, -40>, <40, 0, 40>
  pigment { gradient x color_map { [0 rgb <0.10, 0.85, 0.5>] [1 rgb <0.90, 0.15, 0.5>] } scale 4 translate -2*x }
  finish { ambient 0 diffuse 1 subsurface { translucency 0.3 } }
  interior { ior 1 }
}
