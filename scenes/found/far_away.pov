// Two planes as a polynomial, 15,000,000,000 away: hits from 20,000,000,000 on are none, so that they look round.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 direction z right 2.4*x up 1.8*y }
polynomial { 2, xyz(0, 0, 2): 1, xyz(0, 0, 0): -2.25e20 pigment { rgb <1, 0.5, 0.2> } finish { ambient 1 diffuse 0 } }
background { rgb 0.2 }
