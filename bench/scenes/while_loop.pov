// A loop of a million turns: the cost of executing the language.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 0;
#declare Sum = 0;
#while (I < 1000000)
  #declare Sum = Sum + I * 0.5;
  #declare I = I + 1;
#end
#debug concat(str(Sum, 0, 0), "\n")
sphere { 0, 1 }
