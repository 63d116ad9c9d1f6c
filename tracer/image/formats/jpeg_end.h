// Is a JPEG file whole? Its library fills what is missing with grey and says nothing that a caller would hear.
#pragma once

#include <cstdio>
#include <stdexcept>

namespace verisim::image {

// Walks over the segments (ITU-T T.81, annex B) to the end-of-image marker. Throws std::runtime_error when the file
// ends before.
inline void require_whole_jpeg(std::FILE* file) {
  constexpr int kEndOfImage = 0xd9;
  const auto cut_off = [] { return std::runtime_error("the JPEG file is cut off: its end is missing"); };
  std::rewind(file);
  for (;;) {
    int byte = std::fgetc(file);
    if (byte == EOF) throw cut_off();
    if (byte != 0xff) continue;  // compressed data, or bytes between segments, which decoders pass over, too
    do byte = std::fgetc(file);
    while (byte == 0xff);
    if (byte == EOF) throw cut_off();
    if (byte == kEndOfImage) return;
    const bool alone = byte == 0 ||  // in compressed data a byte of 0xff; 0xd0 to 0xd7 restart its decoder
                       byte == 1 || (byte >= 0xd0 && byte <= 0xd8);
    if (alone) continue;
    const int high = std::fgetc(file), low = std::fgetc(file);
    if (low == EOF || std::fseek(file, high * 256 + low - 2, SEEK_CUR) != 0) throw cut_off();
  }
}

}  // namespace verisim::image
