#include "tracer/render/prepass_data.h"

#include <cmath>

#include "tracer/base/bytes.h"

namespace verisim::render {
namespace {

using global::IrradianceSample;
using global::Photon;
using global::PhotonPosition;

constexpr std::uint32_t kVersion = 1;

void put(std::string& out, const Vec3& v) {
  for (const double c : {v.x, v.y, v.z}) put_bytes(out, c);
}

Vec3 take_vector(ByteSource& in) {
  Vec3 v;
  for (int a = 0; a < 3; ++a) v[a] = in.take<double>();
  return v;
}

void put(std::string& out, const PhotonPosition& position, const Photon& photon) {
  for (const float c : position) put_bytes(out, c);
  for (const std::uint8_t c : photon.energy) put_bytes(out, c);
  put_bytes(out, photon.axis), put_bytes(out, photon.elevation), put_bytes(out, photon.azimuth);
}

void take_photon(ByteSource& in, global::PhotonMap& map) {
  PhotonPosition position;
  Photon photon;
  for (float& c : position) c = in.take<float>();
  for (std::uint8_t& c : photon.energy) c = in.take<std::uint8_t>();
  photon.axis = in.take<std::uint8_t>();
  photon.elevation = in.take<std::int8_t>(), photon.azimuth = in.take<std::int8_t>();
  if (photon.axis > 2 || !std::isfinite(position[0] + position[1] + position[2]))
    throw std::runtime_error("an impossible photon");
  map.add(position, photon);
}

void put(std::string& out, const IrradianceSample& s) {
  put(out, s.point), put(out, s.normal), put(out, s.nearest_direction);
  for (const float c : {s.irradiance.r, s.irradiance.g, s.irradiance.b}) put_bytes(out, c);
  put_bytes(out, s.mean_distance), put_bytes(out, s.nearest_distance), put_bytes(out, s.quality);
  put_bytes(out, s.depth), put_bytes(out, s.pass), put_bytes(out, s.tile);
}

IrradianceSample take_sample(ByteSource& in) {
  IrradianceSample s;
  s.point = take_vector(in), s.normal = take_vector(in), s.nearest_direction = take_vector(in);
  s.irradiance.r = in.take<float>(), s.irradiance.g = in.take<float>(), s.irradiance.b = in.take<float>();
  s.mean_distance = in.take<float>(), s.nearest_distance = in.take<float>(), s.quality = in.take<float>();
  s.depth = in.take<std::int16_t>(), s.pass = in.take<std::int16_t>(), s.tile = in.take<std::int32_t>();
  if (s.depth < 0 || s.depth >= global::kMaxRadiosityDepth) throw std::runtime_error("an impossible radiosity sample");
  return s;
}

void put_photons(std::string& out, const global::PhotonMap& map) {
  put_bytes(out, std::uint64_t{map.size()});
  for (std::size_t i = 0; i < map.size(); ++i) put(out, map.positions()[i], map.photons()[i]);
}

void take_photons(ByteSource& in, global::PhotonMap& map) {
  for (auto left = in.take<std::uint64_t>(); left > 0; --left) take_photon(in, map);
  map.build_sorted();  // they were written in the order of the map
}

}  // namespace

std::string write_prepasses(global::SceneEffects& effects) {
  std::string out;
  put_bytes(out, kVersion);
  put_photons(out, effects.surface_photons());
  put_photons(out, effects.media_photons());
  const std::vector<IrradianceSample> none;
  const std::vector<IrradianceSample>& samples = effects.radiosity ? effects.irradiance().samples() : none;
  put_bytes(out, std::uint64_t{samples.size()});
  for (const IrradianceSample& s : samples) put(out, s);
  return out;
}

void read_prepasses(std::string_view bytes, global::SceneEffects& effects, const Options& options) {
  ByteSource in(bytes);
  if (in.take<std::uint32_t>() != kVersion) throw std::runtime_error("data of another version");
  take_photons(in, effects.surface_photons());
  take_photons(in, effects.media_photons());
  auto left = in.take<std::uint64_t>();
  if (left > 0 && !effects.radiosity) throw std::runtime_error("radiosity samples, but the scene has no radiosity");
  if (effects.radiosity) effects.irradiance().set_memory_limit(options.pass_memory);
  for (; left > 0; --left) effects.irradiance().add(take_sample(in));
  if (in.left() > 0) throw std::runtime_error("more data than there should be");
}

}  // namespace verisim::render
