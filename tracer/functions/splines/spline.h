// SDL's spline{}: 1 to 5 component curves over a parameter (spec 01 section 14).
#pragma once

#include <array>
#include <memory>
#include <vector>

namespace verisim {

class Spline {
 public:
  enum class Kind : unsigned char { linear, quadratic, cubic, natural };
  using Value = std::array<double, 5>;

  void set_kind(Kind kind) { kind_ = kind; }
  Kind kind() const { return kind_; }
  // Inserts a point; components beyond `terms` keep those of the previously inserted point (spec 01 section 14).
  void insert(double t, const Value& value, int terms);
  int terms() const { return terms_; }
  bool empty() const { return points_.empty(); }
  Value evaluate(double t) const { return evaluate(t, kind_); }
  Value evaluate(double t, Kind kind) const;

 private:
  struct Point {
    double t;
    Value value;
  };
  Kind kind_ = Kind::linear;
  int terms_ = 2;
  Value last_{};
  std::vector<Point> points_;  // sorted by t
  // Second derivatives of the natural spline at the points, made by the first natural evaluation after an insertion
  // (any thread may do it).
  mutable std::shared_ptr<const std::vector<Value>> curvature_;
  std::shared_ptr<const std::vector<Value>> natural_curvature() const;
};

}  // namespace verisim
