// Reads the 267 numbers of POV-Ray's lattice noise ("value table") out of the running program (see README.md).
//
// Idea: at a lattice point all weights but one vanish, so noise generator 1 shows R[b]/2 + 1/2 of the byte b to which the hash maps that point,
// and turbulence with one octave (the vector noise) shows R[b+4]/2 and R[b+8]/2. Half-way between two lattice points the slopes R[b+1..3] show.
#version 3.7;

// The hash: a permutation of 0..4095 shuffled by a linear congruential generator, s = (1812433253 s + 12345) mod 2^32.
#declare T = array[4096];
#declare I = 0;
#while (I < 4096) #declare T[I] = I; #declare I = I + 1; #end
#declare S = 0;
#macro NextState()  // in two halves of 16 bits, because SDL computes in doubles
  #local Low = mod(S, 65536);
  #local High = (S - Low) / 65536;
  #local Product = mod(High * mod(1812433253, 65536) + Low * div(1812433253, 65536), 65536) * 65536 + Low * mod(1812433253, 65536) + 12345;
  #declare S = mod(Product, 4294967296);
#end
#declare I = 4095;
#while (I >= 0)
  NextState()
  #local J = mod(div(S, 65536), 4096);
  #local Q = T[I]; #declare T[I] = T[J]; #declare T[J] = Q;
  #declare I = I - 1;
#end
#macro LatticeByte(X, Y, Z)  // coordinates >= -10000
  #local U = T[bitwise_xor(T[mod(X + 10000, 4096)], mod(Y + 10000, 4096))];
  mod(T[bitwise_xor(U, mod(Z + 10000, 4096))], 256)
#end

// A lattice point for every byte.
#declare PX = array[256]
#declare PY = array[256]
#declare PZ = array[256]
#declare Found = array[256]
#declare I = 0; #while (I < 256) #declare Found[I] = 0; #declare I = I + 1; #end
#declare N = 0;
#declare X = -7;
#while (X < 8 & N < 256)
  #declare Y = -7;
  #while (Y < 8)
    #declare Z = -7;
    #while (Z < 8)
      #local K = LatticeByte(X, Y, Z);
      #if (Found[K] = 0)
        #declare Found[K] = 1; #declare PX[K] = X; #declare PY[K] = Y; #declare PZ[K] = Z; #declare N = N + 1;
      #end
      #declare Z = Z + 1;
    #end
    #declare Y = Y + 1;
  #end
  #declare X = X + 1;
#end

#declare Noise = function { internal(78) }
#declare ShiftY = function { pattern { function { y/32 + 0.5 } warp { turbulence y octaves 1 } } }
#declare ShiftZ = function { pattern { function { z/32 + 0.5 } warp { turbulence z octaves 1 } } }
#macro R(I) (2*Noise(PX[I], PY[I], PZ[I], 1) - 1) #end

#fopen F "table.txt" write
#declare I = 0;
#while (I < 256) #write(F, str(R(I), 0, 9), "\n") #declare I = I + 1; #end
#declare I = 252;  // entries 256 .. 259
#while (I < 256) #write(F, str(2*((ShiftY(PX[I], PY[I], PZ[I]) - 0.5)*32 - PY[I]), 0, 9), "\n") #declare I = I + 1; #end
#declare I = 252;  // entries 260 .. 263
#while (I < 256) #write(F, str(2*((ShiftZ(PX[I], PY[I], PZ[I]) - 0.5)*32 - PZ[I]), 0, 9), "\n") #declare I = I + 1; #end
#declare A = 0;
#while (A < 3)  // entries 264 .. 266: slopes of the last byte
  #local V = <select(A, 0, 1, 0), select(A - 1, 0, 1, 0), select(A - 2, 0, 1, 0)>;
  #local C = <PX[255], PY[255], PZ[255]>;
  #local Middle = C + V/2;
  #local End = C + V;
  #local K = LatticeByte(End.x, End.y, End.z);
  #local W = (ShiftZ(Middle.x, Middle.y, Middle.z) - 0.5)*32 - Middle.z;
  #local U = (W - 0.5*(0.5*R(K + 8) - 0.5*R(K + 9 + A)))/0.5;
  #local R263 = 2*((ShiftZ(C.x, C.y, C.z) - 0.5)*32 - C.z);
  #write(F, str((U - 0.5*R263)/0.5, 0, 9), "\n")
  #declare A = A + 1;
#end
#fclose F
