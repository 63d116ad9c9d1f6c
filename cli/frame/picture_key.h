// Which picture a render makes: by this, continue-trace and parts of pictures know each other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "cli/frame/job.h"
#include "cli/parts/part_file.h"
#include "cli/settings/part_option.h"
#include "tracer/image/output.h"

namespace verisim::cli {

// A number of everything the pixels depend on: settings, this version, and the content of the files that were read.
std::uint64_t picture_key(const Job& job, const Frame& frame, const Region& region,
                          const std::vector<std::filesystem::path>& files);

// The state of a part is not that of another one.
std::uint64_t key_of_part(std::uint64_t picture, const PartChoice& part);

// The picture as the files of its parts name it.
PartPicture part_picture(const Job& job, const Region& region, std::uint64_t key, const image::OutputOptions& output,
                         const std::vector<std::filesystem::path>& files);

// Whether the file is that part of that picture, from beginning to end.
bool is_whole_part(const std::filesystem::path& path, const PartHeader& header);

}  // namespace verisim::cli
