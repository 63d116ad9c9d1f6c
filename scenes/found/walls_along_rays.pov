// Rays along walls of prisms, and by tips of conic ones: no wall is met where the ray's direction, crossed with the
// wall's edge, is at most 1e-10. Each square is a ray; the lower half are walls within CSG.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z up 12*y right 16*x }
light_source { <3, 4, -20>, 1 }
#declare Tip = prism { conic_sweep linear_spline -1, 0, 4 <0, 0>, <1, 0>, <1, 1>, <0, 0> }
#macro Wall(Length)
  prism { linear_spline -1, 0, 5 <0, 0>, <1, 0>, <1, Length>, <0, Length>, <0, 0> open }
#end
#macro Square(X, Y, Hit, Normal)
  box {
    <X - 0.2, Y - 0.4, -0.1>, <X + 0.2, Y + 0.4, 0.1>
    pigment { rgb <mod(vlength(Hit), 1), 0.5 + 0.4 * Normal.x, 0.5 + 0.4 * Normal.z> }
  }
#end
#macro Row(Y, Solid, Length)
  #local I = 0;
  #while (I < 32)
    #local E = pow(10, -9 - I / 16) / Length;
    #local N = <0, 0, 0>;
    #local H = trace(Solid, <1 + 3.5 * E, -0.5, -3 * Length>, <-E / Length, 0, 1>, N);
    Square(I / 2 - 7.75, Y, H, N)
    #local I = I + 1;
  #end
#end
#macro TipRow(Y, Solid, Factor)
  #local R = seed(Y * 100);
  #local I = 0;
  #while (I < 32)
    #local From = <rand(R) - 2, rand(R) - 1, -6>;
    #local N = <0, 0, 0>;
    #local H = trace(Solid, From, Factor * <-0.7, -1, -0.4> - From, N);
    Square(I / 2 - 7.75, Y, H, N)
    #local I = I + 1;
  #end
#end
#declare Around = sphere { 0, 100 }
Row(5, object { Wall(1) }, 1)
Row(4, object { Wall(10) }, 10)
Row(3, object { Wall(0.1) }, 0.1)
Row(2, object { Wall(1) scale <1, 1, 3> }, 1)
TipRow(1, Tip, 1e-9)
TipRow(0, Tip, 2e-10)
TipRow(-1, Tip, 0)
TipRow(-2, object { Tip scale 10 }, 2e-9)
Row(-3, intersection { object { Wall(1) } object { Around } }, 1)
Row(-4, intersection { object { Wall(10) } object { Around } }, 10)
Row(-5, intersection { object { Tip } object { Around } }, 1)
