// Rays that start from a surface after it has taken a sample of radiosity need the importance that the sample's last ray
// needed: mirrors of camera rays and of gathered ones lose what is of less (spec 07 2.6).
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 35 recursion_limit 2 } }
camera { location <0, 0.5, -4> look_at 0 }
light_source { <5, 5, -5>, 1 }
sphere { <-0.6, 0, 0>, 0.9 pigment { rgb x } finish { reflection 0.4 } }
box { <0.6, -0.8, -0.4>, <1.6, 0.4, 0.6> pigment { rgbt <1, 1, 1, 0.5> } finish { reflection 0.2 } radiosity { importance 0.8 } }
plane { y, -1 pigment { rgb 1 } radiosity { importance 0.4 } }
