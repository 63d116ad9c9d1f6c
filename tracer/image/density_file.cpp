#include "tracer/image/density_file.h"

#include <fstream>
#include <stdexcept>

#include "tracer/image/shared_files.h"

namespace verisim {

namespace {

scene::DensityFileParams read_density_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("Cannot open density file '" + path.string() + "'.");
  unsigned char header[6];
  if (!in.read(reinterpret_cast<char*>(header), sizeof header))
    throw std::runtime_error("Density file '" + path.string() + "' ends in its header.");
  scene::DensityFileParams result;
  std::uint64_t count = 1;
  for (int i = 0; i < 3; ++i) {
    result.size[i] = header[2 * i] << 8 | header[2 * i + 1];
    count *= static_cast<std::uint64_t>(result.size[i]);
  }
  const std::uint64_t bytes = std::filesystem::file_size(path) - sizeof header;
  if (count == 0 || (bytes != count && bytes != 2 * count && bytes != 4 * count))
    throw std::runtime_error("Invalid density file size: '" + path.string() +
                             "' does not hold 1, 2 or 4 bytes a sample.");
  result.bytes = static_cast<int>(bytes / count);
  // The samples cannot outnumber the bytes of the file, so a hostile header takes no memory.
  std::vector<unsigned char> raw(bytes);
  if (!in.read(reinterpret_cast<char*>(raw.data()), static_cast<std::streamsize>(bytes)))
    throw std::runtime_error("Density file '" + path.string() + "' is shorter than its header says.");
  auto samples = std::make_shared<std::vector<std::uint32_t>>(count);
  const unsigned char* next = raw.data();
  for (std::uint32_t& sample : *samples) {
    sample = 0;
    for (int i = 0; i < result.bytes; ++i) sample = sample << 8 | *next++;
  }
  result.samples = samples;
  return result;
}

}  // namespace

scene::DensityFileParams load_density_file(const std::filesystem::path& path) {
  static image::SharedFiles<scene::DensityFileParams> files;
  const auto shared =
      files.get(path, "df3", [&] { return std::make_shared<scene::DensityFileParams>(read_density_file(path)); });
  scene::DensityFileParams result = *shared;
  result.samples = std::shared_ptr<const std::vector<std::uint32_t>>(
      shared, shared->samples.get());  // whoever has the samples keeps the file known
  return result;
}

}  // namespace verisim
