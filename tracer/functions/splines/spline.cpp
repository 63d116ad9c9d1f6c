// Evaluation of spline{} (spec 01 section 14).
#include "tracer/functions/splines/spline.h"

#include <algorithm>

namespace verisim {

namespace {

using Value = Spline::Value;

// The straight line through (t0, a) and (t1, b).
Value line(double t, double t0, const Value& a, double t1, const Value& b) {
  const double w = (t - t0) / (t1 - t0);
  Value r{};
  for (std::size_t k = 0; k < r.size(); ++k) r[k] = (1 - w) * a[k] + w * b[k];
  return r;
}

}  // namespace

void Spline::insert(double t, const Value& value, int terms) {
  const int used = std::clamp(terms, 0, 5);
  for (int k = 0; k < used; ++k) last_[static_cast<std::size_t>(k)] = value[static_cast<std::size_t>(k)];
  terms_ = std::max(terms_, used);
  curvature_ = nullptr;
  const auto at = std::lower_bound(points_.begin(), points_.end(), t, [](const Point& p, double s) { return p.t < s; });
  if (at != points_.end() && at->t == t) {
    // A repeated parameter replaces the earlier point, except the last one, which stays.
    if (at + 1 != points_.end()) at->value = last_;
    return;
  }
  points_.insert(at, Point{t, last_});
}

Spline::Value Spline::evaluate(double t, Kind kind) const {
  const std::size_t n = points_.size();
  if (n == 0) return {};
  if (n == 1) return points_[0].value;
  const auto& p = points_;
  if (kind == Kind::cubic) {
    if (n == 2) {
      Value r{};
      for (std::size_t k = 0; k < r.size(); ++k) r[k] = (p[0].value[k] + p[1].value[k]) / 2;
      return r;
    }
    if (!(t > p[1].t)) return p[1].value;
    if (t > p[n - 2].t) return p[n - 2].value;
  } else {
    if (!(t > p[0].t)) return p[0].value;
    if (t >= p[n - 1].t) return p[n - 1].value;
  }
  // The segment's end: the first point with t <= its parameter.
  const auto e = static_cast<std::size_t>(
      std::lower_bound(p.begin(), p.end(), t, [](const Point& q, double s) { return q.t < s; }) - p.begin());
  const Point &a = p[e - 1], &b = p[e];
  const double h = b.t - a.t;
  Value r{};
  switch (n == 2 ? Kind::linear : kind) {
    case Kind::linear:
      return line(t, a.t, a.value, b.t, b.value);
    case Kind::quadratic: {
      const std::size_t first = e >= 2 ? e - 2 : 0;
      const Point &q0 = p[first], &q1 = p[first + 1], &q2 = p[first + 2];
      const double l0 = (t - q1.t) * (t - q2.t) / ((q0.t - q1.t) * (q0.t - q2.t));
      const double l1 = (t - q0.t) * (t - q2.t) / ((q1.t - q0.t) * (q1.t - q2.t));
      const double l2 = (t - q0.t) * (t - q1.t) / ((q2.t - q0.t) * (q2.t - q1.t));
      for (std::size_t k = 0; k < r.size(); ++k) r[k] = l0 * q0.value[k] + l1 * q1.value[k] + l2 * q2.value[k];
      return r;
    }
    case Kind::cubic: {
      // Multiplied from left to right, as POV-Ray does: the last digits hang on it.
      const double w = (t - a.t) / h, w2 = w * w, w3 = w2 * w;
      const double at_a = 2 * w * w * w - 3 * w * w + 1, at_b = 3 * w * w - 2 * w * w * w;
      const auto slope = [&](std::size_t j, std::size_t k) {
        return 0.5 * ((p[j].value[k] - p[j - 1].value[k]) / (p[j].t - p[j - 1].t) +
                      (p[j + 1].value[k] - p[j].value[k]) / (p[j + 1].t - p[j].t));
      };
      for (std::size_t k = 0; k < r.size(); ++k) {
        r[k] = a.value[k] * at_a + b.value[k] * at_b + h * slope(e - 1, k) * (w3 - 2 * w2 + w) +
               h * slope(e, k) * (w3 - w2);
      }
      return r;
    }
    case Kind::natural: {
      const auto curvature = natural_curvature();
      const Value &m0 = (*curvature)[e - 1], &m1 = (*curvature)[e];
      const double s = t - a.t;
      for (std::size_t k = 0; k < r.size(); ++k) {
        const double linear = (b.value[k] - a.value[k]) / h - h * (m1[k] + 2 * m0[k]) / 6;
        r[k] = a.value[k] + s * (linear + s * (m0[k] / 2 + s * (m1[k] - m0[k]) / (6 * h)));
      }
      return r;
    }
  }
  return r;
}

std::shared_ptr<const std::vector<Spline::Value>> Spline::natural_curvature() const {
  if (auto known = std::atomic_load(&curvature_)) return known;
  const auto& p = points_;
  // Thomas algorithm for h_i M_{i-1} + 2 (h_i + h_{i+1}) M_i + h_{i+1} M_{i+1} = 6 (slope difference), M = 0 at both
  // ends.
  const std::size_t n = p.size();
  auto result = std::make_shared<std::vector<Value>>(n, Value{});
  auto& m = *result;
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double h0 = p[i].t - p[i - 1].t, h1 = p[i + 1].t - p[i].t;
    const double pivot = 2 * (h0 + h1) - h0 * upper[i - 1];
    upper[i] = h1 / pivot;
    for (std::size_t k = 0; k < m[i].size(); ++k) {
      const double right = 6 * ((p[i + 1].value[k] - p[i].value[k]) / h1 - (p[i].value[k] - p[i - 1].value[k]) / h0);
      m[i][k] = (right - h0 * m[i - 1][k]) / pivot;
    }
  }
  for (std::size_t i = n < 3 ? 0 : n - 2; i > 0; --i) {
    for (std::size_t k = 0; k < m[i].size(); ++k) m[i][k] -= upper[i] * m[i + 1][k];
  }
  std::atomic_store(&curvature_, std::shared_ptr<const std::vector<Value>>(result));
  return result;
}

}  // namespace verisim
