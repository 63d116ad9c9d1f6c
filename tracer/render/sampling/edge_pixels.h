// Pixels that one edge goes through, between two regions whose colours the centres around show: a few samples find its
// place, and the mean follows from the parts of the pixel on either side (docs/sampling.md).
#pragma once

#include "tracer/render/sampling/block_centres.h"
#include "tracer/render/sampling/edge_model.h"
#include "tracer/render/sampling/low_discrepancy.h"

namespace verisim::render {

template <class Sampler>
class EdgePixels {
 public:
  EdgePixels(const AdaptiveSettings& settings, BlockCentres& centres, Sampler& sample)
      : settings_(settings), centres_(centres), sample_(sample) {
    for (int k = 0; k < 9; ++k) seen_[k] = seen_at(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 - 1));
  }

  void clear() { pixels_.clear(), samples_.clear(); }
  void add(int x, int y) { pixels_.push_back({x, y, 0}); }

  // Sets the means of those that an edge explains; calls otherwise(x, y) for the rest. Neighbours take turns, so that
  // they share what they find.
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
          const Float4 color = channels(colors_[i]);
          samples_.push_back({places_[i], color, as_shown(color, settings_.encoded), asking_[i]->samples});
          asking_[i]->samples = static_cast<int>(samples_.size()) - 1;
        }
      }
    }
  }

 private:
  // Found by measurement over a dozen scenes (bench/sampling); none of them is critical.
  static constexpr float kSame = 0.4f;        // of the contrast: how far a sample may be from the colour of its side
  static constexpr float kSide = 0.5f;        // weight of the deviation of the colours of one side
  static constexpr float kConfidence = 2.3f;  // standard deviations of the covered part that the tolerance is for
  static constexpr int kMax = 6;              // samples of one pixel

  struct Pixel {
    int x, y, taken;
  };
  struct Sample {
    Vec2 place;
    Float4 color, shown;
    int previous;  // in the same pixel
  };
  enum class Verdict { known, other, asks };

  struct Seen {
    float x, y;    // from the centre
    float weight;  // of its colour for that of its side: samples nearby tell it best
    bool second = false;
    const Float4* color = nullptr;
  };
  static Seen seen_at(float x, float y) { return {x, y, 1 / (0.1f + x * x + y * y)}; }

  // Everything that was sampled in the pixel and those around it: the nine centres first, whose places are known.
  int gather(int x, int y) {
    int n = 0, samples[9];
    if (centres_.inside(x - 1, y - 1) && centres_.inside(x + 1, y + 1)) {
      for (int row = y - 1; row <= y + 1; ++row) {
        const BlockCentres::Cell* const cells = &centres_.cell(x - 1, row);
        const Float4* const shown = &centres_.shown(x - 1, row);
        for (int k = 0; k < 3; ++k, ++n)
          seen_[n].color = &cells[k].color, shown[k].store(shown_[n]), samples[n] = cells[k].samples;
      }
    } else {
      for (; n < 9; ++n) {
        const int there_x = x + n % 3 - 1, there_y = y + n / 3 - 1, column = centres_.column(there_x),
                  row = centres_.row(there_y);
        seen_[n].color = &centres_.cell(column, row).color;
        centres_.shown(column, row).store(shown_[n]);
        samples[n] = centres_.inside(there_x, there_y) ? centres_.cell(column, row).samples : -1;
      }
    }
    for (int i : samples) {
      for (; i >= 0; i = samples_[static_cast<std::size_t>(i)].previous, ++n) {
        const Sample& s = samples_[static_cast<std::size_t>(i)];
        seen_[n] = seen_at(static_cast<float>(s.place.x - x), static_cast<float>(s.place.y - y));
        seen_[n].color = &s.color;
        s.shown.store(shown_[n]);
      }
    }
    return n;
  }

  // Two groups of colours: by the channel that tells them best. False: there are others, or centres show that no edge
  // parts them.
  bool part(int n) {
    Float4 low = Float4::load(shown_[0]), high = low;
    for (int i = 1; i < n; ++i) low = min(low, Float4::load(shown_[i])), high = max(high, Float4::load(shown_[i]));
    alignas(16) float lows[4], range[4];
    low.store(lows), (high - low).store(range);
    const auto channel = std::max_element(range, range + 4) - range;
    const float contrast = range[channel], middle = lows[channel] + 0.5f * contrast;
    if (contrast <= settings_.tolerance) return false;
    centre_sides_ = 0;
    for (int i = 0; i < n; ++i) seen_[i].second = shown_[i][channel] > middle;
    for (int i = 0; i < 9; ++i) centre_sides_ |= static_cast<unsigned>(seen_[i].second) << i;
    if (!EdgeModel::of_centres(centre_sides_).estimate.possible) return false;
    Float4 lowest[2] = {high, high}, highest[2] = {low, low};
    for (int i = 0; i < n; ++i) {
      const Float4 v = Float4::load(shown_[i]);
      const bool side = seen_[i].second;
      lowest[side] = min(lowest[side], v), highest[side] = max(highest[side], v);
    }
    return !exceeds(max(highest[0] - lowest[0], highest[1] - lowest[1]),
                    std::max(2 * settings_.tolerance, kSame * contrast));
  }

  EdgeModel::Estimate estimate(int n) const {
    const EdgeModel::Centres& centres = EdgeModel::of_centres(centre_sides_);
    if (n == 9) return centres.estimate;
    EdgeModel model = centres.model;
    for (int i = 9; i < n; ++i) model.add(seen_[i].x, seen_[i].y, seen_[i].second);
    return model.estimate();
  }

  Verdict look(Pixel& pixel) {
    const int n = gather(pixel.x, pixel.y);
    if (!part(n)) return Verdict::other;
    const EdgeModel::Estimate edge = estimate(n);
    if (!edge.possible) return Verdict::other;
    // The colours of the sides are those of the samples nearby.
    struct {
      Float4 color{0.0f}, shown{0.0f}, squares{0.0f};
      float weight = 0;
    } sides[2];
    for (int i = 0; i < n; ++i) {
      const Seen& s = seen_[i];
      auto& side = sides[s.second];
      const Float4 w(s.weight), v = Float4::load(shown_[i]);
      side.color = side.color + w * *s.color, side.shown = side.shown + w * v, side.squares = side.squares + w * v * v;
      side.weight += s.weight;
    }
    Float4 variance(0.0f);
    for (int i = 0; i < 2; ++i) {
      const float part = i ? edge.coverage : 1 - edge.coverage;
      const Float4 one(1 / sides[i].weight), average = one * sides[i].shown;
      variance = variance +
                 Float4(kSide * kSide * part * part) * max(Float4(0.0f), one * sides[i].squares - average * average);
      sides[i].color = one * sides[i].color;
    }
    const Float4 jump = sides[1].color - sides[0].color, mean = sides[0].color + Float4(edge.coverage) * jump,
                 off = Float4(kConfidence * edge.deviation) * jump;
    const Float4 error =
        Float4(0.5f) * distance(as_shown(mean + off, settings_.encoded), as_shown(mean - off, settings_.encoded));
    if (!exceeds(error * error + variance, settings_.tolerance * settings_.tolerance)) {
      centres_.cell(pixel.x, pixel.y).mean = mean;
      return Verdict::known;
    }
    if (pixel.taken >= kMax) return Verdict::other;
    // In the middle of what is possible, anywhere along the edge.
    const float along = static_cast<float>(
        LowDiscrepancy(pixel.x, pixel.y, settings_.seed)(static_cast<std::uint32_t>(pixel.taken)).x - 0.5);
    const float x = edge.nx * edge.d - edge.ny * along, y = edge.ny * edge.d + edge.nx * along;
    places_.emplace_back(pixel.x + std::clamp(x, -0.49f, 0.49f), pixel.y + std::clamp(y, -0.49f, 0.49f));
    ++pixel.taken;
    return Verdict::asks;
  }

  static constexpr int kGathered = 9 + 9 * kMax;
  const AdaptiveSettings settings_;
  BlockCentres& centres_;
  Sampler& sample_;
  std::vector<Pixel> pixels_;
  std::vector<Sample> samples_;
  std::vector<Vec2> places_;
  std::vector<BlockCentres::Cell*> asking_;
  std::vector<Color> colors_;
  unsigned centre_sides_ = 0;  // a bit for each of the nine
  std::array<Seen, kGathered> seen_;
  alignas(16) float shown_[kGathered][4];
};

}  // namespace verisim::render
