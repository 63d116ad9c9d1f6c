// Fog and ground fog (spec 06 section 11.4).
#pragma once

#include <span>

#include "tracer/math/vec.h"
#include "tracer/scene/scene.h"

namespace verisim::shading {

constexpr double kMissDistance = 2e10;  // what fog and rainbows take for the length of a ray that hits nothing

// What fog does to light that comes along a segment: colour = added + passed() * colour.
struct FogEffect {
  Rgb added;
  Vec3 clear{1.0};  // of all fogs; in double precision, as in POV-Ray
  Rgb passed() const { return {static_cast<float>(clear.x), static_cast<float>(clear.y), static_cast<float>(clear.z)}; }
};
struct FogSegment {
  Ray ray;
  double length;
  FogEffect effect{};
};
// Sets the effects on at most textures::PointBatch::kMax segments.
void fog_along(std::span<const scene::Fog> fogs, int noise_generator, std::span<FogSegment> segments);
FogEffect fog_along(std::span<const scene::Fog> fogs, const Ray& ray, double length, int noise_generator);

// Mean density of ground fog between two heights, relative to its maximum.
double ground_fog_density(double start_height, double end_height, double offset, double altitude);

}  // namespace verisim::shading
