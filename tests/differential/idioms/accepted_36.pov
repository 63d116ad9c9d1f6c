#if (version < 3.5) #version 3.1; #else #version 3.5; #end
sphere { 0, 1 pigment { rgb 1 } normal { bumps 1 } no_shadow }
