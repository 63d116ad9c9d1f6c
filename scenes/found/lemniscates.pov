// Quartics that leave the quadratic's company only far away: along most rays the leading coefficient nearly vanishes,
// and what is left of it is rounding, term by term in POV-Ray's order (spec 08 N).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 35 }
light_source { <-20, 30, -40>, 1 }
plane { y, -1.4 pigment { checker rgb 0.7 rgb 0.5 } }
#declare Lemniscate = quartic {
  <1, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0>
  bounded_by { sphere { 0, 2.01 } }
  pigment { rgb <0.8, 0.4, 0.3> }
}
object { Lemniscate rotate 45 * z }
object { Lemniscate rotate -45 * z }
object { Lemniscate rotate 90 * y }
