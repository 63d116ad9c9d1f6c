#include "cli/parts/part_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/parts/fingerprint.h"
#include "cli/settings/layers_option.h"
#include "compare/json_text.h"
#include "tracer/base/bytes.h"
#include "tracer/base/output_file.h"
#include "tracer/render/blocks.h"

namespace verisim::cli {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kMagic("verisim-part-1\n");
constexpr std::size_t kMaxHeader = std::size_t{1} << 24;
constexpr std::uint64_t kHeaderSeed = 2;

Json as_json(const image::OutputOptions& o) {
  return {{"format", static_cast<int>(o.format)},
          {"bits", o.bits},
          {"alpha", o.alpha},
          {"greyscale", o.greyscale},
          {"working", static_cast<int>(o.working)},
          {"working_gamma", o.working_gamma},
          {"file_srgb", o.file_srgb},
          {"file_gamma", o.file_gamma},
          {"dither", static_cast<int>(o.dither)},
          {"compression", o.compression},
          {"metadata", o.metadata}};
}

image::OutputOptions output_of(const Json& j) {
  image::OutputOptions o;
  const auto in_range = [&](const char* name, int last) {
    const int value = j.at(name).get<int>();
    if (value < 0 || value > last) throw std::runtime_error(fmt::format("an impossible {}", name));
    return value;
  };
  o.format = static_cast<image::Format>(in_range("format", static_cast<int>(image::Format::tiff)));
  o.working = static_cast<scene::Gamma>(in_range("working", static_cast<int>(scene::Gamma::srgb)));
  o.dither = static_cast<image::Dither>(in_range("dither", static_cast<int>(image::Dither::floyd_steinberg)));
  j.at("bits").get_to(o.bits);
  j.at("alpha").get_to(o.alpha);
  j.at("greyscale").get_to(o.greyscale);
  j.at("working_gamma").get_to(o.working_gamma);
  j.at("file_srgb").get_to(o.file_srgb);
  j.at("file_gamma").get_to(o.file_gamma);
  j.at("compression").get_to(o.compression);
  j.at("metadata").get_to(o.metadata);
  return o;
}

Json as_json(const PartHeader& header) {
  const PartPicture& p = header.picture;
  return {{"part", header.part.prepasses ? Json("prepass") : Json(header.part.number)},
          {"parts", header.part.of},
          {"version", p.version},
          {"scene", p.scene},
          {"files", p.files},
          {"key", fmt::format("{:016x}", p.key)},
          {"size", {p.width, p.height}},
          {"region", {p.region.first_column, p.region.first_row, p.region.last_column, p.region.last_row}},
          {"block_size", p.block_size},
          {"layers", p.layers},
          {"format_chosen", p.format_chosen},
          {"stamp", p.stamp},
          {"output", as_json(p.output)}};
}

PartHeader header_of(const Json& j) {
  PartHeader header;
  PartPicture& p = header.picture;
  header.part.any = true;
  header.part.prepasses = j.at("part") == "prepass";
  if (!header.part.prepasses) j.at("part").get_to(header.part.number);
  j.at("parts").get_to(header.part.of);
  j.at("version").get_to(p.version);
  j.at("scene").get_to(p.scene);
  j.at("files").get_to(p.files);
  p.key = std::stoull(j.at("key").get<std::string>(), nullptr, 16);
  p.width = j.at("size").at(0).get<int>(), p.height = j.at("size").at(1).get<int>();
  const Json& r = j.at("region");
  p.region = {r.at(0).get<int>(), r.at(2).get<int>(), r.at(1).get<int>(), r.at(3).get<int>()};
  j.at("block_size").get_to(p.block_size);
  j.at("layers").get_to(p.layers);
  j.at("format_chosen").get_to(p.format_chosen);
  j.at("stamp").get_to(p.stamp);
  p.output = output_of(j.at("output"));
  constexpr int kMaxPixelsASide = 1 << 20, kMaxParts = 1'000'000;
  constexpr std::int64_t kMaxBlocks = 1 << 26;
  const bool sane = p.width > 0 && p.height > 0 && p.width <= kMaxPixelsASide && p.height <= kMaxPixelsASide &&
                    p.region.first_column >= 0 && p.region.first_row >= 0 && p.region.last_column < p.width &&
                    p.region.last_row < p.height && p.block_size > 0 && header.part.of >= 1 &&
                    header.part.of <= kMaxParts && header.part.number >= 1 && header.part.number <= header.part.of &&
                    (std::int64_t{p.width} / p.block_size + 1) * (p.height / p.block_size + 1) <= kMaxBlocks;
  if (!sane) throw std::runtime_error("impossible values");
  return header;
}

std::string head_bytes(const PartHeader& header) {
  const std::string text = compare::json_text(as_json(header));
  std::string bytes(kMagic);
  put_bytes(bytes, std::uint64_t{text.size()});
  bytes += text;
  put_bytes(bytes, checksum(bytes, kHeaderSeed));
  return bytes;
}

void put(OutputFile& file, std::string_view bytes) { std::fwrite(bytes.data(), 1, bytes.size(), file.get()); }

// The blocks of an area by part. Many parts of one picture are read one after the other: the last answer is kept.
const std::vector<Block>& own_blocks(const render::Area& area, const PartHeader& header) {
  struct Dealt {
    std::array<int, 6> question{};
    std::vector<std::vector<Block>> parts;
  };
  thread_local std::array<Dealt, 2> kept;  // of pixels and of layers
  const bool region = area.width != header.picture.width || area.height != header.picture.height;
  Dealt& dealt = kept[region];
  const std::array<int, 6> question{area.x, area.y, area.width, area.height, header.picture.block_size, header.part.of};
  if (dealt.question != question) {
    dealt.parts.assign(static_cast<std::size_t>(header.part.of), {});
    const std::vector<render::Block> all = render::blocks_of(area, header.picture.block_size);
    const std::vector<int> parts = render::parts_of(all, header.part.of);
    for (std::size_t i = 0; i < all.size(); ++i)
      dealt.parts[static_cast<std::size_t>(parts[i])].push_back({all[i].x, all[i].y, all[i].width, all[i].height});
    dealt.question = question;
  }
  return dealt.parts[static_cast<std::size_t>(header.part.number - 1)];
}

}  // namespace

std::string difference(const PartPicture& a, const PartPicture& b) {
  const auto differ = [](const char* what, const auto& x, const auto& y) {
    return fmt::format("{} ({} and {})", what, x, y);
  };
  if (a.version != b.version) return differ("the version of verisim", a.version, b.version);
  if (a.scene != b.scene) return differ("the scene", a.scene, b.scene);
  if (a.width != b.width || a.height != b.height)
    return differ("the size", fmt::format("{}x{}", a.width, a.height), fmt::format("{}x{}", b.width, b.height));
  for (const auto& [name, content] : a.files) {
    const auto found = b.files.find(name);
    if (found == b.files.end()) return fmt::format("the files the scene reads ({})", name);
    if (found->second != content) return fmt::format("what is in the file {}", name);
  }
  if (a.files.size() != b.files.size()) return "the files the scene reads";
  const Json settings_a = as_json(a.output), settings_b = as_json(b.output);
  if (settings_a != settings_b) {
    const auto switches = [](const Json& j) { return j["metadata"].value("Switches", std::string()); };
    return differ("the settings", switches(settings_a), switches(settings_b));
  }
  if (a.layers != b.layers) return differ("the layers", a.layers, b.layers);
  if (as_json({a, {}}) != as_json({b, {}})) return "a setting (frame, seed, sampler ...)";
  return "";
}

std::vector<Block> part_blocks(const PartHeader& header) {
  const Region& r = header.picture.region;
  if (r.empty() || header.part.prepasses) return {};
  return own_blocks({r.first_column, r.first_row, r.last_column - r.first_column + 1, r.last_row - r.first_row + 1},
                    header);
}

std::vector<Block> part_layer_blocks(const PartHeader& header) {
  if (header.part.prepasses || !layer_choice(header.picture.layers).any) return {};
  return own_blocks({0, 0, header.picture.width, header.picture.height}, header);
}

std::vector<Block> part_places(const PartHeader& header) {
  const std::vector<Block> blocks = part_blocks(header);
  if (header.part.of == 1) return blocks;
  std::vector<render::Block> own;
  for (const Block& b : blocks) own.push_back({b.x, b.y, b.width, b.height});
  std::vector<Block> places;
  for (const render::Block& b : render::strip_of(own)) places.push_back({b.x, b.y, b.width, b.height});
  return places;
}

void write_part(const std::filesystem::path& path, const PartHeader& header, const render::Framebuffer& framebuffer,
                const render::Layers& layers) {
  OutputFile file(path);
  put(file, head_bytes(header));
  const std::vector<Block> blocks = part_blocks(header), places = part_places(header);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    put(file, color_record(blocks[i], places[i], framebuffer, header.picture.key));
  for (const Block& block : part_layer_blocks(header))
    put(file, layer_record(block, layers, header.picture.width, header.picture.key));
  file.publish();
}

void write_prepass_part(const std::filesystem::path& path, const PartHeader& header, const std::string& prepasses) {
  OutputFile file(path);
  put(file, head_bytes(header));
  std::string size, sum;
  put_bytes(size, std::uint64_t{prepasses.size()});
  put_bytes(sum, checksum(prepasses, header.picture.key));
  put(file, size), put(file, prepasses), put(file, sum);
  file.publish();
}

// ------------------------------------------------------------------------------------------------ reading

PartFile::PartFile(std::filesystem::path path) : path_(std::move(path)) {
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) fail(std::strerror(errno));
  if (!S_ISREG(status.st_mode)) fail("it is no regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::size_t before = kMagic.size() + sizeof(std::uint64_t);
  if (size < before || read(0, kMagic.size()) != kMagic) fail("it is no part of a picture (verisim render --part)");
  const auto header_bytes = ByteSource(read(kMagic.size(), 8)).take<std::uint64_t>();
  if (header_bytes > kMaxHeader || before + header_bytes + 8 > size) fail("it ends too early: render the part again");
  const std::string head = read(0, before + header_bytes);
  if (ByteSource(read(head.size(), 8)).take<std::uint64_t>() != checksum(head, kHeaderSeed))
    fail("its header is damaged: render the part again");
  std::string version, damage;
  try {
    const Json described = compare::parse_json(head.substr(before));
    described.at("version").get_to(version);
    if (version == VERISIM_VERSION) {
      header_ = header_of(described);
      blocks_ = part_blocks(header_), layer_blocks_ = part_layer_blocks(header_);
      layer_bytes_ = layer_bytes(layer_choice(header_.picture.layers).layers);
    }
  } catch (const std::exception& error) {
    damage = error.what();
  }
  if (!damage.empty()) fail("its header is damaged: " + damage);
  if (version != VERISIM_VERSION)
    fail(fmt::format("it was made by verisim {}, and this is verisim {}", version, VERISIM_VERSION));
  body_ = head.size() + 8;
  std::uint64_t at = body_;
  for (const Block& block : blocks_) offsets_.push_back(at), at += record_bytes(block, kColorBytes);
  for (const Block& block : layer_blocks_) layer_offsets_.push_back(at), at += record_bytes(block, layer_bytes_);
  if (header_.part.prepasses) {
    if (at + 16 > size) fail("it ends too early: render the part again");
    const auto bytes = ByteSource(read(at, 8)).take<std::uint64_t>();
    at = bytes > size ? size + 1 : at + 16 + bytes;
  }
  if (at > size) fail("it ends too early: render the part again");
  if (at < size) fail("there is more in it than there should be: render the part again");
}

void PartFile::fail(const std::string& why) const {
  throw std::runtime_error(fmt::format("cannot use '{}': {}", path_.string(), why));
}

std::string PartFile::read(std::uint64_t at, std::size_t bytes) {
  if (!file_) file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file_) fail(std::strerror(errno));
  std::string text(bytes, '\0');
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t count = ::pread(file_.get(), text.data() + done, bytes - done, static_cast<off_t>(at + done));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(std::strerror(errno));
    if (count == 0) fail("it ends too early: render the part again");
    done += static_cast<std::size_t>(count);
  }
  return text;
}

std::string PartFile::record(std::uint64_t at, const Block& block, std::size_t pixel_bytes) {
  std::string bytes = read(at, record_bytes(block, pixel_bytes));
  const PartPicture& picture = header_.picture;
  if (block_of_head(bytes, picture.width, picture.height) != block || !record_is_whole(bytes, picture.key))
    fail(fmt::format("it is damaged (block of {}x{} pixels at {}, {}): render the part again", block.width,
                     block.height, block.x, block.y));
  return bytes;
}

std::string PartFile::color_record(std::size_t number) {
  return record(offsets_[number], blocks_[number], kColorBytes);
}
std::string PartFile::layer_record(std::size_t number) {
  return record(layer_offsets_[number], layer_blocks_[number], layer_bytes_);
}

std::string PartFile::prepasses() {
  if (!header_.part.prepasses)
    fail("it holds " + header_.part.name() + " of a picture, not the prepasses (--part prepass)");
  const auto bytes = static_cast<std::size_t>(ByteSource(read(body_, 8)).take<std::uint64_t>());
  std::string data = read(body_ + 8, bytes);
  if (ByteSource(read(body_ + 8 + bytes, 8)).take<std::uint64_t>() != checksum(data, header_.picture.key))
    fail("it is damaged: render the prepasses again");
  return data;
}

void PartFile::check() {
  for (std::size_t i = 0; i < blocks_.size(); ++i) color_record(i);
  for (std::size_t i = 0; i < layer_blocks_.size(); ++i) layer_record(i);
  if (header_.part.prepasses) prepasses();
}

}  // namespace verisim::cli
