#version 3.5;
#macro Tree(P, D, L, N)
  #if (N > 0)
    #local E = P + D*L;
    cone { P, L*.12, E, L*.08 }
    #local k = 0;
    #while (k < 3)
      #local V = vrotate(D, <25, 0, 0>);
      #local V = vaxis_rotate(V, D, k*120 + N*37);
      Tree(E, vnormalize(V + .2*y), L*.72, N-1)
      #local k = k + 1;
    #end
  #else
    sphere { P, .09 pigment { rgb <.2,.6,.2> } }
  #end
#end
union { Tree(<0,-1.5,0>, y, 1, 4) pigment { rgb <.5,.35,.2> } }
#macro Fact(n) #if (n <= 1) 1 #else (n*Fact(n-1)) #end #end
#macro Fib(n) #local r = 1; #if (n > 2) #local r = Fib(n-1) + Fib(n-2); #end r #end
#debug concat(str((Fact(6)),0,0), " ", str(Fib(12),0,0), "\n")
camera { location <0,.8,-5> look_at <0,.5,0> } light_source { <4,6,-6> rgb 1 }
