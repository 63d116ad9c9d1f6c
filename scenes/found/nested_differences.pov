// Solids with a bite taken out, a hundred times over: more parts than most CSG objects have, one within another. One
// of the two is glass; merges and intersections lie between.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -24> look_at <0, 0, 0> angle 50 }
light_source { <20, 40, -30>, rgb 1 }
light_source { <-20, 10, -30>, rgb <0.3, 0.4, 0.5> }
background { rgb <0.2, 0.25, 0.3> }
plane { y, -6 pigment { checker rgb 0.8, rgb <0.3, 0.4, 0.6> scale 2 } }

#macro Bitten(N)
  #local Solid = sphere { 0, 5 }
  #for (Level, 1, N)
    #local Angle = 2.4 * Level;
    #local At = <5 * cos(Angle), 10 * (Level - 0.5) / N - 5, -5 * abs(sin(Angle))>;
    #if (mod(Level, 30) = 0)
      #local Solid = merge { object { Solid } sphere { 0.8 * At, 0.5 } }
    #else
      #if (mod(Level, 17) = 0)
        #local Solid = intersection { object { Solid } box { -4.9, 4.9 rotate Level * y } }
      #else
        #local Solid = difference { object { Solid } sphere { At, 4 / sqrt(N) } }
      #end
    #end
  #end
  Solid
#end

object { Bitten(100) pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } translate -6 * x }
object { Bitten(60) pigment { rgbf <0.9, 1, 0.95, 0.8> } finish { reflection 0.2 } interior { ior 1.3 } translate 6 * x }
