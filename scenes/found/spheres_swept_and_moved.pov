// Linear sphere_sweeps beside copies and cones in the same place, and mirrors of a moved ovus before grains: last bits.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -9> rgb 1 }
box {
  -20, 20
  pigment { function { mod(abs(x + y + z) * 1e11, 1) > 0.5 } color_map { [0 rgb 0.2] [1 rgb 0.8] } }
  finish { ambient 1 diffuse 0 }
}
#declare Branch = sphere_sweep { linear_spline 3, <-1.1, -1, 0>, 0.45, <-0.4, 0.2, 0.3>, 0.3, <0.7, 1.1, 0>, 0.2 }
object { Branch translate -1.2 * x pigment { rgb <0.9, 0.3, 0.2> } }
object { Branch translate -1.2 * x pigment { rgb <0.2, 0.6, 0.9> } }
sphere_sweep {
  linear_spline 2, <-0.7, 0.3, 0>, 0.4, <0.8, 0.2, 0.1>, 0.25
  rotate <10, 20, 30> translate <1.2, 0.8, 0>
  pigment { rgb 0 } finish { reflection 1 }
}
ovus { 0.6, 0.35 rotate <10, 20, 30> translate <1.2, -0.9, -0.5> pigment { rgb 0 } finish { reflection 1 } }
sphere_sweep { linear_spline 2, -x, 0.3, x, 0.3 scale <0.5, 1, 0.7> translate <-0.3, -1, -1.2> pigment { rgb 0 } finish { reflection 1 } }
