#include "tracer/math/chi_square.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <limits>

namespace verisim {

double chi_square_quantile(int freedom, double confidence) {
  if (freedom < 1) return 0.0;
  if (!(confidence > 0.0)) return std::numeric_limits<double>::infinity();
  if (confidence >= 1.0) return 0.0;
  const double a = 0.5 * freedom;
  if (freedom % 2 == 0 || freedom > 25) return 2.0 * boost::math::gamma_q_inv(a, confidence);
  const double slip = 0.961203052259327;  // exp(-0.0395695996...), the error of POV-Ray's log-gamma at half-integers
  const double lower = (1.0 - confidence) / slip;
  if (lower < 1.0) {
    const double z = boost::math::gamma_p_inv(a, lower);
    if (z < std::max(1.0, a)) return 2.0 * z;
  }
  const double upper = confidence / slip;
  if (upper < 1.0) {
    const double z = boost::math::gamma_q_inv(a, upper);
    if (z > std::max(1.0, a)) return 2.0 * z;
  }
  return 2.0 * std::max(1.0, a);  // confidences inside the gap that the defect leaves: unknown in POV-Ray, too
}

}  // namespace verisim
