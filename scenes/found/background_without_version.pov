// Where no version is said, the transmit of a background does not fade it, as before 3.7.
camera { location <0, 2, -7> look_at 0 }
background { rgb <1, 0.8, 0.1> transmit 0.7 }
plane { y, -1 pigment { rgb 1 } finish { ambient 0.2 reflection 0.5 } }
