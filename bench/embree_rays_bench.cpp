// Embree's bare rate on the Cornell box's triangles: single rays in robust mode, nearest hit and any hit, between
// random points of the walls. What path tracing's rays per second (`verisim render --integrator path --stats`) are
// measured against.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <random>
#include <vector>

namespace {

struct Box {
  Box() {
    const float quads[][12] = {{552.8f, 0, 0, 0, 0, 0, 0, 0, 559.2f, 549.6f, 0, 559.2f},
                               {556, 548.8f, 0, 556, 548.8f, 559.2f, 0, 548.8f, 559.2f, 0, 548.8f, 0},
                               {549.6f, 0, 559.2f, 0, 0, 559.2f, 0, 548.8f, 559.2f, 556, 548.8f, 559.2f},
                               {0, 0, 559.2f, 0, 0, 0, 0, 548.8f, 0, 0, 548.8f, 559.2f},
                               {552.8f, 0, 0, 549.6f, 0, 559.2f, 556, 548.8f, 559.2f, 556, 548.8f, 0},
                               {343, 548.7f, 227, 343, 548.7f, 332, 213, 548.7f, 332, 213, 548.7f, 227},
                               {130, 165, 65, 82, 165, 225, 240, 165, 272, 290, 165, 114},
                               {290, 0, 114, 290, 165, 114, 240, 165, 272, 240, 0, 272},
                               {130, 0, 65, 130, 165, 65, 290, 165, 114, 290, 0, 114},
                               {82, 0, 225, 82, 165, 225, 130, 165, 65, 130, 0, 65},
                               {240, 0, 272, 240, 165, 272, 82, 165, 225, 82, 0, 225},
                               {423, 330, 247, 265, 330, 296, 314, 330, 456, 472, 330, 406},
                               {423, 0, 247, 423, 330, 247, 472, 330, 406, 472, 0, 406},
                               {472, 0, 406, 472, 330, 406, 314, 330, 456, 314, 0, 456},
                               {314, 0, 456, 314, 330, 456, 265, 330, 296, 265, 0, 296},
                               {265, 0, 296, 265, 330, 296, 423, 330, 247, 423, 0, 247}};
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    constexpr std::size_t kQuads = sizeof quads / sizeof *quads;
    auto* points = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, kQuads * 4));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, kQuads * 2));
    for (unsigned q = 0; q < kQuads; ++q) {
      for (int i = 0; i < 12; ++i) points[q * 12 + static_cast<unsigned>(i)] = quads[q][i];
      const unsigned corners[6] = {0, 1, 2, 0, 2, 3};
      for (int i = 0; i < 6; ++i) indices[q * 6 + static_cast<unsigned>(i)] = q * 4 + corners[i];
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> u(1, 548), d(-1, 1);
    for (int i = 0; i < 4096; ++i) {
      RTCRayHit r{};
      r.ray.org_x = u(random), r.ray.org_y = u(random), r.ray.org_z = u(random);
      r.ray.dir_x = d(random), r.ray.dir_y = d(random), r.ray.dir_z = d(random);
      r.ray.tfar = 1e9f, r.ray.mask = ~0u;
      r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rays.push_back(r);
    }
  }
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  std::vector<RTCRayHit> rays;
};

Box& box() {
  static Box b;
  return b;
}

void nearest_hit(benchmark::State& state) {
  for (auto _ : state) {
    for (RTCRayHit ray : box().rays) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(box().scene, &context, &ray);
      benchmark::DoNotOptimize(ray.ray.tfar);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(box().rays.size()));
}
BENCHMARK(nearest_hit);

void any_hit(benchmark::State& state) {
  for (auto _ : state) {
    for (const RTCRayHit& r : box().rays) {
      RTCRay ray = r.ray;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcOccluded1(box().scene, &context, &ray);
      benchmark::DoNotOptimize(ray.tfar);
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(box().rays.size()));
}
BENCHMARK(any_hit);

}  // namespace
