#include "tracer/render/cameras/camera_rays.h"

#include "tracer/math/constants.h"
#include "tracer/math/transform.h"

namespace verisim::render {
namespace {

constexpr double kDegree = kPi / 180;

// Divided by its length, where other vectors are multiplied by its reciprocal.
Vec3 unit(const Vec3& v) {
  const double l = length(v);
  return {v.x / l, v.y / l, v.z / l};
}

}  // namespace

CameraRays::CameraRays(const scene::Camera& camera, int width, int height, WindowPlace window)
    : kind_(camera.kind),
      view_{static_cast<double>(width),
            static_cast<double>(height),
            static_cast<double>(window.left),
            static_cast<double>(window.top),
            camera.direction,
            camera.right,
            camera.up},
      location_(camera.location),
      unit_direction_(unit(camera.direction)),
      unit_right_(unit(camera.right)),
      unit_up_(unit(camera.up)),
      right_length_(length(camera.right)),
      up_length_(length(camera.up)),
      angle_(camera.angle),
      horizontal_(camera.horizontal_angle * kPi / 180),
      vertical_(camera.vertical_angle * kPi / 180),
      origin_varies_(kind_ == scene::CameraKind::orthographic || kind_ == scene::CameraKind::cylinder3 ||
                     kind_ == scene::CameraKind::cylinder4) {}

std::optional<PrimaryRay> CameraRays::at(double x, double y) const {
  using Kind = scene::CameraKind;
  const Vec2 place = view_.place(x, y);
  const double u = place.x, w = place.y;
  const double uc = u - 0.5, wc = w - 0.5, u2 = 2 * u - 1, w2 = 2 * w - 1;
  switch (kind_) {
    case Kind::perspective:
      return PrimaryRay{{location_, view_.through(place)}, {uc, wc}};
    case Kind::orthographic:
      return PrimaryRay{{location_ + uc * view_.right + wc * view_.up, view_.direction}, {uc, wc}};
    case Kind::fisheye:
      return fisheye(u2 * right_length_, w2 * up_length_);
    case Kind::ultra_wide_angle: {
      const double a = uc * (angle_ * kDegree), b = wc * (angle_ * (up_length_ / right_length_) * kDegree);
      return PrimaryRay{
          {location_, std::sin(a) * unit_right_ + std::sin(b) * unit_up_ + std::cos(a) * std::cos(b) * unit_direction_},
          {a, b}};
    }
    case Kind::omnimax:
      return omnimax(u2, w2);
    case Kind::panoramic: {
      const double phi = (1 - u) * kPi, psi = w2 * kPi / 2;
      const double tangent = std::fabs(kPi / 2 - std::fabs(psi)) < kEpsilon ? std::copysign(2e10, psi) : std::tan(psi);
      return PrimaryRay{{location_, std::cos(phi) * view_.right + tangent * view_.up + std::sin(phi) * view_.direction},
                        {phi, psi}};
    }
    case Kind::cylinder1: {
      const double phi = uc * (angle_ * kDegree);
      return PrimaryRay{
          {location_, std::sin(phi) * unit_right_ + wc * up_length_ * unit_up_ + std::cos(phi) * unit_direction_},
          {phi, wc * up_length_}};
    }
    case Kind::cylinder2: {
      const double phi = wc * (angle_ * kDegree);
      return PrimaryRay{
          {location_, uc * right_length_ * unit_right_ + std::sin(phi) * unit_up_ + std::cos(phi) * unit_direction_},
          {uc * right_length_, phi}};
    }
    case Kind::cylinder3: {
      const double phi = uc * (angle_ * kDegree);
      return PrimaryRay{
          {location_ + wc * up_length_ * unit_up_, std::sin(phi) * unit_right_ + std::cos(phi) * unit_direction_},
          {phi, wc * up_length_}};
    }
    case Kind::cylinder4: {
      const double phi = wc * (angle_ * kDegree);
      return PrimaryRay{
          {location_ + uc * right_length_ * unit_right_, std::sin(phi) * unit_up_ + std::cos(phi) * unit_direction_},
          {uc * right_length_, phi}};
    }
    case Kind::spherical: {
      const double horizontal = uc * horizontal_, vertical = wc * vertical_;
      const Vec3 raised = Transform::rotated(view_.direction, view_.right, -vertical);
      return PrimaryRay{{location_, Transform::rotated(raised, view_.up, horizontal)}, {horizontal, vertical}};
    }
    case Kind::mesh_camera:
      break;
  }
  return std::nullopt;
}

PrimaryRay CameraRays::round_ray(double phi, double theta) const {
  const double s = std::sin(theta);
  return {
      {location_, std::cos(phi) * s * unit_right_ + std::sin(phi) * s * unit_up_ + std::cos(theta) * unit_direction_},
      {phi, theta}};
}

std::optional<PrimaryRay> CameraRays::fisheye(double p, double q) const {
  const double rho = std::sqrt(p * p + q * q);
  if (rho > 1) return std::nullopt;
  if (rho == 0) return PrimaryRay{{location_, unit_direction_}, {0, 0}};
  const double theta = rho * angle_ / 2 * kDegree;
  double phi = std::asin(q / rho);
  if (p < 0) phi = kPi - phi;
  return round_ray(phi, theta);
}

std::optional<PrimaryRay> CameraRays::omnimax(double u2, double w2) const {
  constexpr double kAspect = 1.283458;
  const double s = right_length_ / up_length_;
  double p = u2, q;
  if (s > kAspect) {
    p = u2 * (s / kAspect), q = (w2 - 1) / kAspect + 1;
  } else if (s > 1) {
    q = (w2 - 1) / s + 1;
  } else {
    q = w2 / s;
  }
  const double rho = std::sqrt(p * p + q * q);
  if (rho > 1) return std::nullopt;
  if (rho == 0) return PrimaryRay{{location_, unit_direction_}, {0, 0}};
  const double theta = 1.411269 * rho - 0.09439 * rho * rho * rho + 0.25674 * rho * rho * rho * rho * rho;
  if (q / rho * std::sin(theta) < -std::cos(theta)) return std::nullopt;  // more than 45 degrees below the axis
  double phi = std::asin(q / rho);
  if (p < 0) phi = kPi - phi;
  return round_ray(phi, theta);
}

}  // namespace verisim::render
