#include "tracer/math/bernstein.h"

namespace verisim {

int bernstein_roots(int degree, const double* power, double a, double b, double* roots, int limit) {
  switch (degree) {
    case 1:
      return bernstein_roots<1>(power, a, b, roots, limit);
    case 2:
      return bernstein_roots<2>(power, a, b, roots, limit);
    case 3:
      return bernstein_roots<3>(power, a, b, roots, limit);
    case 4:
      return bernstein_roots<4>(power, a, b, roots, limit);
    case 5:
      return bernstein_roots<5>(power, a, b, roots, limit);
    case 6:
      return bernstein_roots<6>(power, a, b, roots, limit);
    case 7:
      return bernstein_roots<7>(power, a, b, roots, limit);
    case 8:
      return bernstein_roots<8>(power, a, b, roots, limit);
    case 9:
      return bernstein_roots<9>(power, a, b, roots, limit);
    case 10:
      return bernstein_roots<10>(power, a, b, roots, limit);
    case 11:
      return bernstein_roots<11>(power, a, b, roots, limit);
    case 12:
      return bernstein_roots<12>(power, a, b, roots, limit);
    default:
      return 0;
  }
}

}  // namespace verisim
