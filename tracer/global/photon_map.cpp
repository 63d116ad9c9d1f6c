#include "tracer/global/photon_map.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace verisim::global {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr auto kAny = std::numeric_limits<std::size_t>::max();  // too many for every search

Vec3 position(const Photon& p) { return {p.position[0], p.position[1], p.position[2]}; }

// Whether the photon's squared distance is below the limit; with a normal it is larger the farther the photon lies from the plane through `point`.
inline bool is_near(const Photon& p, const Vec3& point, const Vec3* normal, double limit, double& squared) {
  const Vec3 delta = position(p) - point;
  squared = dot(delta, delta);
  if (squared >= limit) return false;  // flattened distances are never below plain ones
  if (normal) squared *= 1.0 + 16.0 * std::fabs(dot(*normal, delta));
  return squared < limit;
}

}  // namespace

void PhotonMap::build() {
  sort_photons(photons_);
  build_sorted();
}

void PhotonMap::build_sorted() {
  planes_.build(photons_);
  tree_.build(photons_.size(), [this](std::size_t i) { return photons_[i].position; });
}

// Keeps the `maximum` nearest, in their order in the map; of equally far ones the first.
void PhotonMap::Search::keep_nearest(std::size_t maximum, double& limit) {
  // Squared distances are spread evenly over a disc, so a histogram narrows the last one kept down to a few.
  constexpr std::size_t kBins = 64;
  std::array<std::uint32_t, kBins> counts{};
  const double scale = limit > 0.0 ? kBins / limit : 0.0;
  const auto bin_of = [scale](double squared) { return std::min(kBins - 1, static_cast<std::size_t>(squared * scale)); };
  for (const Found& f : found) ++counts[bin_of(f.squared)];
  std::size_t bin = 0, before = 0;
  while (before + counts[bin] < maximum) before += counts[bin++];
  distances.clear();
  for (const Found& f : found) {
    if (bin_of(f.squared) == bin) distances.push_back(f.squared);
  }
  const auto last = distances.begin() + static_cast<std::ptrdiff_t>(maximum - before) - 1;
  std::nth_element(distances.begin(), last, distances.end());
  limit = *last;
  std::size_t room = maximum;  // for those exactly at the limit
  for (const Found& f : found) room -= f.squared < limit ? 1 : 0;
  std::size_t kept = 0;
  for (const Found& f : found) {
    if (f.squared > limit || (f.squared == limit && room == 0)) continue;
    if (f.squared == limit) --room;
    found[kept++] = f;
  }
  found.resize(kept);
}

// Collects the nearest photons with flattened distance below `within`, of those that a search within `radius` comes upon. `nearest`: there were more than
// `maximum`; then `farthest` is the distance of the last one kept, squared. Gives up when it knows that there are `too_many` or more.
template <class Candidates>
PhotonMap::Collected PhotonMap::collect(const Candidates& candidates, const Vec3& point, const Vec3* normal, double within, double radius,
                                        std::size_t maximum, std::size_t too_many, Search& search, double& farthest) const {
  search.found.clear();
  double limit = within * within;
  Collected result = Collected::all;
  candidates.visit(point, limit, [&](std::uint32_t i) {
    double squared;
    if (!is_near(photons_[i], point, normal, limit, squared) || !planes_.looks_behind(i, point, radius * radius)) return;
    search.found.push_back({squared, i});
    if (search.found.size() >= too_many) {
      limit = 0.0, result = Collected::too_many;  // no more, please
    } else if (search.found.size() >= 2 * maximum + 20) {
      search.keep_nearest(maximum, limit), result = Collected::nearest;
    }
  });
  if (result == Collected::too_many) return result;
  if (search.found.size() > maximum) search.keep_nearest(maximum, limit), result = Collected::nearest;
  farthest = limit;
  return result;
}

// POV-Ray's search narrows its radius once it knows more than `maximum`, so what it overlooks hangs on the order in which it comes upon them. That matters
// if one of those found is behind a plane that is beyond the final radius, and `maximum` photons nearer than that plane come before it.
bool PhotonMap::depends_on_order(const Vec3& point, const Vec3* normal, double radius, std::size_t maximum, double farthest, Search& search) const {
  // The first one too many takes the place of the last one kept, even if it is farther away. That shows only where few are too many.
  if (farthest > 0.9 * radius * radius) return true;
  search.doubts.clear();
  double reach = 0.0;
  for (const Search::Found& f : search.found) {
    planes_.for_each_hiding(f.index, point, farthest, [&](std::uint32_t node, double squared) {
      search.doubts.push_back({squared, node});
      reach = std::max(reach, squared);
      return true;
    });
  }
  if (search.doubts.empty()) return false;
  search.around.clear();
  reach *= 1.0 + 1e-9;
  tree_.visit(point, reach, [&](std::uint32_t i) {
    if (double squared; is_near(photons_[i], point, normal, reach, squared)) search.around.push_back({squared, i});
  });
  return std::ranges::any_of(search.doubts, [&](const Search::Found& doubt) {
    const auto nearer = [&](const Search::Found& f) { return f.squared <= doubt.squared; };
    auto spare = std::ranges::count_if(search.around, nearer) - static_cast<std::ptrdiff_t>(maximum);
    for (const Search::Found& f : search.around) {
      if (spare < 0) return false;
      if (nearer(f) && !visited_before(photons_, point, f.index, doubt.index)) --spare;
    }
    return spare >= 0;
  });
}

void PhotonMap::collect_in_order(const Vec3& point, const Vec3* normal, double radius, std::size_t maximum, Search& search, double& farthest) const {
  std::vector<Search::Found>& heap = search.found;
  const auto nearer = [](const Search::Found& a, const Search::Found& b) { return a.squared < b.squared; };
  heap.clear();
  double limit = radius * radius;
  visit_in_order(photons_, point, limit, [&](std::uint32_t i) {
    double squared;
    if (!is_near(photons_[i], point, normal, limit, squared)) return;
    const bool full = heap.size() == maximum;
    if (full) std::ranges::pop_heap(heap, nearer), heap.pop_back();
    heap.push_back({squared, i});
    std::ranges::push_heap(heap, nearer);
    if (full) limit = heap.front().squared;
  });
  farthest = limit;
  std::ranges::sort(heap, {}, &Search::Found::index);
}

bool PhotonMap::fill(PhotonNeighbourhoods::Cell& cell, std::size_t most) const {
  cell.indices.clear();
  double limit = cell.reach * cell.reach;
  tree_.visit(cell.center, limit, [&](std::uint32_t i) {
    cell.indices.push_back(i);
    if (cell.indices.size() > most) limit = 0.0;  // no more, please
  });
  if (cell.indices.size() > most) return false;
  cell.positions.resize(cell.indices.size());
  for (std::size_t k = 0; k < cell.indices.size(); ++k) {
    const Vec3 p = position(photons_[cell.indices[k]]) - cell.center;
    cell.positions.set(k, static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
  }
  return true;
}

double PhotonMap::search(const Vec3& point, const Vec3* normal, double radius, int maximum, std::size_t too_many, double& enough, Search& s,
                         std::vector<const Photon*>& out) const {
  out.clear();
  if (photons_.empty() || maximum <= 0 || !(0.3 * radius > 0.0)) return radius;
  // Photons lie about as dense here as nearby: radii little above the one that was enough there are tried first. If they hold more than `maximum`, the
  // nearest are among them, whatever the radius. Where nothing is known small ones come first: they cost little if they hold too few.
  const auto most = static_cast<std::size_t>(maximum);
  const double start = enough > 0.0 ? std::min(1.06 * enough, radius) : 0.3 * radius, growth = enough > 0.0 ? 1.4 : 2.0;
  double farthest = 0.0;
  Collected collected = Collected::all;
  bool known = false;
  if (const auto* cell = s.nearby.around(point, start, radius, [&](PhotonNeighbourhoods::Cell& c) { return fill(c, 8 * most + 64); })) {
    // What the cell knows all of around this point may be less than the radius.
    const double reach = (cell->reach - length(point - cell->center)) * (1.0 - 1e-9), within = std::min(radius, reach);
    for (double guess = start; collected == Collected::all && !known; guess *= growth) {
      collected = collect(*cell, point, normal, std::min(guess, within), radius, most, too_many, s, farthest);
      known = guess >= within;
    }
    known = collected != Collected::all || within == radius;
  }
  for (double guess = start; !known; guess *= growth) {
    collected = collect(tree_, point, normal, std::min(guess, radius), radius, most, too_many, s, farthest);
    known = collected != Collected::all || guess >= radius;
  }
  if (collected == Collected::too_many) return 0.0;
  if (collected == Collected::nearest && depends_on_order(point, normal, radius, most, farthest, s)) collect_in_order(point, normal, radius, most, s, farthest);
  for (const Search::Found& f : s.found) out.push_back(&photons_[f.index]);
  return enough = collected == Collected::nearest ? std::sqrt(farthest) : radius;
}

void PhotonMap::gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const {
  out.radius = search(point, normal, radius_, settings.maximum, kAny, out.search.nearby.guess(point, radius_), out.search, out.photons);
  if (static_cast<int>(out.photons.size()) >= settings.minimum) return;
  // The second try counts if it finds few, or photons that lie hardly denser. So many that they are neither make it vain, wherever the others are.
  const double reach = 3.0 * radius_;
  const double first = out.photons.empty() ? 1e-16 : static_cast<double>(out.photons.size()) / (out.radius * out.radius);
  const double vain = std::max(settings.expand_minimum + 1.0, first * (1.0 + settings.expand_increase) * reach * reach * (1.0 + 1e-9) + 1.0);
  const std::size_t too_many = vain < settings.maximum ? static_cast<std::size_t>(std::ceil(vain)) : kAny;
  double& guess = out.wider_search.nearby.guess(point, reach);
  const double wider = search(point, normal, reach, settings.maximum, too_many, guess, out.wider_search, out.wider_photons);
  if (wider == 0.0) return;
  const double second = static_cast<double>(out.wider_photons.size()) / (wider * wider);
  const int found = static_cast<int>(out.wider_photons.size());
  if ((second - first) / first < settings.expand_increase || (found >= 1 && found < settings.expand_minimum)) {
    out.photons.swap(out.wider_photons);
    out.radius = wider;
  }
}

// Of a disc with so many photons, if they lay evenly in a square around all of them.
double PhotonMap::typical_radius(int count) const {
  double extent = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto less = [a](const Photon& l, const Photon& r) { return l.position[a] < r.position[a]; };
    const auto [low, high] = std::minmax_element(photons_.begin(), photons_.end(), less);
    extent = std::max(extent, static_cast<double>(high->position[a]) - low->position[a]);
  }
  return extent * std::sqrt(count / static_cast<double>(photons_.size()));
}

void PhotonMap::set_gather_radius(double user, double multiplier, int gather_max, bool media, CLibraryRandom& random) {
  const double scale = multiplier * (media ? 2.0 : 1.0);
  radius_ = user * scale;
  if (user > 0.0 || photons_.empty()) return;
  const auto volume = [&](double r) { return media ? 4.0 / 3.0 * kPi * r * r * r : kPi * r * r; };
  const std::size_t tries = std::clamp<std::size_t>(photons_.size() / 20, 100, 1000);
  Search scratch;
  std::vector<const Photon*> found;
  const double typical = typical_radius(gather_max);
  double guess = typical;
  double density = 0.0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[random() % photons_.size()];
    const double r = search(position(p), nullptr, 1e7, gather_max, kAny, guess, scratch, found);
    density += static_cast<double>(found.size()) / volume(r);
    if (guess == 0.0) guess = typical;
  }
  density /= static_cast<double>(tries);
  const double ideal = media ? std::pow(3.0 * gather_max / (4.0 * kPi * density), 0.3333) : std::sqrt(gather_max / (kPi * density));
  std::size_t sparse = 0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[random() % photons_.size()];
    const double r = search(position(p), nullptr, ideal, gather_max, kAny, guess, scratch, found);
    const double d = static_cast<double>(found.size()) / volume(r);
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
    p.axis = static_cast<std::uint8_t>(record[16]);
    if (p.axis > 2) throw std::runtime_error("photon file is corrupt");
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
  surface.build_sorted(), media.build_sorted();
}

}  // namespace verisim::global
