// The words that begin an object, and who reads the statement (parser/scene/objects.h).
#pragma once

// X(word, reader): parse_reader reads it. The words are enumerators of Word.
#define VERISIM_OBJECT_STATEMENTS(X)  \
  X(bicubic_patch, bicubic_patch)     \
  X(blob, blob)                       \
  X(box, box)                         \
  X(composite, csg)                   \
  X(cone, cone)                       \
  X(cubic, poly)                      \
  X(cylinder, cylinder)               \
  X(difference, csg)                  \
  X(disc, disc)                       \
  X(height_field, height_field)       \
  X(intersection, csg)                \
  X(isosurface, isosurface)           \
  X(julia_fractal, julia_fractal)     \
  X(lathe, lathe)                     \
  X(light_group, light_group)         \
  X(light_source, light_source)       \
  X(merge, csg)                       \
  X(mesh, mesh)                       \
  X(mesh2, mesh2)                     \
  X(object, object_statement)         \
  X(ovus, ovus)                       \
  X(parametric, parametric)           \
  X(plane, plane)                     \
  X(poly, poly)                       \
  X(polygon, polygon)                 \
  X(polynomial, polynomial)           \
  X(prism, prism)                     \
  X(quadric, quadric)                 \
  X(quartic, poly)                    \
  X(smooth_triangle, smooth_triangle) \
  X(sor, sor)                         \
  X(sphere, sphere)                   \
  X(sphere_sweep, sphere_sweep)       \
  X(superellipsoid, superellipsoid)   \
  X(text, text)                       \
  X(torus, torus)                     \
  X(triangle, triangle)               \
  X(union_, csg)
