// Where a warp has no place for a point, the first entry of a map is found: the origin unfolded as a cube, the ring
// of a torus; a `mesh2` without uv_vectors is at the origin all over (spec 05 6).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -8> direction z right 4 * x up 3 * y }
#default { finish { ambient 1 diffuse 0 } }
#declare Three = pigment { planar color_map { [0 rgb <0.9, 0.4, 0.1>] [0.4 rgb <0.2, 0.8, 0.3>] [1 rgb <0.2, 0.3, 0.9>] } }
mesh2 {
  vertex_vectors { 3, <-1.9, 0.2, 0>, <-0.2, 0.2, 0>, <-1, 1.4, 0> }
  face_indices { 1, <0, 1, 2> }
  texture { uv_mapping pigment { Three warp { cubic } } }
}
mesh2 {
  vertex_vectors { 3, <0.2, 0.2, 0>, <1.9, 0.2, 0>, <1, 1.4, 0> }
  face_indices { 1, <0, 1, 2> }
  texture { uv_mapping pigment { Three translate x warp { toroidal } translate -x } }
}
// Tiles beyond 2^24 are told apart by twos.
plane {
  z, 0
  pigment { checker rgb <0.9, 0.8, 0.2> rgb <0.2, 0.2, 0.5> scale 0.1 warp { repeat 3 * x flip x } translate 1e8 * x }
  translate 1e-3 * z
}
