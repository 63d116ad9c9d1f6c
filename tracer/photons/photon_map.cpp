#include "tracer/photons/photon_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "tracer/base/output_file.h"
#include "tracer/math/constants.h"

namespace verisim::global {
namespace {

Vec3 vector(const PhotonPosition& p) { return {p[0], p[1], p[2]}; }

}  // namespace

void PhotonMap::build() {
  index_.photons.fit();
  sort_photons(index_.photons);
  build_sorted();
}

void PhotonMap::build_sorted() { index_.build(); }

void PhotonMap::gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const {
  find({point, normal ? *normal : Vec3(0.0)}, settings, out);
  out.photons = {photons(), out.numbers};
}

void PhotonMap::find(const PhotonCenter& center, const GatherSettings& settings, Gathered& out) const {
  const Vec3& point = center.point;
  const NearbyRadii::Places nearby = out.nearby.at(point, radius_);
  out.radius = out.search.nearest(index_, center, radius_, settings.maximum, kAnyNumber,
                                  nearby.nearest(point).enough(point), out.numbers);
  nearby.remember({point, out.radius});
  if (static_cast<int>(out.numbers.size()) >= settings.minimum) return;
  // The second try counts if it finds few, or photons that lie hardly denser. So many that they are neither make it
  // vain, wherever the others are.
  const double reach = 3.0 * radius_;
  const double first =
      out.numbers.empty() ? 1e-16 : static_cast<double>(out.numbers.size()) / (out.radius * out.radius);
  const double vain = std::max(settings.expand_minimum + 1.0,
                               first * (1.0 + settings.expand_increase) * reach * reach * (1.0 + 1e-9) + 1.0);
  const std::size_t too_many = vain < settings.maximum ? static_cast<std::size_t>(std::ceil(vain)) : kAnyNumber;
  const double guess = std::sqrt(1.2 * std::min(vain, static_cast<double>(settings.maximum)) / first);
  const double wider = out.search.nearest(index_, center, reach, settings.maximum, too_many, guess, out.wider_numbers);
  if (wider == 0.0) return;
  const double second = static_cast<double>(out.wider_numbers.size()) / (wider * wider);
  const int found = static_cast<int>(out.wider_numbers.size());
  if ((second - first) / first < settings.expand_increase || (found >= 1 && found < settings.expand_minimum)) {
    out.numbers.swap(out.wider_numbers);
    out.radius = wider;
  }
}

// Of a disc with so many photons, if they lay evenly in a square around all of them.
double PhotonMap::typical_radius(int count) const {
  double extent = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto less = [a](const PhotonPosition& l, const PhotonPosition& r) { return l[a] < r[a]; };
    const auto [low, high] = std::minmax_element(positions().begin(), positions().end(), less);
    extent = std::max(extent, static_cast<double>((*high)[a]) - (*low)[a]);
  }
  return extent * std::sqrt(count / static_cast<double>(photons().size()));
}

void PhotonMap::set_gather_radius(double user, double multiplier, int gather_max, bool media, CLibraryRandom& random) {
  const double scale = multiplier * (media ? 2.0 : 1.0);
  radius_ = user * scale;
  if (user > 0.0 || photons().empty()) return;
  const auto volume = [&](double r) { return media ? 4.0 / 3.0 * kPi * r * r * r : kPi * r * r; };
  const std::size_t tries = std::clamp<std::size_t>(photons().size() / 20, 100, 1000);
  PhotonSearch search;
  std::vector<std::uint32_t> found;
  const double typical = typical_radius(gather_max);
  double enough = 0.0, density = 0.0;
  for (std::size_t i = 0; i < tries; ++i) {
    const PhotonPosition& p = positions()[random() % size()];
    enough = search.nearest(index_, {vector(p), Vec3(0.0)}, 1e7, gather_max, kAnyNumber,
                            enough > 0.0 ? 1.06 * enough : typical, found);
    density += static_cast<double>(found.size()) / volume(enough);
  }
  density /= static_cast<double>(tries);
  const double ideal =
      media ? std::pow(3.0 * gather_max / (4.0 * kPi * density), 0.3333) : std::sqrt(gather_max / (kPi * density));
  std::size_t sparse = 0;
  for (std::size_t i = 0; i < tries; ++i) {
    const PhotonPosition& p = positions()[random() % size()];
    enough = search.nearest(index_, {vector(p), Vec3(0.0)}, ideal, gather_max, kAnyNumber, 1.06 * enough, found);
    const double d = static_cast<double>(found.size()) / volume(enough);
    if (d > 0.05 * density && d < 0.70 * density) ++sparse;
  }
  radius_ = ideal * (1.0 + 20.0 * static_cast<double>(sparse) / static_cast<double>(tries)) * scale;
}

namespace {

constexpr std::size_t kRecord = 20;

void write_map(std::FILE* file, const PhotonMap& map) {
  const auto count = static_cast<std::int32_t>(map.size());
  std::fwrite(&count, sizeof count, 1, file);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Photon& p = map.photons()[i];
    std::array<char, kRecord> record{};
    std::copy_n(reinterpret_cast<const char*>(map.positions()[i].data()), 12, record.begin());
    std::copy_n(reinterpret_cast<const char*>(p.energy.data()), 4, record.begin() + 12);
    record[16] = static_cast<char>(p.axis), record[17] = static_cast<char>(p.elevation),
    record[18] = static_cast<char>(p.azimuth);
    std::fwrite(record.data(), 1, record.size(), file);
  }
}

void read_map(std::ifstream& file, std::uintmax_t bytes_left, PhotonMap& map) {
  std::int32_t count = 0;
  if (!file.read(reinterpret_cast<char*>(&count), sizeof count)) return;  // an absent second map is an empty one
  if (count < 0 || static_cast<std::uintmax_t>(count) * kRecord > bytes_left)
    throw std::runtime_error("photon file is truncated or corrupt");
  map.reserve(static_cast<std::size_t>(count));
  for (std::int32_t i = 0; i < count; ++i) {
    std::array<char, kRecord> record;
    if (!file.read(record.data(), record.size())) throw std::runtime_error("photon file is truncated");
    PhotonPosition position;
    Photon p;
    std::copy_n(record.begin(), 12, reinterpret_cast<char*>(position.data()));
    std::copy_n(record.begin() + 12, 4, reinterpret_cast<char*>(p.energy.data()));
    p.axis = static_cast<std::uint8_t>(record[16]);
    if (p.axis > 2) throw std::runtime_error("photon file is corrupt");
    p.elevation = static_cast<std::int8_t>(record[17]), p.azimuth = static_cast<std::int8_t>(record[18]);
    if (!std::isfinite(position[0] + position[1] + position[2])) throw std::runtime_error("photon file is corrupt");
    map.add(position, p);
  }
}

}  // namespace

void save_photons(const std::filesystem::path& path, const PhotonMap& surface, const PhotonMap& media) {
  OutputFile file(path);
  write_map(file.get(), surface), write_map(file.get(), media);
  file.publish();
}

void load_photons(const std::filesystem::path& path, PhotonMap& surface, PhotonMap& media) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) throw std::runtime_error("cannot read photon file " + path.string());
  read_map(file, size, surface), read_map(file, size, media);
  surface.build_sorted(), media.build_sorted();
}

}  // namespace verisim::global
