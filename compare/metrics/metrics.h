// How far one picture is from another: plain functions over image::Picture.
//
// Unless said otherwise figures are in 8-bit units (0..255) and taken over the colour channels; grey pictures are
// widened to three channels. Pictures of floats are brought to 8-bit units by the sRGB curve, two of them without
// clipping (values.h). The first picture is always the reference (the oracle), the second the one under test.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tracer/image/output.h"

namespace verisim::compare {

using image::Picture;

// The two pictures cannot be compared (sizes differ, no pixels).
struct PictureMismatch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct WorstPixel {
  int x = 0, y = 0;
  double error = 0;                           // largest difference over the channels
  std::array<double, 4> reference{}, test{};  // r g b a, 8-bit units
};

// Of a set of pixels: how many are brighter than they should be, and how many are darker.
struct SignTest {
  static constexpr double kSmallest = 0.03;  // code values: less is rounding, of another machine for instance
  std::uint64_t pixels = 0, brighter = 0, darker = 0;

  static int side(double difference) { return difference > kSmallest ? 1 : difference < -kSmallest ? -1 : 0; }
  void add(double difference) { ++pixels, brighter += side(difference) > 0, darker += side(difference) < 0; }
  void add(const SignTest& other) { pixels += other.pixels, brighter += other.brighter, darker += other.darker; }
  // How many more go to one side than to the other, as a part of all.
  double share() const;
  // More than `limit` of the pixels go to one side, and by chance that would not happen.
  bool leans(double limit) const;
};

// JSON has no infinity, and one figure should be the same in every report.
inline constexpr double kPsnrOfEqualPictures = 999;

struct Metrics {
  int width = 0, height = 0;
  double max_abs = 0, mae = 0, rmse = 0;
  double psnr = 0;  // dB
  double within_1_pct = 0,
         within_2_pct = 0;              // pixels whose every channel (alpha, too, when compared) is at most 1 (2) away
  double bias = 0;                      // mean of test - reference
  double ssim_mean = 0;                 // 11x11 Gaussian window, sigma 1.5, on luma (Wang et al. 2004)
  double ssim_block_min = 0;            // the worst 8x8 block
  double flip_mean = 0;                 // LDR-FLIP
  std::optional<double> hdr_flip_mean;  // when both are float pictures
  double ciede2000_mean = 0, ciede2000_p95 = 0;
  std::optional<double> edge_rmse, interior_rmse;   // empty when there is no edge (no interior) pixel
  double edge_pct = 0;                              // pixels that count as edge
  std::optional<double> alpha_max_abs, alpha_rmse;  // when either picture has alpha
  std::uint64_t solid_2_pixels = 0,
                solid_4_pixels = 0;      // pixels in solid patches of errors above 2 (4) code values (patches.h)
  int solid_x = 0, solid_y = 0;          // the middle of the worst one
  double drift_max = 0;                  // largest mean difference of 16x16 pixels, each clipped to one code value
  int drift_x = 0, drift_y = 0;          // where
  std::uint64_t one_sided_pixels = 0;    // the most connected pixels that go to one side, by however little
  int one_sided_x = 0, one_sided_y = 0;  // one of them
  SignTest signs;                        // of all pixels, in the channel that leans most
  bool fine = false;  // both pictures hold more than 8 bits: differences below a code value can be told from rounding
  std::uint64_t nan_pixels = 0;  // NaN or infinite in either picture: never within anything, left out of the means
  std::array<std::uint64_t, 256> histogram{};  // pixels by their largest channel difference, rounded
  std::vector<WorstPixel> worst;               // the largest differences, at least 3 pixels apart from each other
};

struct MetricOptions {
  double flip_pixels_per_degree = 67.0206;  // 0.7 m in front of a 0.7 m wide screen with 3840 pixels
  bool alpha = true;
  int worst_pixels = 20;
  int band_rows =
      0;  // rows that are worked on at a time, a multiple of 64; 0: by the width. The figures do not depend on it
  std::function<void(double done)> progress;  // 0 to 1, now and then
};

// Throws PictureMismatch.
Metrics measure(const Picture& reference, const Picture& test, const MetricOptions& options = {});
// Two files; PNG files are read by bands of rows, so that they may be larger than the memory. Also throws
// std::runtime_error when a file cannot be read. The sizes are compared before any pixel is read.
Metrics measure_files(const std::filesystem::path& reference, const std::filesystem::path& test,
                      const MetricOptions& options = {});

// Memory that two pictures of this size take while they are compared, about; and what the machine has to give (0:
// unknown).
std::uint64_t measure_bytes(std::uint64_t pixels, int channels);
std::uint64_t available_bytes();
// Throws PictureMismatch when it is not enough (limit 0: what is available): better than to be killed by the system.
void require_memory(std::uint64_t pixels, int channels, std::uint64_t limit = 0);

}  // namespace verisim::compare
