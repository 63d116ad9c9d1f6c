// Every hypothesis is a one- to three-parameter change of the reference. Its parameters are fitted by least squares (or
// tried), and what it leaves of the squared difference says how much it explains. The simpler hypothesis comes first
// when two explain the same.
#include "compare/causes/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>

#include "compare/metrics/edges.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

constexpr double kConvincing = 0.5;
constexpr std::size_t kMaxSamples = 400000;  // of a large picture every n-th pixel is enough

// Pixels that are neither NaN nor clipped in any channel of either picture.
struct Samples {
  std::vector<Rgb> reference, test;
  double squares = 0;  // of the differences
};

double squared(const Rgb& a, const Rgb& b) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

Samples collect(const Values& a, const Values& b, const std::vector<unsigned char>* mask = nullptr) {
  Samples out;
  const std::size_t pixels = static_cast<std::size_t>(a.width()) * a.height(),
                    step = std::max<std::size_t>(1, pixels / kMaxSamples);
  for (std::size_t i = 0; i < pixels; i += step) {
    const int x = static_cast<int>(i % a.width()), y = static_cast<int>(i / a.width());
    if (!a.finite(x, y) || !b.finite(x, y) || (mask && !(*mask)[i])) continue;
    const Rgb p = a.rgb(x, y), q = b.rgb(x, y);
    if (std::any_of(q.begin(), q.end(), [](double v) { return v >= 254.5; })) continue;
    out.reference.push_back(p), out.test.push_back(q);
    out.squares += squared(p, q);
  }
  return out;
}

double linear(double v) { return srgb_to_linear(v / 255); }
double coded(double v) { return 255 * linear_to_srgb(std::clamp(v, 0.0, 1.0)); }

// How much is explained when `change` is applied to the reference's values.
double explained(const Samples& s, const std::function<Rgb(const Rgb&)>& change) {
  double left = 0;
  for (std::size_t i = 0; i < s.test.size(); ++i) left += squared(change(s.reference[i]), s.test[i]);
  return s.squares > 0 ? 1 - left / s.squares : 0;
}

Suspicion brightness(const Samples& s) {
  double num = 0, den = 0;  // least squares in linear light
  for (std::size_t i = 0; i < s.test.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double p = linear(s.reference[i][c]);
      num += p * linear(s.test[i][c]), den += p * p;
    }
  const double gain = den > 0 ? num / den : 1;
  return {"brightness",
          fmt::format("{:.1f} % {} in linear light", 100 * std::fabs(gain - 1), gain < 1 ? "darker" : "brighter"),
          explained(s, [&](const Rgb& v) {
            return Rgb{coded(gain * linear(v[0])), coded(gain * linear(v[1])), coded(gain * linear(v[2]))};
          })};
}

Suspicion color_balance(const Samples& s) {
  Rgb gain{1, 1, 1};
  for (int c = 0; c < 3; ++c) {
    double num = 0, den = 0;
    for (std::size_t i = 0; i < s.test.size(); ++i)
      num += linear(s.reference[i][c]) * linear(s.test[i][c]),
          den += linear(s.reference[i][c]) * linear(s.reference[i][c]);
    if (den > 0) gain[c] = num / den;
  }
  return {"color balance",
          fmt::format("red, green and blue are {:.3f}, {:.3f} and {:.3f} times the reference's in linear light",
                      gain[0], gain[1], gain[2]),
          explained(s, [&](const Rgb& v) {
            return Rgb{coded(gain[0] * linear(v[0])), coded(gain[1] * linear(v[1])), coded(gain[2] * linear(v[2]))};
          })};
}

Suspicion gamma(const Samples& s) {
  double num = 0, den = 0;  // least squares of the logarithms of the stored values, weighted by the values
  for (std::size_t i = 0; i < s.test.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double p = s.reference[i][c] / 255, q = s.test[i][c] / 255;
      if (p < 0.02 || p > 0.98 || q < 0.004) continue;
      num += p * std::log(p) * std::log(q), den += p * std::log(p) * std::log(p);
    }
  const double exponent = den > 0 ? num / den : 1;
  return {"gamma", fmt::format("values are the reference's to the power of {:.3f}", exponent),
          explained(s, [&](const Rgb& v) {
            return Rgb{255 * std::pow(v[0] / 255, exponent), 255 * std::pow(v[1] / 255, exponent),
                       255 * std::pow(v[2] / 255, exponent)};
          })};
}

Suspicion swapped(const Samples& s) {
  constexpr std::array<std::array<int, 3>, 5> kOrders = {{{2, 1, 0}, {1, 0, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}}};
  constexpr const char* kLetters = "rgb";
  Suspicion best{"swapped channels", "", -1};
  for (const auto& o : kOrders) {
    const double e = explained(s, [&](const Rgb& v) { return Rgb{v[o[0]], v[o[1]], v[o[2]]}; });
    if (e > best.explained)
      best.explained = e, best.detail = fmt::format("r, g, b hold the reference's {}, {}, {}", kLetters[o[0]],
                                                    kLetters[o[1]], kLetters[o[2]]);
  }
  return best;
}

// The reference sampled between pixels, linearly.
Rgb sample(const Values& v, double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y), u = x - fx, w = y - fy;
  const auto at = [&](double i, double j) {
    return v.rgb(static_cast<int>(std::clamp<double>(i, 0, v.width() - 1)),
                 static_cast<int>(std::clamp<double>(j, 0, v.height() - 1)));
  };
  const Rgb a = at(fx, fy), b = at(fx + 1, fy), c = at(fx, fy + 1), d = at(fx + 1, fy + 1);
  Rgb out;
  for (int k = 0; k < 3; ++k) out[k] = (1 - w) * ((1 - u) * a[k] + u * b[k]) + w * ((1 - u) * c[k] + u * d[k]);
  return out;
}

double explained_by_move(const Values& a, const Values& b, double dx, double dy) {
  const std::size_t pixels = static_cast<std::size_t>(a.width()) * a.height(),
                    step = std::max<std::size_t>(1, pixels / 20000);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < pixels; i += step) {
    const int x = static_cast<int>(i % a.width()), y = static_cast<int>(i / a.width());
    const Rgb q = b.rgb(x, y);
    before += squared(a.rgb(x, y), q), after += squared(sample(a, x - dx, y - dy), q);
  }
  return before > 0 ? 1 - after / before : 0;
}

// Without anti-aliasing an edge jumps by whole pixels: only what is blurred moves by a part of one.
Picture blurred(const Values& v) {
  constexpr int kRadius = 3;
  constexpr std::array<double, 2 * kRadius + 1> kKernel = {0.0366, 0.1113, 0.2167, 0.2708,
                                                           0.2167, 0.1113, 0.0366};  // sigma 1.5
  Picture rows;
  rows.width = v.width(), rows.height = v.height(), rows.bits = 16;
  rows.samples.resize(static_cast<std::size_t>(v.width()) * static_cast<std::size_t>(v.height()) * 3);
  Picture out = rows;
  const auto at = [&](int x, int y, std::size_t c) {
    return (static_cast<std::size_t>(std::clamp(y, 0, v.height() - 1)) * static_cast<std::size_t>(v.width()) +
            static_cast<std::size_t>(std::clamp(x, 0, v.width() - 1))) *
               3 +
           c;
  };
  for (int y = 0; y < v.height(); ++y)
    for (int x = 0; x < v.width(); ++x) {
      Rgb sum{};
      for (int i = -kRadius; i <= kRadius; ++i) {
        const Rgb p = v.rgb(std::clamp(x + i, 0, v.width() - 1), y);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += kKernel[static_cast<std::size_t>(i + kRadius)] * p[c] / 255;
      }
      for (std::size_t c = 0; c < 3; ++c) rows.samples[at(x, y, c)] = static_cast<float>(sum[c]);
    }
  for (int y = 0; y < v.height(); ++y)
    for (int x = 0; x < v.width(); ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (int i = -kRadius; i <= kRadius; ++i)
          sum += kKernel[static_cast<std::size_t>(i + kRadius)] * rows.samples[at(x, y + i, c)];
        out.samples[at(x, y, c)] = static_cast<float>(sum);
      }
  return out;
}

// Whole and half pixels first, then a descent to 1/64 pixel.
Suspicion shift(const Values& reference, const Values& test) {
  const Picture blurred_reference = blurred(reference), blurred_test = blurred(test);
  const Values a(blurred_reference), b(blurred_test);
  double best = -1e30, bx = 0, by = 0;
  const auto attempt = [&](double dx, double dy) {
    if (dx == 0 && dy == 0) return;
    if (const double e = explained_by_move(a, b, dx, dy); e > best) best = e, bx = dx, by = dy;
  };
  for (int j = -2; j <= 2; ++j)
    for (int i = -2; i <= 2; ++i) attempt(i * 0.5, j * 0.5), attempt(i, j);
  for (double step = 0.25; step > 1.0 / 100; step /= 2) {
    const double x = bx, y = by;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) attempt(x + i * step, y + j * step);
  }
  return {"shift", fmt::format("the picture is moved by {:.2f}, {:.2f} pixels (right, down)", bx, by), best};
}

Suspicion mirrored(const Values& a, const Values& b) {
  Suspicion best{"mirrored", "", -1};
  const int w = a.width(), h = a.height();
  for (const auto& [left, top, name] : {std::tuple(true, false, "left and right are exchanged"),
                                        std::tuple(false, true, "top and bottom are exchanged"),
                                        std::tuple(true, true, "the picture is turned by 180 degrees")}) {
    double before = 0, after = 0;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        const Rgb q = b.rgb(x, y);
        before += squared(a.rgb(x, y), q), after += squared(a.rgb(left ? w - 1 - x : x, top ? h - 1 - y : y), q);
      }
    const double e = before > 0 ? 1 - after / before : 0;
    if (e > best.explained) best.explained = e, best.detail = name;
  }
  return best;
}

// Not a change of the picture but a place: how much of the difference lies on edges, and on the worst 1 % of the
// pixels.
void places(const Values& a, const Values& b, std::vector<Suspicion>& out) {
  const std::vector<unsigned char> mask = edge_mask(a);
  std::vector<double> errors(mask.size());
  double total = 0, on_edges = 0, edge_pixels = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const int x = static_cast<int>(i % a.width()), y = static_cast<int>(i / a.width());
    errors[i] = squared(judged(a, b, x, y), judged(b, a, x, y));
    total += errors[i], on_edges += mask[i] ? errors[i] : 0, edge_pixels += mask[i];
  }
  if (total <= 0) return;
  const double edge_part = edge_pixels / static_cast<double>(mask.size());
  if (on_edges / total > 0.95 && edge_part < 0.7)
    out.push_back({"edges",
                   fmt::format("{:.1f} % of the squared difference lies on edges, {:.1f} % of the pixels",
                               100 * on_edges / total, 100 * edge_part),
                   on_edges / total,
                   1,
                   0,
                   {}});
  const std::size_t few = std::max<std::size_t>(1, errors.size() / 100);
  std::nth_element(errors.begin(), errors.begin() + few - 1, errors.end(), std::greater<>());
  double worst = 0;
  for (std::size_t i = 0; i < few; ++i) worst += errors[i];
  if (worst / total > 0.95)
    out.push_back({"few pixels",
                   fmt::format("1 % of the pixels holds {:.1f} % of the squared difference", 100 * worst / total),
                   worst / total,
                   1,
                   0,
                   {}});
}

// A balance of three gains contains one gain: it must be clearly better.
void leave_out_superfluous_balance(std::vector<Suspicion>& v) {
  const auto find = [&](const char* what) {
    return std::find_if(v.begin(), v.end(), [&](const Suspicion& s) { return s.what == what; });
  };
  if (1 - find("color balance")->explained > 0.5 * (1 - find("brightness")->explained)) v.erase(find("color balance"));
}

void keep_convincing(std::vector<Suspicion>& v) {
  std::erase_if(v, [](const Suspicion& s) { return !(s.explained >= kConvincing); });
  std::stable_sort(v.begin(), v.end(),
                   [](const Suspicion& x, const Suspicion& y) { return x.explained > y.explained + 1e-9; });
}

}  // namespace

std::vector<Suspicion> diagnose(const Picture& reference, const Picture& test) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  const Samples s = collect(a, b);
  std::vector<Suspicion> out;
  if (s.squares > 0) {
    out = {brightness(s), gamma(s), swapped(s), shift(a, b), mirrored(a, b), color_balance(s)};
    leave_out_superfluous_balance(out);
  }
  keep_convincing(out);
  places(a, b, out);
  for (Suspicion& named : out) named.sure = named.explained;
  return out;
}

std::vector<Suspicion> diagnose_part(const Picture& reference, const Picture& test,
                                     const std::vector<unsigned char>& mask) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  if (mask.size() != static_cast<std::size_t>(a.width()) * static_cast<std::size_t>(a.height()))
    throw PictureMismatch("the mask does not fit the pictures");
  const Samples s = collect(a, b, &mask);
  if (!(s.squares > 0)) return {};
  std::vector<Suspicion> out = {brightness(s), gamma(s), swapped(s), color_balance(s)};
  leave_out_superfluous_balance(out);
  keep_convincing(out);
  return out;
}

}  // namespace verisim::compare
