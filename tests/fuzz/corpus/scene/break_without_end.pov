#switch (1) #case (1) sphere { 0, 1 } #break #else
