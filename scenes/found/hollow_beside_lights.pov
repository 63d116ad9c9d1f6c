// What is hollow is the interior that parts of CSG share, and the last of them decides; but lights do not, and of those
// with a looks_like what they look like (spec 06 6.1).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -3 * z right 16 * x up 12 * y look_at 0 }
fog { distance 15 color rgb <0.2, 0.5, 0.9> }
#declare Clear = pigment { rgbt 1 }
#declare Hollow = sphere { 0, 1.8 hollow pigment { Clear } }
#declare Solid = sphere { 0, 1.8 pigment { Clear } }
#declare Lamp = light_source { 50 * z, 0 }
#declare HollowLamp = light_source { 50 * z, 0 looks_like { sphere { 0, 1 hollow pigment { Clear } } } }
#declare SolidLamp = light_source { 50 * z, 0 looks_like { sphere { 0, 1 pigment { Clear } } } }
union { object { Hollow } light_source { Lamp } translate <-6, 4, 0> }
union { object { Solid } light_source { Lamp } translate <-2, 4, 0> }
union { object { Hollow } light_source { Lamp } bounded_by { sphere { 0, 2 } } translate <2, 4, 0> }
difference { object { Hollow } light_source { Lamp } translate <6, 4, 0> }
union { object { Hollow } light_source { SolidLamp } translate <-6, 0, 0> }
union { object { Solid } light_source { HollowLamp } translate <-2, 0, 0> }
union { object { Hollow } union { light_source { Lamp } light_source { Lamp } } translate <2, 0, 0> }
#declare Projector = light_source { 50 * z, 0 projected_through { sphere { 40 * z, 1 } } }
union { object { Hollow } light_source { Projector } translate <6, 0, 0> }
merge { object { Hollow } union { } translate <-6, -4, 0> }
light_group { object { Hollow } light_source { 50 * z, 0 } translate <-2, -4, 0> }
union { object { Hollow } object { Solid translate 50 * z } light_source { Lamp } translate <2, -4, 0> }
union { object { Solid } light_source { Lamp } hollow translate <6, -4, 0> }
plane { -z, -3 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
