// The caustic of a glass sphere (n = 1.5) of radius 1 in parallel light, on a plane 1.1 below its middle: each ray is refracted twice, and the light of the
// ring between two of them falls on the ring where they arrive.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 photons { count 400000 gather 20, 100 } }
// Seen from above without perspective: pixel (i, j) of W x H shows x = 4 ((i + 0.5) / W - 0.5), z = 3 (0.5 - (j + 0.5) / H).
camera { orthographic location 0.05*y direction -y right 4*x up 3*z }

light_source { 9*y, rgb 0.5 parallel point_at 0 photons { refraction on reflection off } }
sphere { 1.1*y, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } photons { target refraction on reflection off collect off } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
