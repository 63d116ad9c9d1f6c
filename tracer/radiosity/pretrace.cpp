#include "tracer/radiosity/pretrace.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace verisim::global {
namespace {

constexpr int kTable = 2047;

double jitter(int draw) {
  static const std::vector<double> table = [] {
    std::mt19937 generator;
    std::vector<double> t(kTable);
    for (double& v : t) v = -1.0 + 2.0 * generator() / 4294967296.0;
    return t;
  }();
  return table[static_cast<std::size_t>(draw)];
}

double first_position(double edge, double spacing) {
  const double start = std::ceil((edge - 0.5) / spacing) * spacing;
  return start < edge ? start + spacing : start;
}

// Calls use(coordinate) for the positions from `from` to before `to`. Coordinates are summed up, as POV-Ray does: the
// rounding decides whether a position on a border belongs to a block.
template <class Use>
void each_position(double from, double to, double spacing, Use use) {
  for (double v = first_position(from, spacing); v < to; v += spacing) use(v);
}

int count_positions(double from, double to, double spacing) {
  int n = 0;
  each_position(from, to, spacing, [&](double) { ++n; });
  return n;
}

}  // namespace

double PretracePlan::spacing(int pass) const { return std::max(std::ldexp(first, -pass), last); }

PretracePlan pretrace_plan(const scene::Radiosity& description, int width, int height) {
  PretracePlan plan;
  const double most = std::max(width, height);
  plan.first = most * description.pretrace_start;
  plan.last = std::max(1.0, most * description.pretrace_end);
  // Tiny pictures would give a negative number, which POV-Ray takes for some 250 useless passes; none is enough.
  plan.passes = std::max(0, static_cast<int>(std::floor(std::log2(plan.first / plan.last) + 1.0 - kEpsilon)) + 1);
  return plan;
}

int PretraceTile::first_draw(int pass) const { return static_cast<int>(((1LL + pass) * 17 + 13LL * number_) % kTable); }

void PretraceTile::positions(const PretraceBlock& block, double spacing, int& draw, std::vector<Vec2>& out) {
  out.clear();
  const double reach = std::min(1.0, spacing / 2.0), middle = (spacing - 1.0) / 2.0;
  const auto next = [&] {
    draw = (draw + 1) % kTable;
    return jitter(draw);
  };
  each_position(block.top, block.bottom, spacing, [&](double y) {
    each_position(block.left, block.right, spacing, [&](double x) {
      const double dy = next(), dx = next();
      out.emplace_back(x + middle + reach * dx, y + middle + reach * dy);
    });
  });
}

void PretraceTile::split(double spacing) {
  constexpr int kMinInARow = 4;
  const int across = std::max(1, count_positions(tile_.left, tile_.right, spacing) / (kMinInARow * across_));
  const int down = std::max(1, count_positions(tile_.top, tile_.bottom, spacing) / (kMinInARow * down_));
  if (across == 1 && down == 1) return;
  std::vector<PretraceBlock> parts;
  parts.reserve(blocks_.size() * static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  for (const PretraceBlock& b : blocks_) {
    const auto x = [&](int i) { return i == across ? b.right : b.left + (b.right - b.left) * i / across; };
    const auto y = [&](int i) { return i == down ? b.bottom : b.top + (b.bottom - b.top) * i / down; };
    for (int j = 0; j < down; ++j)
      for (int i = 0; i < across; ++i) parts.push_back({x(i), y(j), x(i + 1), y(j + 1)});
  }
  blocks_ = std::move(parts);
  across_ *= across, down_ *= down;
}

}  // namespace verisim::global
