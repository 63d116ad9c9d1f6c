// Primitives that answer for eight rays at once: both questions about a packet go through one function of the shape.
#pragma once

#include "tracer/shapes/packet_kernels.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

// A shape whose kernel finds the nearest hit of every ray by itself. It writes
//   void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const;
// and may write `point_of`. With clips and bounds of its own it is asked as a tree
// of CSG.
template <class Derived>
class KernelPrimitive : public Primitive<Derived> {
 public:
  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (guarded_) return Primitive<Derived>::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    PacketHits met;
    derived().meet(rays, t_min, t_max, met);
    return take_hits(met, rays, *this, hits, [&](int k, const Ray& ray) { return derived().point_of(met, k, ray); });
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (guarded_) return Primitive<Derived>::occludes_packet(rays, entry, t_min, t_max);
    PacketHits met;
    derived().meet(rays, t_min, t_max, met);
    return packet_hits(met, rays);
  }

  // Where lane k is hit.
  Vec3 point_of(const PacketHits& met, int k, const Ray& ray) const { return ray.origin + met.t[k] * ray.direction; }

 protected:
  KernelPrimitive(const scene::Object& description, const LocalBox& local)
      : Primitive<Derived>(description, local), guarded_(has_guards(description)) {}

  bool guarded() const { return guarded_; }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }

  const bool guarded_;
};

// A shape that looks for the nearest hits of a packet step by step. It writes
//   template <class HitOf> unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max,
//                                                     HitOf&& hit_of, bool any) const;
// which puts the hit of lane k into hit_of(k); `any`: any hit will do. It may write
//   void hits_of_packet(const RayPacket& rays, const double* from, const double* to, LaneHits& hits) const;
// for intersect_packet_between.
template <class Derived>
class SearchPrimitive : public Primitive<Derived> {
 public:
  unsigned intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                            const double* t_max, Hit* hits) const override {
    if (!derived().takes_packets()) return Shape::intersect_packet(rays, entry, kind, t_min, t_max, hits);
    return derived().nearest_of_packet(
        rays, t_min, t_max, [&](int k) -> Hit& { return hits[k]; }, false);
  }
  unsigned occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                           const double* t_max) const override {
    if (!derived().takes_packets()) return Shape::occludes_packet(rays, entry, t_min, t_max);
    Hit hit;
    return derived().nearest_of_packet(
        rays, t_min, t_max, [&](int) -> Hit& { return hit; }, true);
  }

  void intersect_packet_between(const RayPacket& rays, RayKind kind, const double* from, const double* to,
                                LaneHits& hits) const override {
    if constexpr (requires { derived().hits_of_packet(rays, from, to, hits); })
      if (derived().takes_packets()) return derived().hits_of_packet(rays, from, to, hits);
    Shape::intersect_packet_between(rays, kind, from, to, hits);
  }

  // False: one ray is asked after another.
  bool takes_packets() const { return true; }

 protected:
  using Primitive<Derived>::Primitive;

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace verisim::shapes
