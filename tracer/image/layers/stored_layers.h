// What an OpenEXR file holds, layer by layer: the picture, depth, normals, ids, whatever programs put there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace verisim::image {

// Channels of one part whose names agree up to the last dot. Without a dot R, G, B, A and Y are one layer, the picture,
// and every other channel is one by itself.
struct StoredLayer {
  std::string name;                   // "" the picture; "N", "albedo", "Z"; of a file of several parts "part/N"
  std::vector<std::string> channels;  // what follows the dot: R G B A in this order, others by name; or the name itself
  std::vector<std::string> stored;    // their whole names
  int part = 0, width = 0, height = 0;
  bool integer = false;  // all channels are whole numbers

  bool colored() const;  // channels are R, G, B or Y, with or without A
};

bool is_exr(const std::filesystem::path& path);
// Throws std::runtime_error naming the file and the reason.
std::vector<StoredLayer> stored_layers(const std::filesystem::path& path);
// One plane a channel, row 0 at the top. Whole numbers of 32 bits are exact.
std::vector<std::vector<double>> read_layer(const std::filesystem::path& path, const StoredLayer& layer);

}  // namespace verisim::image
