#!/usr/bin/env bash
# make_mesh.sh FILE [ACROSS ALONG]: a scene with one mesh2, a wavy torus-like sheet of ACROSS by ALONG quads; 500 by 200, 200,000 triangles, if not said.
set -euo pipefail
awk -v across="${2:-500}" -v along="${3:-200}" 'BEGIN {
  pi = atan2(0, -1)
  print "// One mesh2 of " 2 * across * along " triangles; made by bench/make_mesh.sh."
  print "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 9, -12> look_at 0 angle 40 }"
  print "light_source { <-20, 30, -20> rgb 0.8 }\nlight_source { <30, 20, -10> rgb 0.4 }\nbackground { rgb <0.1, 0.1, 0.2> }"
  print "mesh2 {\n  vertex_vectors {\n    " across * along ","
  for (i = 0; i < across; ++i)
    for (j = 0; j < along; ++j) {
      u = 2 * pi * i / across; v = 2 * pi * j / along; r = 1 + 0.1 * sin(9 * u) * cos(5 * v)
      printf "    <%.6f, %.6f, %.6f>,\n", (3 + r * cos(v)) * cos(u), r * sin(v), (3 + r * cos(v)) * sin(u)
    }
  print "  }\n  face_indices {\n    " 2 * across * along ","
  for (i = 0; i < across; ++i)
    for (j = 0; j < along; ++j) {
      a = i * along + j; b = (i + 1) % across * along + j; c = (i + 1) % across * along + (j + 1) % along; d = i * along + (j + 1) % along
      printf "    <%d, %d, %d>, <%d, %d, %d>,\n", a, b, c, a, c, d
    }
  print "  }\n  pigment { rgb <0.9, 0.6, 0.3> }\n  finish { phong 0.5 }\n}"
}' > "$1"
