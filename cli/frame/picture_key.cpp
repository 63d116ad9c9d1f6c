#include "cli/frame/picture_key.h"

#include <fmt/format.h>

#include "cli/parts/fingerprint.h"
#include "cli/settings/reading/scene_words.h"

namespace fs = std::filesystem;

namespace verisim::cli {

// Everything the pixels depend on, for continue-trace and for parts of a picture.
std::uint64_t picture_key(const Job& job, const Frame& frame, const Region& part, const std::vector<fs::path>& files) {
  const Options& o = job.options;
  Fingerprint key;
  key.add(VERISIM_VERSION);
  for (const double value : {double(o.width),
                             double(o.height),
                             double(part.first_column),
                             double(part.last_column),
                             double(part.first_row),
                             double(part.last_row),
                             double(o.antialias),
                             double(o.sampling_method),
                             double(o.antialias_depth),
                             o.antialias_threshold,
                             o.antialias_gamma,
                             double(o.jitter),
                             o.jitter_amount,
                             double(o.quality),
                             double(o.block_size),
                             double(o.output_alpha),
                             double(o.split_unions),
                             double(o.remove_bounds),
                             double(o.objects_for_hierarchy()),
                             double(o.seed),
                             o.version,
                             frame.clock,
                             double(frame.number),
                             double(job.animation.final_frame),
                             double(job.animation.initial_frame)})
    key.add(value);
  key.add(o.sampler);
  if (o.integrator == "path") key.add("path " + std::to_string(o.path_samples) + " " + std::to_string(o.path_bounces));
  for (const auto& [name, value] : o.declarations) key.add(name + "=" + value);
  for (const fs::path& file : files) key.add_file(file);
  if (job.scene.text) key.add(*job.scene.text);
  if (o.radiosity_from_file) key.add_file(o.radiosity_file);
  return key.value();
}

// The state of a part is not that of another one.
std::uint64_t key_of_part(std::uint64_t picture, const PartChoice& part) {
  if (!part.any) return picture;
  Fingerprint key;
  key.add(static_cast<double>(picture >> 32));
  key.add(static_cast<double>(picture & 0xffffffffu));
  key.add(part.name());
  return key.value();
}

PartPicture part_picture(const Job& job, const Region& region, std::uint64_t key, const image::OutputOptions& output,
                         const std::vector<fs::path>& files) {
  const Options& options = job.options;
  PartPicture picture;
  picture.version = VERISIM_VERSION;
  picture.scene = job.scene.path.filename().string();
  for (const fs::path& file : files) {
    Fingerprint content;
    content.add_file(file);
    std::string& known = picture.files[file.filename().string()];  // files in different folders may share a name
    known += fmt::format("{}{:016x}", known.empty() ? "" : " ", content.value());
  }
  picture.key = key;
  picture.width = options.width, picture.height = options.height;
  picture.region = region;
  picture.block_size = render_options(job, region).block_size;
  picture.layers = options.layers;
  picture.format_chosen = format_chosen(options);
  picture.stamp = options.stamp;
  picture.output = output;
  return picture;
}

bool is_whole_part(const fs::path& path, const PartHeader& header) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  try {
    PartFile file(path);
    const PartChoice &there = file.header().part, &wanted = header.part;
    if (there.name() != wanted.name() || !difference(file.header().picture, header.picture).empty()) return false;
    file.check();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace verisim::cli
