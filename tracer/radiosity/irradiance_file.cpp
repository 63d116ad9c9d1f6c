#include "tracer/radiosity/irradiance_file.h"

#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "tracer/base/output_file.h"

namespace verisim::global {
namespace {

constexpr int kMaxDepths = 20;  // recursion_limit's largest value

// A direction in three bytes: -1..1 to 0..254.
unsigned encode(double n) { return static_cast<unsigned>(std::clamp((n + 1.0) * 0.5 * 254.0 + 0.499999, 0.0, 255.0)); }
double decode(unsigned byte) { return byte * (2.0 / 254.0) - 1.0; }

unsigned encode(const Vec3& v) { return encode(v.x) << 16 | encode(v.y) << 8 | encode(v.z); }

// Unit again after rounding; nearly zero stays "no direction".
Vec3 decode_direction(unsigned hex) {
  const Vec3 v(decode(hex >> 16 & 255), decode(hex >> 8 & 255), decode(hex & 255));
  const double size = length(v);
  return size < 0.5 ? Vec3(0, 0, 0) : v / size;
}

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};

void print(std::span<const IrradianceSample> samples, std::FILE* file) {
  for (const IrradianceSample& s : samples) {
    std::fprintf(file, "C%d\t%g\t%g\t%g\t%06x\t%.4f\t%.4f\t%.4f\t%g\t%g\t%06x\n", s.depth + 1, s.point.x, s.point.y,
                 s.point.z, encode(s.normal), static_cast<double>(s.irradiance.r), static_cast<double>(s.irradiance.g),
                 static_cast<double>(s.irradiance.b), static_cast<double>(s.mean_distance),
                 static_cast<double>(s.nearest_distance), encode(s.nearest_direction));
  }
}

}  // namespace

void save_samples(const std::filesystem::path& path, std::span<const IrradianceSample> samples, bool append) {
  if (!append) {
    OutputFile file(path);
    print(samples, file.get());
    return file.publish();
  }
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "a"));
  if (file) print(samples, file.get());
  if (!file || std::fflush(file.get()) != 0 || std::ferror(file.get()))
    throw std::runtime_error("cannot write radiosity file " + path.string());
}

std::vector<IrradianceSample> load_samples(const std::filesystem::path& path, std::size_t most) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read radiosity file " + path.string());
  std::vector<IrradianceSample> samples;
  std::string line;
  line.resize(1024);  // longer lines are none of ours
  for (std::size_t number = 1;
       file.getline(line.data(), static_cast<std::streamsize>(line.size())) || file.gcount() > 0; ++number) {
    const auto fail = [&](const char* what) {
      return std::runtime_error("radiosity file " + path.string() + ", line " + std::to_string(number) + ": " + what);
    };
    if (file.fail()) throw fail("too long");
    if (line[0] != 'C') continue;
    int depth = 0, read = 0;
    unsigned normal = 0, direction = 0;
    IrradianceSample s;
    double mean = 0, nearest = 0, r = 0, g = 0, b = 0;
    read = std::sscanf(line.c_str(), "C%d %lf %lf %lf %6x %lf %lf %lf %lf %lf %6x", &depth, &s.point.x, &s.point.y,
                       &s.point.z, &normal, &r, &g, &b, &mean, &nearest, &direction);
    if (read != 11) throw fail("not a sample");
    const bool sane = depth >= 1 && depth <= kMaxDepths && std::isfinite(s.point.x + s.point.y + s.point.z) &&
                      std::isfinite(r + g + b) && mean > 0 && nearest >= 0 && std::isfinite(mean + nearest);
    if (!sane) throw fail("impossible values");
    if (samples.size() >= most) throw fail("more samples than memory is allowed for");
    s.depth = static_cast<std::int16_t>(depth - 1);
    s.normal = decode_direction(normal);
    if (s.normal == Vec3(0, 0, 0)) throw fail("a normal without direction");
    s.nearest_direction = decode_direction(direction);
    s.irradiance = {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
    s.mean_distance = static_cast<float>(mean), s.nearest_distance = static_cast<float>(nearest);
    samples.push_back(s);
  }
  if (file.bad()) throw std::runtime_error("cannot read radiosity file " + path.string());
  return samples;
}

}  // namespace verisim::global
