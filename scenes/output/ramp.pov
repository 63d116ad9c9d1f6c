// Ramps of grey and of colour, some darker than black and some brighter than white: gamma, bits, dithering
camera { orthographic location -z direction z right 4*x up 3*y }
plane { -z, 0
  pigment {
    function { (x + 2)/4 }
    pigment_map {
      [0 gradient y color_map { [0 rgb -0.1] [1 rgb 0.3] } translate -0.5*y scale 3]
      [0.5 gradient y color_map { [0 rgb <0.5, 0.1, 0>] [1 rgb <0, 0.2, 0.6>] } translate -0.5*y scale 3]
      [1 gradient y color_map { [0 rgb 0] [1 rgb <1.2, 1.1, 0.9>] } translate -0.5*y scale 3]
    }
  }
  finish { ambient 1 diffuse 0 }
}
