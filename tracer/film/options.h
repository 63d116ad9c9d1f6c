// What is asked of a render, beside the scene (spec 02).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

namespace verisim::render {

struct Layers;  // tracer/film/layers.h

// How samples are placed: POV-Ray's ways, or low-discrepancy samples with error control (docs/sampling.md).
enum class Sampler : std::uint8_t { povray, adaptive };

struct Options {
  int width = 160, height = 120;  // pixels
  // The part of the picture that is made: pixels, inclusive, from 0; -1: to the edge.
  int first_column = 0, last_column = -1, first_row = 0, last_row = -1;
  bool antialias = false;
  int sampling_method = 1;  // 1 or 2, POV-Ray's +AM
  int antialias_depth = 3;  // POV-Ray's +R: method 1 takes depth^2 samples of a pixel, method 2 halves its sides
  Sampler sampler = Sampler::povray;  // adaptive takes the place of the methods; threshold and depth keep their meaning
  float antialias_threshold = 0.3f;   // of the sum of the channels' differences, each after antialias_gamma
  double antialias_gamma = 2.5;       // an exponent: values are compared as v^(1 / gamma)
  bool jitter = true;
  double jitter_amount = 1;  // of the distance between samples
  int quality = 9;           // 0 to 11, what is computed at all (spec 06 section 12)
  int block_size = 32;       // pixels, width and height of what a thread draws at once
  // One of several parts of the picture, numbered from 0, for other machines to make the rest: the blocks that
  // parts_of() (tracer/render/blocks.h) deals out to it. Pixels of other blocks stay as they are.
  int part = 0, parts = 1;
  int threads = 0;            // of this render; 0: one for each core
  bool output_alpha = false;  // POV-Ray's +UA: decides how backgrounds behave
  bool split_unions = false, remove_bounds = true;
  int bounding_threshold = 3;  // objects; of fewer POV-Ray makes no hierarchy (accel::Arrangement)
  bool replay = false;         // serial, with POV-Ray's random streams in POV-Ray's order: equals `povray +WT1`
  std::uint64_t seed = 0;
  // Radiosity samples from and to a file in POV-Ray's format (+RFI, +RFO); empty: none. Only heeded by scenes with
  // radiosity.
  std::string radiosity_from, radiosity_to;
  // Unbiased path tracing instead of POV-Ray's algorithms: the converged picture, not POV-Ray's look
  // (docs/path-tracing.md). Off: 0 samples per pixel.
  int path_samples = 0;
  int path_bounces = 64;  // no path is longer; Russian roulette ends most earlier
  // Null, or filled with what the camera's rays meet first (depth, normals ...), beside the picture.
  Layers* layers = nullptr;
  // Called from one thread at a time with the fraction done, 0..1.
  std::function<void(double)> progress;
  // Null, or where rays are counted while the picture is made, for `progress` to tell.
  std::atomic<std::uint64_t>* rays = nullptr;
  // The same for the passes before the picture: which one ("photons", "radiosity pretrace"), and the fraction of it
  // that is done. Null: nobody asks.
  std::function<void(const char*, double)> pass_progress;
  // What the passes before the picture found, from an earlier render of the same scene with the same options, in the
  // place of those passes (null: they are made); and where to put it (null: nowhere): then no picture is made.
  const std::string* prepasses_from = nullptr;
  std::string* prepasses_to = nullptr;
  // Photons and radiosity samples may take so many bytes; more ends the render with LimitExceeded.
  std::uint64_t pass_memory = std::uint64_t{4} << 30;
  // The process ends after this render: what the scene was compiled to is not freed.
  bool last_of_process = false;
  // Set to true from anywhere (a signal handler) to stop; finished blocks stay in the framebuffer.
  std::atomic<bool>* cancel = nullptr;
  // Called when a block is finished (x, y, width, height), possibly from several threads; for continue-trace.
  std::function<void(int, int, int, int)> block_done;
  // Asked once for each block (x, y, width, height) before it is started, possibly from several threads; true: its
  // pixels are already in the framebuffer (continue-trace) and stay as they are. Blocks are independent, so the picture
  // is the same as without it.
  std::function<bool(int, int, int, int)> block_known;
};

}  // namespace verisim::render
