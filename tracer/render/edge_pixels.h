// Pixels that one edge goes through, between two regions whose colours the centres around show: a few samples find its place, and the mean follows from the
// parts of the pixel on either side (docs/sampling.md).
#pragma once

#include "tracer/render/block_centres.h"
#include "tracer/render/edge_model.h"
#include "tracer/render/low_discrepancy.h"

namespace verisim::render {

template <class Sampler>
class EdgePixels {
 public:
  EdgePixels(const AdaptiveSettings& settings, BlockCentres& centres, Sampler& sample) : settings_(settings), centres_(centres), sample_(sample) {}

  void clear() { pixels_.clear(), samples_.clear(); }
  void add(int x, int y) { pixels_.push_back({x, y, 0}); }

  // Sets the means of those that an edge explains; calls otherwise(x, y) for the rest. Neighbours take turns, so that they share what they find.
  template <class F>
  void work(F&& otherwise) {
    while (!pixels_.empty()) {
      for (int turn = 0; turn < 4; ++turn) {
        places_.clear(), asking_.clear();
        std::size_t kept = 0;
        for (Pixel& pixel : pixels_) {
          Verdict verdict = Verdict::asks;
          if ((pixel.x & 1) + 2 * (pixel.y & 1) == turn) {
            verdict = look(pixel);
            if (verdict == Verdict::asks) asking_.push_back(&centres_.cell(pixel.x, pixel.y));
            if (verdict == Verdict::other) otherwise(pixel.x, pixel.y);
          }
          if (verdict == Verdict::asks) pixels_[kept++] = pixel;
        }
        pixels_.resize(kept);
        sample_points(sample_, places_, colors_);
        for (std::size_t i = 0; i < places_.size(); ++i) {
          samples_.push_back({places_[i], colors_[i], as_shown(colors_[i], settings_.encoded), asking_[i]->samples});
          asking_[i]->samples = static_cast<int>(samples_.size()) - 1;
        }
      }
    }
  }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  static constexpr float kSame = 0.3f;        // of the contrast: how far a sample may be from the colour of its side
  static constexpr float kSide = 0.5f;        // weight of the deviation of the colours of one side
  static constexpr float kConfidence = 2.3f;  // standard deviations of the covered part that the tolerance is for
  static constexpr int kMost = 6;             // samples of one pixel

  struct Pixel {
    int x, y, taken;
  };
  struct Sample {
    Vec2 place;
    Color color;
    Float4 shown;
    int previous;  // in the same pixel
  };
  enum class Verdict { known, other, asks };

  struct Seen {
    float x, y;  // from the centre
    const Color* color;
    bool second = false;
  };

  // Everything that was sampled in the pixel and those around it: the nine centres first.
  int gather(int x, int y) {
    int n = 0, samples[9];
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx, ++n) {
        const int column = centres_.column(x + dx), row = centres_.row(y + dy);
        const BlockCentres::Cell& c = centres_.cell(column, row);
        seen_[n] = {static_cast<float>(dx), static_cast<float>(dy), &c.color};
        centres_.shown(column, row).store(shown_[n]);
        samples[n] = column == x + dx && row == y + dy ? c.samples : -1;
      }
    }
    for (int i : samples) {
      for (; i >= 0; i = samples_[static_cast<std::size_t>(i)].previous, ++n) {
        const Sample& s = samples_[static_cast<std::size_t>(i)];
        seen_[n] = {static_cast<float>(s.place.x - x), static_cast<float>(s.place.y - y), &s.color};
        s.shown.store(shown_[n]);
      }
    }
    return n;
  }

  // Two groups of colours: by the channel that tells them best. False: there are others, or centres show that no edge parts them.
  bool part(int n) {
    Float4 low = Float4::load(shown_[0]), high = low;
    for (int i = 1; i < n; ++i) low = min(low, Float4::load(shown_[i])), high = max(high, Float4::load(shown_[i]));
    alignas(16) float lows[4], range[4];
    low.store(lows), (high - low).store(range);
    const auto channel = std::max_element(range, range + 4) - range;
    const float contrast = range[channel], middle = lows[channel] + 0.5f * contrast;
    if (contrast <= settings_.tolerance) return false;
    int lowest = 0, highest = 0;
    centre_sides_ = 0;
    for (int i = 0; i < n; ++i) {
      const float v = shown_[i][channel];
      seen_[i].second = v > middle;
      if (i < 9) centre_sides_ |= static_cast<unsigned>(v > middle) << i;
      lowest = v < shown_[lowest][channel] ? i : lowest, highest = v > shown_[highest][channel] ? i : highest;
    }
    if (!EdgeModel::of_centres(centre_sides_).possible) return false;
    const Float4 sides[2] = {Float4::load(shown_[lowest]), Float4::load(shown_[highest])}, same(std::max(2 * settings_.tolerance, kSame * contrast));
    unsigned fits = 15;
    for (int i = 0; i < n; ++i) fits &= (distance(Float4::load(shown_[i]), seen_[i].second ? sides[1] : sides[0]) <= same).bits();
    return fits == 15;
  }

  EdgeModel::Estimate estimate(int n) {
    if (n == 9) return EdgeModel::of_centres(centre_sides_);
    model_.clear();
    for (int i = 0; i < n; ++i) model_.add(seen_[i].x, seen_[i].y, seen_[i].second);
    return model_.estimate();
  }

  Verdict look(Pixel& pixel) {
    const int n = gather(pixel.x, pixel.y);
    if (!part(n)) return Verdict::other;
    const EdgeModel::Estimate edge = estimate(n);
    if (!edge.possible) return Verdict::other;
    // The colours of the sides are those of the samples nearby.
    Color colors[2];
    float weights[2] = {0, 0};
    Float4 sums[2] = {Float4(0.0f), Float4(0.0f)}, squares[2] = {Float4(0.0f), Float4(0.0f)};
    for (int i = 0; i < n; ++i) {
      const Seen& s = seen_[i];
      const float w = 1 / (0.1f + s.x * s.x + s.y * s.y);
      const Float4 v = Float4::load(shown_[i]), weighted = v * Float4(w);
      colors[s.second] += *s.color * w, weights[s.second] += w;
      sums[s.second] = sums[s.second] + weighted, squares[s.second] = squares[s.second] + weighted * v;
    }
    for (int side = 0; side < 2; ++side) colors[side] *= 1 / weights[side];
    const Color jump = (colors[1] - colors[0]) * (kConfidence * edge.deviation);
    const Color mean = colors[0] * (1 - edge.coverage) + colors[1] * edge.coverage;
    const Float4 error = Float4(0.5f) * distance(as_shown(mean + jump, settings_.encoded), as_shown(mean - jump, settings_.encoded));
    Float4 sides(0.0f);
    for (int side = 0; side < 2; ++side) {
      const float part = side ? edge.coverage : 1 - edge.coverage;
      const Float4 one(1 / weights[side]), average = sums[side] * one;
      sides = sides + Float4(kSide * kSide * part * part) * max(Float4(0.0f), squares[side] * one - average * average);
    }
    if (!exceeds(error * error + sides, settings_.tolerance * settings_.tolerance)) {
      centres_.cell(pixel.x, pixel.y).mean = mean;
      return Verdict::known;
    }
    if (pixel.taken >= kMost) return Verdict::other;
    // In the middle of what is possible, anywhere along the edge.
    const float along = static_cast<float>(LowDiscrepancy(pixel.x, pixel.y, settings_.seed)(static_cast<std::uint32_t>(pixel.taken)).x - 0.5);
    const float x = edge.nx * edge.d - edge.ny * along, y = edge.ny * edge.d + edge.nx * along;
    places_.emplace_back(pixel.x + std::clamp(x, -0.49f, 0.49f), pixel.y + std::clamp(y, -0.49f, 0.49f));
    ++pixel.taken;
    return Verdict::asks;
  }

  static constexpr int kGathered = 9 + 9 * kMost;
  const AdaptiveSettings settings_;
  BlockCentres& centres_;
  Sampler& sample_;
  std::vector<Pixel> pixels_;
  std::vector<Sample> samples_;
  std::vector<Vec2> places_;
  std::vector<BlockCentres::Cell*> asking_;
  std::vector<Color> colors_;
  EdgeModel model_;
  unsigned centre_sides_ = 0;  // a bit for each of the nine
  std::array<Seen, kGathered> seen_;
  alignas(16) float shown_[kGathered][4];
};

}  // namespace verisim::render
