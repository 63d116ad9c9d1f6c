// One to three numbers that change values, the same for all pixels of a part: fitted by least squares, in linear light
// or in code values as the fault would have it. The simpler of two that explain the same counts more.
#include <fmt/format.h>

#include <numeric>
#include <set>

#include "compare/causes/families.h"

namespace verisim::compare {
namespace {

constexpr double kSeveralNumbers = 0.97;  // weight of hypotheses with more than one
constexpr float kClipped = 254.5f;        // what is clipped in the test says nothing

float linear(float v) { return static_cast<float>(srgb_to_linear(std::clamp(v, 0.0f, 255.0f) / 255)); }
float coded(double v) { return static_cast<float>(255 * linear_to_srgb(std::clamp(v, 0.0, 1.0))); }
double luma(const Pixel& p) { return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]; }

// The pixels that fits look at.
std::vector<std::size_t> judged(const Case& c, const Mask* part) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < c.size(); ++i)
    if ((!part || (*part)[i]) && std::all_of(c.test[i].begin(), c.test[i].end(), [](float v) { return v < kClipped; }))
      out.push_back(i);
  return out;
}

// y = slope x (+ offset), by least squares.
struct Line {
  double xx = 0, xy = 0, x = 0, y = 0, n = 0;
  void add(double u, double v, double w = 1) { xx += w * u * u, xy += w * u * v, x += w * u, y += w * v, n += w; }
  double through_zero() const { return xx > 0 ? xy / xx : 1; }
  double slope() const { return n * xx - x * x > 1e-9 ? (n * xy - x * y) / (n * xx - x * x) : 1; }
  double offset() const { return n > 0 ? (y - slope() * x) / n : 0; }
};

class Tone {
 public:
  Tone(const Case& c, const Mask* part, std::string name, Suspicions& out)
      : c_(c), part_(part), prefix_(name.empty() ? "" : name + ": "), pixels_(judged(c, part)), out_(out) {}

  void try_all() {
    if (pixels_.size() < 3) return;
    brightness(), gamma(), offset_and_contrast(), balance(), saturation(), exchanged();
    if (!part_) inverted(), clipped(), quantised();
  }

 private:
  void add(const char* what, const std::string& detail, double weight,
           const std::function<Pixel(const Pixel&)>& change) {
    Suspicion s = c_.repaired(
        what, prefix_ + detail, [&](std::size_t i) { return change(c_.reference[i]); }, weight::kRepaired * weight,
        part_);
    s.sure *= drawn(change);
    out_.push_back(std::move(s));
  }
  // How much of what the test picture draws is drawn with it, 0..1: to make all one grey undoes the loss of an object.
  double drawn(const std::function<Pixel(const Pixel&)>& change) const {
    Pixel mean{};
    each([&](const Pixel&, const Pixel& q) {
      for (std::size_t k = 0; k < 3; ++k) mean[k] += q[k] / static_cast<float>(pixels_.size());
    });
    double all = 0, left = 0;
    each([&](const Pixel& p, const Pixel& q) {
      all += squared_distance(q, mean), left += squared_distance(change(p), q);
    });
    constexpr double kFlat = 1;  // in code values, squared: of a pixel
    return all > kFlat * static_cast<double>(pixels_.size()) ? std::clamp(1 - left / all, 0.0, 1.0) : 1;
  }
  void each(const std::function<void(const Pixel&, const Pixel&)>& f) const {
    for (std::size_t i : pixels_) f(c_.reference[i], c_.test[i]);
  }

  void brightness() {
    Line fit;
    each([&](const Pixel& p, const Pixel& q) {
      for (std::size_t k = 0; k < 3; ++k) fit.add(linear(p[k]), linear(q[k]));
    });
    const double gain = fit.through_zero();
    add("brightness",
        fmt::format("{:.1f} % {} in linear light", 100 * std::fabs(gain - 1), gain < 1 ? "darker" : "brighter"), 1,
        [&](const Pixel& p) {
          return Pixel{coded(gain * linear(p[0])), coded(gain * linear(p[1])), coded(gain * linear(p[2]))};
        });
  }

  void balance() {
    std::array<double, 3> gain{};
    for (std::size_t k = 0; k < 3; ++k) {
      Line fit;
      each([&](const Pixel& p, const Pixel& q) { fit.add(linear(p[k]), linear(q[k])); });
      gain[k] = fit.through_zero();
    }
    add("color balance",
        fmt::format("red, green and blue are {:.3f}, {:.3f} and {:.3f} times the reference's in linear light", gain[0],
                    gain[1], gain[2]),
        kSeveralNumbers, [&](const Pixel& p) {
          return Pixel{coded(gain[0] * linear(p[0])), coded(gain[1] * linear(p[1])), coded(gain[2] * linear(p[2]))};
        });
    for (std::size_t k = 0; k < 3; ++k) {
      float most = 0;
      each([&](const Pixel&, const Pixel& q) { most = std::max(most, q[k]); });
      if (most <= c_.limit && !part_)
        add("channel missing", fmt::format("there is no {}", std::array{"red", "green", "blue"}[k]), 1,
            [k](Pixel p) { return p[k] = 0, p; });
    }
  }

  void gamma() {
    Line fit;  // of the logarithms of the stored values, weighted by the values
    each([&](const Pixel& p, const Pixel& q) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double u = p[k] / 255, v = q[k] / 255;
        if (u >= 0.02 && u <= 0.98 && v >= 0.004) fit.add(std::log(u), std::log(v), u);
      }
    });
    const double exponent = fit.through_zero();
    add("gamma", fmt::format("values are the reference's to the power of {:.3f}", exponent), 1, [&](const Pixel& p) {
      Pixel q;
      for (std::size_t k = 0; k < 3; ++k)
        q[k] = 255 * static_cast<float>(std::pow(std::max(0.0f, p[k]) / 255, exponent));
      return q;
    });
    if (part_) return;
    add("gamma", "values are linear, not sRGB encoded", 1, [](const Pixel& p) {
      return Pixel{255 * linear(p[0]), 255 * linear(p[1]), 255 * linear(p[2])};
    });
    add("gamma", "values are sRGB encoded twice", 1, [](const Pixel& p) {
      return Pixel{coded(p[0] / 255), coded(p[1] / 255), coded(p[2] / 255)};
    });
  }

  void offset_and_contrast() {
    Line fit;
    each([&](const Pixel& p, const Pixel& q) {
      for (std::size_t k = 0; k < 3; ++k) fit.add(p[k], q[k]);
    });
    const auto step = static_cast<float>(fit.n > 0 ? (fit.y - fit.x) / fit.n : 0);
    add("offset", fmt::format("all values are {:.2f} code values {}", std::fabs(step), step < 0 ? "lower" : "higher"),
        1, [&](const Pixel& p) {
          return Pixel{p[0] + step, p[1] + step, p[2] + step};
        });
    const auto slope = static_cast<float>(fit.slope()), offset = static_cast<float>(fit.offset());
    add("contrast", fmt::format("stored values are {:.3f} times the reference's and {:+.1f}", slope, offset),
        kSeveralNumbers, [&](const Pixel& p) {
          return Pixel{slope * p[0] + offset, slope * p[1] + offset, slope * p[2] + offset};
        });
  }

  void saturation() {
    Line fit;
    each([&](const Pixel& p, const Pixel& q) {
      for (std::size_t k = 0; k < 3; ++k) fit.add(p[k] - luma(p), q[k] - luma(p));
    });
    const double s = fit.through_zero();
    add("saturation",
        std::fabs(s) < 0.02 ? "the picture is grey" : fmt::format("colours are {:.3f} times as far from grey", s), 1,
        [&](const Pixel& p) {
          Pixel q;
          for (std::size_t k = 0; k < 3; ++k) q[k] = static_cast<float>(luma(p) + s * (p[k] - luma(p)));
          return q;
        });
  }

  void exchanged() {
    constexpr std::array<std::array<std::size_t, 3>, 5> kOrders = {
        {{2, 1, 0}, {1, 0, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
    constexpr const char* kLetters = "rgb";
    for (const auto& o : kOrders)
      add("swapped channels",
          fmt::format("r, g, b hold the reference's {}, {}, {}", kLetters[o[0]], kLetters[o[1]], kLetters[o[2]]), 1,
          [&](const Pixel& p) {
            return Pixel{p[o[0]], p[o[1]], p[o[2]]};
          });
  }

  void inverted() {
    add("inverted", "values are 255 less the reference's", 1, [](const Pixel& p) {
      return Pixel{255 - p[0], 255 - p[1], 255 - p[2]};
    });
  }

  void clipped() {
    float most = 0;
    for (const Pixel& q : c_.test) most = std::max({most, q[0], q[1], q[2]});
    add("clipped", fmt::format("no value is above {:.0f}", most), 1, [&](const Pixel& p) {
      return Pixel{std::min(p[0], most), std::min(p[1], most), std::min(p[2], most)};
    });
  }

  void quantised() {
    constexpr std::size_t kMax = 100;
    std::set<float> levels;
    for (const Pixel& q : c_.test) {
      levels.insert(q.begin(), q.end());
      if (levels.size() > kMax) return;
    }
    std::set<float> usual;
    for (const Pixel& p : c_.reference) usual.insert(p.begin(), p.end());
    if (levels.size() < 2 || usual.size() < 2 * levels.size()) return;
    const auto nearest = [&](float v) {
      const auto above = levels.lower_bound(v);
      if (above == levels.begin()) return *above;
      const float below = *std::prev(above);
      return above == levels.end() || v - below < *above - v ? below : *above;
    };
    add("quantised", fmt::format("there are only {} different values", levels.size()), 1, [&](const Pixel& p) {
      return Pixel{nearest(p[0]), nearest(p[1]), nearest(p[2])};
    });
  }

  const Case& c_;
  const Mask* part_;
  std::string prefix_;
  std::vector<std::size_t> pixels_;
  Suspicions& out_;
};

}  // namespace

void suspect_tone(const Case& c, Suspicions& out) { Tone(c, nullptr, "", out).try_all(); }
void suspect_tone_of(const Case& c, const std::string& name, const Mask& part, Suspicions& out) {
  Tone(c, &part, name, out).try_all();
}

}  // namespace verisim::compare
