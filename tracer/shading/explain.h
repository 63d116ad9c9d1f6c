// A witness of how a pixel comes to be: a Tracer that has one tells it about every ray, layer and light, in the order
// of the work. Without one (always but in `verisim explain`) it costs a comparison with null.
#pragma once

#include "tracer/shading/effects.h"
#include "tracer/shading/ray_state.h"

namespace verisim::shading {

class SceneData;

class Observer {
 public:
  virtual ~Observer() = default;
  // Once, before the first ray; the scene outlives the calls that follow.
  virtual void scene(const SceneData&) {}
  // A ray and what it hits first; null: nothing, it sees the sky. Rays that start before ray_ended are secondary to it.
  virtual void ray_started(const RayState&, const shapes::Hit*) {}
  virtual void ray_ended(const RayState&, const Color&) {}
  // A ray that is not traced: max_trace_level, or its weight is below adc_bailout.
  virtual void ray_cut_off(const RayState&) {}
  // The hit in front of the eye as it is shaded, and each of its layers from the top.
  virtual void layer(const SurfaceHit&, const LayerContext&, const Rgb& /*reflectivity*/) {}
  // A light on the latest layer: what is left of it after attenuation and, if `tested`, shadows; what the layer makes
  // of it, and how much of that is a highlight.
  virtual void light(const Light&, const LightDirection&, bool /*tested*/, const Rgb& /*arriving*/,
                     const Rgb& /*added*/, const Rgb& /*highlight*/) {}
  // What the latest layer sends out besides its own light and that of lights: "subsurface", "radiosity", "photons".
  virtual void indirect(const char* /*effect*/, const Rgb&) {}
  // Layers that follow belong to a texture that counts with this weight (of a map, of several at one point), until it
  // has ended.
  virtual void texture_started(float /*weight*/) {}
  virtual void texture_ended() {}
  // What the rays that were sent out since the last such call add to the colour of the ray that sent them.
  virtual void rays_added(const Rgb&) {}
  // Fog, media ...: the colour of the latest ray that has not ended, without and with them, and the part of its light
  // that passes them.
  virtual void air(const Color& /*without*/, const Color& /*with*/, float /*passed*/) {}
};

}  // namespace verisim::shading
