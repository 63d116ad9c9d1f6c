#include "compare/regression/stored_variance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "compare/metrics/rounding.h"
#include "compare/metrics/values.h"
#include "compare/verdict/verdict.h"
#include "compare/verdict/welch.h"
#include "compare/regression/passes.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

constexpr double kLevel = 0.01, kMaxNoisyPixels = 0.0025, kMaxBlocks = 0.02;
constexpr int kNoiseBlock = 16;
constexpr const char* kMark = ".deviation-of-";

// The level of one of many tests which together err as often as kLevel says.
double each_of(double tests) { return -std::expm1(std::log1p(-kLevel) / tests); }

double predicted(double difference, double variance, int runs) {
  return student_two_sided(difference / std::sqrt(variance * (1 + 1.0 / runs)), runs - 1);
}

}  // namespace

fs::path deviation_file(const fs::path& picture) {
  const std::string start = picture.stem().string() + kMark;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(picture.parent_path(), ignored))
    if (entry.path().filename().string().starts_with(start)) return entry.path();
  return {};
}

std::optional<StoredVariance> read_stored_variance(const fs::path& picture) {
  const fs::path file = deviation_file(picture);
  if (file.empty()) return std::nullopt;
  const std::string name = file.stem().string();
  StoredVariance out{image::read_picture(picture), image::read_picture(file),
                     std::atoi(name.c_str() + name.rfind('-') + 1)};
  require_same_size(out.mean, out.deviation);
  if (out.runs < 2) throw std::runtime_error(file.string() + ": its name must say of how many runs it is, at least 2");
  return out;
}

void write_stored_variance(const std::vector<Picture>& runs, const fs::path& picture) {
  Picture mean = mean_of(runs), deviation = mean;
  const auto n = static_cast<double>(runs.size());
  for (std::size_t i = 0; i < mean.samples.size(); ++i) {
    double sum = 0;
    for (const Picture& run : runs) sum += std::pow(run.samples[i] - mean.samples[i], 2);
    deviation.samples[i] = static_cast<float>(std::sqrt(sum / (n - 1)));
  }
  if (const fs::path old = deviation_file(picture); !old.empty()) fs::remove(old);
  mean.bits = deviation.bits = 16, mean.is_float = deviation.is_float = false;
  write_16_bits(mean, picture);
  write_16_bits(deviation,
                picture.parent_path() / fmt::format("{}{}{}.png", picture.stem().string(), kMark, runs.size()));
}

ZTest z_test(const StoredVariance& stored, const Picture& render) {
  require_same_size(stored.mean, render);
  const Values mean(stored.mean), deviation(stored.deviation), test(render);
  const int width = mean.width(), height = mean.height();
  ZTest out;
  const double level = each_of(static_cast<double>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double variance = std::max(kRoundingVariance, std::pow(deviation.luma(x, y), 2));
      const double p = predicted(test.luma(x, y) - mean.luma(x, y), variance, stored.runs);
      out.pixels_refused += p < level;
      out.p.push_back(static_cast<float>(p));
    }
  out.pixels_refused /= static_cast<double>(out.p.size());
  double blocks = 0, refused = 0;
  const double block_level = each_of(std::ceil(width / static_cast<double>(kNoiseBlock)) *
                                     std::ceil(height / static_cast<double>(kNoiseBlock)));
  for (int top = 0; top < height; top += kNoiseBlock)
    for (int left = 0; left < width; left += kNoiseBlock) {
      double difference = 0, variance = 0, count = 0;
      for (int y = top; y < std::min(height, top + kNoiseBlock); ++y)
        for (int x = left; x < std::min(width, left + kNoiseBlock); ++x) {
          difference += test.luma(x, y) - mean.luma(x, y);
          variance += std::max(kRoundingVariance, std::pow(deviation.luma(x, y), 2)), ++count;
        }
      // Neighbours' noise may go together: as if four pixels were one.
      ++blocks, refused += predicted(difference / count, 4 * variance / (count * count), stored.runs) < block_level;
    }
  out.blocks_refused = refused / blocks;
  out.rejected = out.pixels_refused > kMaxNoisyPixels || out.blocks_refused > kMaxBlocks;
  return out;
}

std::string ZTest::text() const {
  return fmt::format("{} the stored noise: {:.3f} % of the pixels and {:.2f} % of the blocks are improbable",
                     rejected ? "not within" : "within", 100 * pixels_refused, 100 * blocks_refused);
}

}  // namespace verisim::compare
