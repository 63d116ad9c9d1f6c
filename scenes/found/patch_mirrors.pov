// A patch that is a mirror, before a backdrop of grains of 1e-12, and one of glass: all bits of hits and normals show.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 3, -6> look_at <0, 0, 0> angle 40 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e12, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#declare Patch = bicubic_patch {
  type 1 flatness 0 u_steps 3 v_steps 3
  <-1.4, 0, -1.1> <-0.5, 0.7, -1.3> <0.4, -0.3, -1.2> <1.3, 0.2, -1.4>
  <-1.3, 0.4, -0.3> <-0.4, 1.1, -0.6> <0.6, 0.8, -0.4> <1.1, -0.6, -0.5>
  <-1.2, 0.1, 0.5> <-0.6, 0.9, 0.3> <0.3, 1.2, 0.4> <1.4, 0.5, 0.6>
  <-1.5, -0.2, 1.3> <-0.3, 0.4, 1.1> <0.5, -0.1, 1.4> <1.2, 0.7, 1.2>
}
object { Patch pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } rotate 20 * y translate -1.4 * x }
object { Patch pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 } rotate -50 * y translate 1.4 * x }
