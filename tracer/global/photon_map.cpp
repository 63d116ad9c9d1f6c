#include "tracer/global/photon_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace verisim::global {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr auto kAny = std::numeric_limits<std::size_t>::max();  // too many for every search

Vec3 position(const Photon& p) { return {p.position[0], p.position[1], p.position[2]}; }

}  // namespace

void PhotonMap::build() {
  sort_photons(photons_);
  build_sorted();
}

void PhotonMap::build_sorted() {
  planes_.build(photons_);
  tree_.build(photons_.size(), [this](std::size_t i) { return photons_[i].position; });
}

void PhotonDistances::keep_nearest(std::size_t maximum, double& limit) {
  // Squared distances are spread about evenly over a disc: guesses a little beyond and before the last one kept, in turn, leave few between them.
  constexpr int kMostGuesses = 8, kFew = 12;
  double low = 0.0, high = std::nextafter(limit, kInfinity);
  std::size_t below_low = 0, below_high = size_;
  for (int i = 0; i < kMostGuesses && below_high - below_low > kFew; ++i) {
    const auto between = static_cast<double>(below_high - below_low), margin = std::min(4.0, 0.2 * between);
    const double share = (static_cast<double>(maximum - below_low) + (i % 2 == 0 ? margin : -margin)) / between;
    const double guess = low + share * (high - low);
    if (!(guess > low && guess < high)) continue;
    const std::size_t below = photon_kernels().below(squared_.data(), size_, guess);
    if (below < maximum) {
      low = guess, below_low = below;
    } else {
      high = guess, below_high = below;
    }
  }
  // Sixteen at a time; calls visit(number) for those in a range.
  const auto for_each_within = [&](double from, double below, auto&& visit) {
    for (std::size_t i = 0; i < size_; i += PhotonPositions::kAtOnce) {
      const unsigned valid = size_ - i < PhotonPositions::kAtOnce ? (1u << (size_ - i)) - 1 : ~0u;
      for (unsigned bits = photon_kernels().within(squared_.data() + i, from, below) & valid; bits != 0; bits &= bits - 1) {
        visit(i + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  };
  between_.resize(below_high - below_low);
  std::size_t n = 0;
  for_each_within(low, high, [&](std::size_t i) { between_[n++] = squared_[i]; });
  const auto last = between_.begin() + static_cast<std::ptrdiff_t>(maximum - below_low - 1);
  std::nth_element(between_.begin(), last, between_.end());
  limit = *last;
  std::size_t kept = 0;
  for_each_within(0.0, std::nextafter(limit, kInfinity), [&](std::size_t i) { squared_[kept] = squared_[i], index_[kept++] = index_[i]; });
  size_ = kept;
  for (std::size_t i = kept; size_ > maximum;) {
    if (squared_[--i] != limit) continue;
    std::copy(squared_.begin() + i + 1, squared_.begin() + size_, squared_.begin() + i);
    std::copy(index_.begin() + i + 1, index_.begin() + size_, index_.begin() + i);
    --size_;
  }
}

// Collects the nearest photons with flattened distance below `within`, of those that a search within `radius` comes upon. `nearest`: there were more than
// `maximum`; then `farthest` is the distance of the last one kept, squared. Gives up when it knows that there are `too_many` or more.
PhotonMap::Collected PhotonMap::collect(const Center& center, double within, double radius, std::size_t maximum, std::size_t too_many, Search& search,
                                        double& farthest) const {
  PhotonDistances& found = search.found;
  found.clear();
  double limit = within * within;
  Collected result = Collected::all;
  tree_.visit(center.point, limit, [&](std::uint32_t first, std::uint32_t count) {
    alignas(64) std::array<double, PhotonPositions::kAtOnce> squared;
    unsigned bits = near(center, limit, first, count, squared.data());
    for (unsigned doubtful = bits & planes_.any(first); doubtful != 0; doubtful &= doubtful - 1) {
      const int i = std::countr_zero(doubtful);
      if (!planes_.looks_behind(first + static_cast<std::uint32_t>(i), center.point, radius * radius)) bits &= ~(1u << i);
    }
    found.add(first, bits, squared.data());
    if (found.size() >= too_many) {
      limit = 0.0, result = Collected::too_many;  // no more, please
    } else if (found.size() >= 2 * maximum + 20) {
      found.keep_nearest(maximum, limit), result = Collected::nearest;
    }
  });
  if (result == Collected::too_many) return result;
  if (found.size() > maximum) found.keep_nearest(maximum, limit), result = Collected::nearest;
  farthest = limit;
  return result;
}

// POV-Ray's search narrows its radius once it knows more than `maximum`, so what it overlooks hangs on the order in which it comes upon them. That matters
// if one of those found is behind a plane that is beyond the final radius, and `maximum` photons nearer than that plane come before it.
bool PhotonMap::depends_on_order(const Center& center, double radius, std::size_t maximum, double farthest, Search& search) const {
  // The first one too many takes the place of the last one kept, even if it is farther away. That shows only where few are too many.
  if (farthest > 0.9 * radius * radius) return true;
  PhotonDistances &doubts = search.doubts, &around = search.around;
  doubts.clear();
  double reach = 0.0;
  for (const std::uint32_t i : search.found.index()) {
    planes_.for_each_hiding(i, center.point, farthest, [&](std::uint32_t node, double squared) {
      doubts.add(node, squared);
      reach = std::max(reach, squared);
      return true;
    });
  }
  if (doubts.size() == 0) return false;
  around.clear();
  reach *= 1.0 + 1e-9;
  tree_.visit(center.point, reach, [&](std::uint32_t first, std::uint32_t count) {
    alignas(64) std::array<double, PhotonPositions::kAtOnce> squared;
    around.add(first, near(center, reach, first, count, squared.data()), squared.data());
  });
  std::vector<std::uint32_t>& nearer = search.nearer;
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    nearer.resize(around.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < around.size(); ++i) nearer[n] = around.index()[i], n += around.squared()[i] <= doubts.squared()[k];
    if (n < maximum) continue;
    std::size_t before = 0;
    for_each_visited_before(photons_, center.point, doubts.index()[k], [&](std::uint32_t first, std::uint32_t last) {
      const auto end = nearer.begin() + static_cast<std::ptrdiff_t>(n), from = std::lower_bound(nearer.begin(), end, first);
      before += static_cast<std::size_t>(std::upper_bound(from, end, last) - from);
    });
    if (before >= maximum) return true;
  }
  return false;
}

void PhotonMap::collect_in_order(const Center& center, double radius, std::size_t maximum, Search& search, double& farthest) const {
  struct Found {
    double squared;
    std::uint32_t index;
  };
  std::vector<Found> heap;  // the farthest first, once it is full
  const auto nearer = [](const Found& a, const Found& b) { return a.squared < b.squared; };
  double limit = radius * radius;
  const auto look_at = [&](std::uint32_t first, std::uint32_t count, double* squared) { return near(center, limit, first, count, squared); };
  visit_in_order(photons_, center.point, limit, look_at, [&](std::uint32_t i, double squared) {
    const bool full = heap.size() == maximum;
    if (full) std::ranges::pop_heap(heap, nearer), heap.pop_back();
    heap.push_back({squared, i});
    std::ranges::push_heap(heap, nearer);
    if (full) limit = heap.front().squared;
  });
  farthest = limit;
  std::ranges::sort(heap, {}, &Found::index);
  search.found.clear();
  for (const Found& f : heap) search.found.add(f.index, f.squared);
}

double PhotonMap::search(const Center& center, double radius, int maximum, std::size_t too_many, double guess, Search& s,
                         std::vector<const Photon*>& out) const {
  out.clear();
  if (photons_.empty() || maximum <= 0 || !(0.3 * radius > 0.0)) return radius;
  // If the guess holds more than `maximum`, the nearest are among them, whatever the radius. If not, how many it holds says how much more it takes.
  const auto most = static_cast<std::size_t>(maximum);
  double farthest = 0.0;
  Collected collected = Collected::all;
  for (double within = guess > 0.0 ? guess : 0.3 * radius;;) {
    collected = collect(center, std::min(within, radius), radius, most, too_many, s, farthest);
    if (collected != Collected::all || within >= radius) break;
    const double wanted = 1.2 * static_cast<double>(std::min(most, too_many)), found = static_cast<double>(s.found.size());
    within *= std::clamp(std::sqrt(wanted / std::max(found, 1.0)), 1.1, 3.0);
  }
  if (collected == Collected::too_many) return 0.0;
  if (collected == Collected::nearest && depends_on_order(center, radius, most, farthest, s)) collect_in_order(center, radius, most, s, farthest);
  for (const std::uint32_t i : s.found.index()) out.push_back(&photons_[i]);
  return collected == Collected::nearest ? std::sqrt(farthest) : radius;
}

void PhotonMap::gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const {
  const Center center{point, normal ? *normal : Vec3(0.0)};
  NearbyRadii::Known& nearby = out.search.nearby.at(point, radius_);
  out.radius = search(center, radius_, settings.maximum, kAny, nearby.enough(point), out.search, out.photons);
  nearby = {point, out.radius};
  if (static_cast<int>(out.photons.size()) >= settings.minimum) return;
  // The second try counts if it finds few, or photons that lie hardly denser. So many that they are neither make it vain, wherever the others are.
  const double reach = 3.0 * radius_;
  const double first = out.photons.empty() ? 1e-16 : static_cast<double>(out.photons.size()) / (out.radius * out.radius);
  const double vain = std::max(settings.expand_minimum + 1.0, first * (1.0 + settings.expand_increase) * reach * reach * (1.0 + 1e-9) + 1.0);
  const std::size_t too_many = vain < settings.maximum ? static_cast<std::size_t>(std::ceil(vain)) : kAny;
  const double guess = std::sqrt(1.2 * std::min(vain, static_cast<double>(settings.maximum)) / first);
  const double wider = search(center, reach, settings.maximum, too_many, guess, out.wider_search, out.wider_photons);
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
  double enough = 0.0, density = 0.0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[random() % photons_.size()];
    enough = search({position(p), Vec3(0.0)}, 1e7, gather_max, kAny, enough > 0.0 ? 1.06 * enough : typical, scratch, found);
    density += static_cast<double>(found.size()) / volume(enough);
  }
  density /= static_cast<double>(tries);
  const double ideal = media ? std::pow(3.0 * gather_max / (4.0 * kPi * density), 0.3333) : std::sqrt(gather_max / (kPi * density));
  std::size_t sparse = 0;
  for (std::size_t i = 0; i < tries; ++i) {
    const Photon& p = photons_[random() % photons_.size()];
    enough = search({position(p), Vec3(0.0)}, ideal, gather_max, kAny, 1.06 * enough, scratch, found);
    const double d = static_cast<double>(found.size()) / volume(enough);
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
