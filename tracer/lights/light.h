// Light sources ready for shading: direction, distance and intensity at a point, samples of area lights (spec 06
// sections 7 and 8).
#pragma once

#include <memory>

#include "tracer/lights/light_formulas.h"
#include "tracer/scene/light.h"
#include "tracer/shapes/shape.h"

namespace verisim::shading {

constexpr double kProjectorTolerance = 1e-4;  // from the shaded point to what the light is projected through
using shapes::kShadowTolerance;
// What blocks a light altogether counts from here on: POV-Ray's shadow cache, which asks the last blocker first, heeds
// no other limit, and the blocker of a point in a contact shadow is mostly that of the point before it (spec 06 9.2).
constexpr double kContactTolerance = 1e-4;
inline const double kAboveShadowTolerance = std::nextafter(kShadowTolerance, 1.0);

class Light {
 public:
  // `area_lights`: quality 5 and above; below, area lights shine from their centre. `projector`: the compiled
  // projected_through object, if any.
  Light(const scene::LightSource& source, bool area_lights, std::unique_ptr<shapes::Shape> projector = nullptr);

  const scene::LightSource& source() const { return *source_; }
  const Rgb& color() const { return source_->color; }
  bool area() const { return area_; }
  bool area_illumination() const { return source_->area_illumination; }
  bool highlights() const { return source_->kind != scene::LightKind::shadowless; }
  // Whether light can be blocked at all (quality permitting).
  bool shadows() const { return highlights() || projector_; }
  const shapes::Shape* projector() const { return projector_.get(); }
  bool media_attenuation() const { return source_->media_attenuation && source_->media_interaction; }

  // Direction and distance from p to the light's centre, displaced by `offset` for a sample of an area light.
  LightDirection direction(const Vec3& p, const Vec3& offset = Vec3(0, 0, 0)) const {
    const Vec3 centre = source_->position + offset;
    return radial_ ? radial_direction(centre - p) : fixed_direction(p, centre);
  }
  // If not, attenuation is 1 everywhere.
  bool attenuates() const { return attenuates_; }
  // Angular and distance attenuation at p for light from `l`. All samples of an area light shine along one cylinder.
  double attenuation(const Vec3& p, const LightDirection& l) const {
    return attenuates_ ? angle_and_distance(p, l) : 1;
  }

  // Into media an area light with area_illumination shines with all its strength (spec 06 8.3): where its cone or
  // cylinder is, everywhere.
  bool attenuates_air() const { return attenuates_ && !(area_ && area_illumination()); }

  // Of a spot light: where it shines with all its strength, and beyond which not at all.
  double cos_radius() const { return cos_radius_; }
  double cos_falloff() const { return cos_falloff_; }
  // The cosine below which it is less and less.
  double soft_below() const { return cos_radius_ > 0 ? cos_radius_ : -HUGE_VAL; }

  // Angular attenuation of what leaves the light from `origin` in this direction (photons); distance plays no part.
  double emission(const Vec3& origin, const Vec3& direction) const;

  // Light spreads from a point; if not, its direction is fixed.
  bool radial() const { return radial_; }
  // The direction towards the light is the same everywhere; if not, everything that shines lies in box().
  bool parallel() const { return parallel_; }
  // Empty: unknown.
  const Box3& box() const { return box_; }

  // The displacement of grid position (u, v), jitter included in u and v; axis1/axis2 from `axes`.
  struct Axes {
    Vec3 a1, a2;
  };
  Axes axes(const Vec3& towards_centre) const;  // `orient` turns them to the shaded point
  Vec3 offset(const Axes& axes, double u, double v) const;
  int size1() const { return source_->size1; }
  int size2() const { return source_->size2; }

 private:
  LightDirection fixed_direction(const Vec3& p, const Vec3& centre) const;
  double angle_and_distance(const Vec3& p, const LightDirection& l) const;
  // What part of the light goes from its centre to p, with distance aside.
  double profile(const Vec3& p, const LightDirection& l) const;
  double spot(const LightDirection& l) const;
  double cylinder(const Vec3& p) const;

  const scene::LightSource* source_;
  bool area_, parallel_;
  bool radial_;
  bool attenuates_;  // by angle or distance
  Box3 box_;
  double cos_radius_ = 0, cos_falloff_ = 0;
  std::unique_ptr<shapes::Shape> projector_;
};

}  // namespace verisim::shading
