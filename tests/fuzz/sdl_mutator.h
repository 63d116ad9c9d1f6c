// Changes to scenes that leave them nearly scenes: whole blocks and statements lost, doubled, exchanged and nested,
// words replaced by others that may stand in their place by the table of keywords, numbers by odd ones. What a fuzzer
// of bytes finds only by luck.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace verisim::fuzz {

// `other`: a scene that blocks may be taken from. The same seed makes the same change.
std::string mutate_scene(std::string_view scene, std::string_view other, std::uint32_t seed);

}  // namespace verisim::fuzz
