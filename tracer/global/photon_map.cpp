#include "tracer/global/photon_map.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <queue>
#include <random>
#include <stdexcept>

namespace verisim::global {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3 position(const Photon& p) { return {p.position[0], p.position[1], p.position[2]}; }

}  // namespace

std::array<std::uint8_t, 4> Photon::encode(const Rgb& energy) {
  const float v = energy.max();
  if (!(v >= 1e-32f)) return {0, 0, 0, 0};
  int exponent;
  const double scale = std::frexp(static_cast<double>(v), &exponent) * 256.0 / v;
  const auto mantissa = [&](float c) { return static_cast<std::uint8_t>(std::clamp(static_cast<int>(c * scale), 0, 255)); };
  return {mantissa(energy.r), mantissa(energy.g), mantissa(energy.b), static_cast<std::uint8_t>(exponent + 250)};
}

void Photon::set_direction(const Vec3& d) {
  const double horizontal = std::sqrt(d.x * d.x + d.z * d.z);
  double up = std::acos(std::clamp(horizontal, -1.0, 1.0));
  if (d.y < 0.0) up = -up;
  double around = horizontal > 0.0 ? std::acos(std::clamp(d.x / horizontal, -1.0, 1.0)) : 0.0;
  if (d.z < 0.0) around = -around;
  elevation = static_cast<std::int8_t>(up * 127.0 / kPi);
  azimuth = static_cast<std::int8_t>(around * 127.0 / kPi);
}

Rgb Photon::color() const {
  if (energy[3] == 0) return {};
  const float scale = std::ldexp(1.0f, static_cast<int>(energy[3]) - (250 + 8));
  return {energy[0] * scale, energy[1] * scale, energy[2] * scale};
}

Vec3 Photon::direction() const {
  const double up = elevation * kPi / 127.0, around = azimuth * kPi / 127.0, c = std::cos(up);
  return {c * std::cos(around), std::sin(up), c * std::sin(around)};
}

void PhotonMap::build() {
  struct Range {
    std::size_t first, last;  // inclusive
  };
  if (photons_.empty()) return;
  std::vector<Range> stack{{0, photons_.size() - 1}};
  while (!stack.empty()) {
    const Range r = stack.back();
    stack.pop_back();
    std::array<float, 3> low = photons_[r.first].position, high = low;
    for (std::size_t i = r.first; i <= r.last; ++i) {
      for (int a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], photons_[i].position[a]), high[a] = std::max(high[a], photons_[i].position[a]);
      }
    }
    int axis = 0;
    for (int a = 1; a < 3; ++a) {
      if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
    }
    const std::size_t middle = (r.first + r.last) / 2;
    const auto begin = photons_.begin();
    std::nth_element(begin + static_cast<long>(r.first), begin + static_cast<long>(middle), begin + static_cast<long>(r.last) + 1,
                     [axis](const Photon& a, const Photon& b) { return a.position[axis] < b.position[axis]; });
    photons_[middle].axis = static_cast<std::uint8_t>(axis);
    if (middle > r.first) stack.push_back({r.first, middle - 1});
    if (middle < r.last) stack.push_back({middle + 1, r.last});
  }
}

void PhotonMap::search(const Vec3& point, const Vec3* normal, double radius, int maximum, Gathered& out) const {
  out.photons.clear();
  out.radius = radius;
  if (photons_.empty() || maximum <= 0) return;
  struct Found {
    double squared;
    const Photon* photon;
    bool operator<(const Found& o) const { return squared < o.squared; }
  };
  // A max-heap of the nearest so far; the flattened distance is never below the plain one, so plain distance prunes.
  thread_local std::vector<Found> heap;
  heap.clear();
  double limit = radius * radius;
  bool dropped = false;
  struct Frame {
    long first, last;
    double squared;  // lower bound of the distance to this range
  };
  std::array<Frame, 128> stack;
  int depth = 0;
  stack[depth++] = {0, static_cast<long>(photons_.size()) - 1, 0.0};
  while (depth > 0) {
    const Frame f = stack[--depth];
    if (f.first > f.last || f.squared >= limit) continue;
    const long middle = (f.first + f.last) / 2;
    const Photon& p = photons_[static_cast<std::size_t>(middle)];
    const Vec3 delta = position(p) - point;
    double squared = dot(delta, delta);
    if (squared < limit) {
      if (normal) squared *= 1.0 + 16.0 * std::fabs(dot(*normal, delta));
      if (squared < limit) {
        heap.push_back({squared, &p});
        std::push_heap(heap.begin(), heap.end());
        if (static_cast<int>(heap.size()) > maximum) {
          std::pop_heap(heap.begin(), heap.end());
          heap.pop_back();
          dropped = true;
        }
        if (static_cast<int>(heap.size()) == maximum && dropped) limit = heap.front().squared;
      }
    }
    const double split = point[p.axis] - p.position[p.axis];
    const Frame low{f.first, middle - 1, split > 0.0 ? std::max(f.squared, split * split) : f.squared};
    const Frame high{middle + 1, f.last, split < 0.0 ? std::max(f.squared, split * split) : f.squared};
    // The nearer side is searched first.
    stack[depth++] = split > 0.0 ? low : high;
    stack[depth++] = split > 0.0 ? high : low;
  }
  for (const Found& f : heap) out.photons.push_back(f.photon);
  if (dropped) out.radius = std::sqrt(heap.front().squared);
}

void PhotonMap::gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const {
  search(point, normal, radius_, settings.maximum, out);
  if (static_cast<int>(out.photons.size()) >= settings.minimum) return;
  thread_local Gathered wider;
  search(point, normal, 3.0 * radius_, settings.maximum, wider);
  const double first = out.photons.empty() ? 1e-16 : static_cast<double>(out.photons.size()) / (out.radius * out.radius);
  const double second = wider.radius > 0.0 ? static_cast<double>(wider.photons.size()) / (wider.radius * wider.radius) : 0.0;
  const int found = static_cast<int>(wider.photons.size());
  if ((second - first) / first < settings.expand_increase || (found >= 1 && found < settings.expand_minimum)) std::swap(out, wider);
}

void PhotonMap::set_gather_radius(double user, double multiplier, int gather_max, bool media) {
  const double scale = multiplier * (media ? 2.0 : 1.0);
  radius_ = user * scale;
  if (user > 0.0 || photons_.empty()) return;
  const auto volume = [&](double r) { return media ? 4.0 / 3.0 * kPi * r * r * r : kPi * r * r; };
  const std::size_t tries = std::clamp<std::size_t>(photons_.size() / 20, 100, 1000);
  std::mt19937 generator(1);
  Gathered found;
  double density = 0.0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[generator() % photons_.size()];
    search(position(p), nullptr, 1e7, gather_max, found);
    density += static_cast<double>(found.photons.size()) / volume(found.radius);
  }
  density /= static_cast<double>(tries);
  const double ideal = media ? std::pow(3.0 * gather_max / (4.0 * kPi * density), 0.3333) : std::sqrt(gather_max / (kPi * density));
  std::size_t sparse = 0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[generator() % photons_.size()];
    search(position(p), nullptr, ideal, gather_max, found);
    const double d = static_cast<double>(found.photons.size()) / volume(found.radius);
    if (d > 0.05 * density && d < 0.70 * density) ++sparse;
  }
  radius_ = ideal * (1.0 + 20.0 * static_cast<double>(sparse) / static_cast<double>(tries)) * scale;
}

namespace {

constexpr std::size_t kRecord = 20;

void write_map(std::ofstream& file, const PhotonMap& map) {
  const auto count = static_cast<std::int32_t>(map.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Photon& p : map.photons()) {
    std::array<char, kRecord> record{};
    std::copy_n(reinterpret_cast<const char*>(p.position.data()), 12, record.begin());
    std::copy_n(reinterpret_cast<const char*>(p.energy.data()), 4, record.begin() + 12);
    record[16] = static_cast<char>(p.axis), record[17] = static_cast<char>(p.elevation), record[18] = static_cast<char>(p.azimuth);
    file.write(record.data(), record.size());
  }
}

void read_map(std::ifstream& file, std::uintmax_t bytes_left, PhotonMap& map) {
  std::int32_t count = 0;
  if (!file.read(reinterpret_cast<char*>(&count), sizeof count)) return;  // an absent second map is an empty one
  if (count < 0 || static_cast<std::uintmax_t>(count) * kRecord > bytes_left) throw std::runtime_error("photon file is truncated or corrupt");
  map.photons().reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i) {
    std::array<char, kRecord> record;
    if (!file.read(record.data(), record.size())) throw std::runtime_error("photon file is truncated");
    Photon p;
    std::copy_n(record.begin(), 12, reinterpret_cast<char*>(p.position.data()));
    std::copy_n(record.begin() + 12, 4, reinterpret_cast<char*>(p.energy.data()));
    p.elevation = static_cast<std::int8_t>(record[17]), p.azimuth = static_cast<std::int8_t>(record[18]);
    if (!std::isfinite(p.position[0] + p.position[1] + p.position[2])) throw std::runtime_error("photon file is corrupt");
    map.add(p);
  }
}

}  // namespace

void save_photons(const std::filesystem::path& path, const PhotonMap& surface, const PhotonMap& media) {
  const std::filesystem::path temporary = path.string() + ".part";
  {
    std::ofstream file(temporary, std::ios::binary);
    write_map(file, surface), write_map(file, media);
    if (!file.flush()) throw std::runtime_error("cannot write photon file " + path.string());
  }
  std::filesystem::rename(temporary, path);
}

void load_photons(const std::filesystem::path& path, PhotonMap& surface, PhotonMap& media) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw std::runtime_error("cannot read photon file " + path.string());
  read_map(file, size, surface), read_map(file, size, media);
  surface.build(), media.build();
}

}  // namespace verisim::global
