# version 3.7 ;
# declare A = 1 ;
#declare B=2;#declare C=3;;
sphere { A B }
