#include "tests/fuzz/files.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>

#include "cli/frame/state_file.h"
#include "cli/lsp/server.h"
#include "cli/parts/part_file.h"
#include "cli/settings/ini.h"
#include "compare/compare.h"
#include "tracer/base/descriptor.h"
#include "tracer/image/density_file.h"
#include "tracer/image/image.h"
#include "tracer/image/output.h"
#include "tracer/photons/photon_map.h"
#include "tracer/radiosity/irradiance_file.h"
#include "tracer/shapes/text/truetype.h"

namespace fs = std::filesystem;

namespace verisim::fuzz {
namespace {

// Bytes under a name, in memory: /dev/shm where there is one. With an ending for those who go by it. The file of an
// ending stays and is written over: to make and remove a million files would be most of the work.
class NamedBytes {
 public:
  explicit NamedBytes(std::string_view bytes, const std::string& ending = "") : path_(path_of(ending)) {
    const auto size = static_cast<ssize_t>(bytes.size());
    const Descriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    if (::ftruncate(file.get(), size) != 0 || ::write(file.get(), bytes.data(), bytes.size()) != size) std::abort();
  }
  const fs::path& path() const { return path_; }

 private:
  static const fs::path& path_of(const std::string& ending) {
    struct Files : std::map<std::string, fs::path> {
      ~Files() {
        for (const auto& [ending, path] : *this) ::unlink(path.c_str());
      }
    };
    static Files files;
    fs::path& path = files[ending];
    std::error_code none;
    if (path.empty())
      path = (fs::is_directory("/dev/shm", none) ? "/dev/shm" : fs::temp_directory_path()) /
             ("verisim-fuzz-" + std::to_string(::getpid()) + ending);
    return path;
  }

  const fs::path& path_;
};

template <class Run>
void may_throw(Run&& run) {
  try {
    run();
  } catch (const std::runtime_error&) {
  } catch (const std::bad_alloc&) {
  }
}

}  // namespace

void image(std::string_view bytes) {
  if (bytes.empty()) return;
  constexpr const char* kEndings[] = {".gif", ".png", ".tga", ".ppm", ".pgm", ".bmp", ".jpg", ".hdr", ".tif", ".exr"};
  const std::string ending = kEndings[static_cast<unsigned char>(bytes[0]) % std::size(kEndings)];
  const NamedBytes file(bytes.substr(1), ending);
  may_throw([&] {
    const auto loaded = load_image(file.path(), image_type_from_extension(file.path().string()), {});
    for (const int x : {0, loaded->width - 1})
      for (const int y : {0, loaded->height - 1}) (void)loaded->at(x, y);
  });
}

void picture(std::string_view bytes) {
  const NamedBytes file(bytes, ".png");
  may_throw([&] { (void)image::read_picture(file.path()); });
}

void density(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] { (void)load_density_file(file.path()); });
}

void font(std::string_view bytes) {
  may_throw([&] {
    const shapes::TrueTypeFont font(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    for (const bool unicode : {false, true})
      for (const char16_t c : u"\0 Aaj\u00e4\u0410\uffff") (void)font.character(c, unicode);
    for (const std::uint16_t index : {0, 1, 2, 255, 65535}) (void)font.glyph(index), (void)font.kerning(index, 1);
  });
}

void photons(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] {
    global::PhotonMap surface, media;
    global::load_photons(file.path(), surface, media);
  });
}

void radiosity(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] { (void)global::load_samples(file.path(), 1 << 16); });
}

void ini(std::string_view bytes) {
  may_throw([&] {
    cli::Options options;
    cli::apply_ini_text(options, bytes, "", "fuzz.ini");
    cli::validate(options);
  });
}

void manifest(std::string_view bytes) {
  const NamedBytes file(bytes, ".toml");
  may_throw([&] { (void)compare::load_suite({file.path()}); });
}

void state(std::string_view bytes) {
  constexpr std::uint64_t kKey = 4711;
  // With the head that belongs to this key, or as it is.
  for (const bool own_head : {false, true}) {
    NamedBytes file("");
    render::Framebuffer frame;
    frame.width = frame.height = 64;
    frame.pixels.resize(64 * 64);
    frame.done.resize(64 * 64);
    if (own_head) {
      cli::StateFile made(file.path(), kKey, std::chrono::milliseconds(0));
      made.finished({0, 0, 1, 1}, frame);
      made.flush(frame);
    }
    if (std::FILE* more = std::fopen(file.path().c_str(), "ab")) {
      std::fwrite(bytes.data(), 1, bytes.size(), more);
      std::fclose(more);
    }
    may_throw([&] {
      cli::StateFile read(file.path(), kKey);
      (void)read.resume(frame);
    });
  }
}

void part(std::string_view bytes) {
  const NamedBytes file(bytes);
  may_throw([&] {
    cli::PartFile part(file.path());
    part.check();
  });
}

void lsp(std::string_view bytes) {
  std::string wire;
  const auto message = [&wire](std::string_view body) {
    wire.append("Content-Length: " + std::to_string(body.size()) + "\r\n\r\n").append(body);
  };
  if (bytes.starts_with('\0')) {
    wire = bytes.substr(1);
  } else {
    message(R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{}})");
    for (std::size_t at = 0; at < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
      message(bytes.substr(at, end - at));
      at = end + 1;
    }
  }
  cli::lsp::ServerSettings settings;
  settings.program = "/nonexistent";
  settings.options.limits.max_steps = 20000;
  settings.delay_ms = 0, settings.seconds = 1;
  settings.in = ::memfd_create("wire", MFD_CLOEXEC), settings.out = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (::write(settings.in, wire.data(), wire.size()) < 0 || ::lseek(settings.in, 0, SEEK_SET) != 0) std::abort();
  may_throw([&] { cli::lsp::serve(settings); });
  ::close(settings.in), ::close(settings.out);
}

}  // namespace verisim::fuzz
