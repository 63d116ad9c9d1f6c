// Phase functions of scattering media (spec 07 4.4).
#include "tracer/media/media.h"

namespace verisim::global {

double phase(const scene::Media& media, double cosine) {
  const double half = 0.5 * (1.0 + cosine);
  switch (media.scattering_type) {
    case 2: {  // Mie, haze
      const double h2 = half * half, h4 = h2 * h2;
      return 0.576655375 * (1.0 + 9.0 * h4 * h4);
    }
    case 3: {  // Mie, murky
      const double h2 = half * half, h4 = h2 * h2, h8 = h4 * h4, h16 = h8 * h8;
      return 0.495714547 * (1.0 + 50.0 * h16 * h16);
    }
    case 4:  // Rayleigh
      return 0.799372013 * (1.0 + cosine * cosine);
    case 5: {  // Henyey-Greenstein
      const double e = media.eccentricity;
      const double d = 1.0 + e * e - 2.0 * e * cosine;
      return (1.0 - e * e) / (d * std::sqrt(d));
    }
    default:
      return 1.0;
  }
}

bool phase_is_constant(const scene::Media& media) { return media.scattering_type < 2 || media.scattering_type > 5; }

}  // namespace verisim::global
