// Shadow rays that start in the same cell of space go together (accel::CoherentRays). What arrives is what each finds
// alone.
#include "tracer/shading/direct/shadow_batch.h"

#include <algorithm>

#include <boost/container/static_vector.hpp>

namespace verisim::shading {
namespace {

// As many as are used: what is made for a whole batch costs more than a few rays.
template <class T>
using BatchOf = boost::container::static_vector<T, ShadowBatch::kMax>;

// The rays of a batch by their cells.
struct Cells {
  struct Cell {
    accel::WorldEntry* entry;  // null: nothing is known
    Box3 served;               // empty: nothing else
  };
  BatchOf<Cell> cells;
  std::uint8_t of[ShadowBatch::kMax];
  int count() const { return static_cast<int>(cells.size()); }
  Cell& operator[](int c) { return cells[static_cast<std::size_t>(c)]; }
  const Cell& operator[](int c) const { return cells[static_cast<std::size_t>(c)]; }
  // The numbers of the rays, cell by cell.
  void sort(int rays, std::uint8_t* order) const {
    std::uint8_t next[ShadowBatch::kMax + 1] = {};
    for (int i = 0; i < rays; ++i) ++next[of[i] + 1];
    for (int c = 1; c < count(); ++c) next[c] = static_cast<std::uint8_t>(next[c] + next[c - 1]);
    for (int i = 0; i < rays; ++i) order[next[of[i]]++] = static_cast<std::uint8_t>(i);
  }
  int find(const Vec3& p, int last) const {
    if (last >= 0 && accel::contains((*this)[last].served, p)) return last;
    for (int c = count() - 1; c >= 0; --c)
      if (accel::contains((*this)[c].served, p)) return c;
    return -1;
  }
};

// Rays of one cell, on their way.
struct Travellers {
  int count = 0;
  RayBatch rays;
  double limit[RayBatch::kSize];
  int index[ShadowBatch::kMax];  // in the batch
  void add(int i, const Ray& ray, double distance) {
    rays.origin.set(count, ray.origin), rays.direction.set(count, ray.direction);
    limit[count] = distance - kShadowTolerance;
    index[count++] = i;
  }
};

// Takes the light of rays that meet something, where all that they may meet is opaque.
void block(const accel::World& world, double tolerance, const Travellers& cell, accel::WorldEntry* entry,
           ShadowBatch& batch) {
  bool blocked[ShadowBatch::kMax] = {};
  world.occluded_batch(cell.rays, 0, cell.count, tolerance, cell.limit, entry, blocked);
  for (int k = 0; k < cell.count; ++k)
    if (blocked[k]) batch.light[cell.index[k]] = Rgb();
}

}  // namespace

// Shadow rays to this light go one by one: many to an area, or with things to meet on their way that the batches do not
// know.
bool Tracer::rays_alone(const Light& light, const RayState& eye) const {
  return (light.area() && !eye.gather) || light.projector() || in_order_;
}

// Calls opaque(cell, entry) for rays that meet nothing but opaque objects, and mixed(cell, entry) for others.
template <class Opaque, class Mixed>
void Tracer::by_cells(const Light& light, const RayState& eye, const ShadowBatch& batch, Opaque&& opaque,
                      Mixed&& mixed) {
  const bool entries =
      !scene_.world.tree().empty() && !eye.gather;  // without a tree there is nothing to know of where rays start
  Cells cells;
  int unknown = -1, last = -1;
  for (int i = 0; i < batch.count; ++i) {
    const Vec3 p = batch.rays.origin.at(i);
    int c = cells.find(p, last);
    if (c >= 0) {
      coherent_.used_again(viewer({eye, batch.lit[i], light}));
    } else {
      accel::WorldEntry* const entry = entries ? shadow_entry({eye, batch.lit[i], light}, p) : nullptr;
      // What was remembered for another cell may have had to go.
      for (Cells::Cell& other : cells.cells)
        if (entry && other.entry == entry) other.entry = nullptr;
      c = entry || unknown < 0 ? cells.count() : unknown;
      if (c == cells.count()) cells.cells.push_back({entry, entry ? coherent_.served() : Box3()});
      if (!entry) unknown = c;
    }
    cells.of[i] = static_cast<std::uint8_t>(last = c);
  }
  std::uint8_t order[ShadowBatch::kMax];
  cells.sort(batch.count, order);
  for (int c = 0, k = 0; c < cells.count(); ++c) {
    Travellers cell;
    for (; k < batch.count && cells.of[order[k]] == c; ++k) {
      const int i = order[k];
      if (batch.distance[i] > 2 * kShadowTolerance)
        cell.add(i, batch.rays.at(i), batch.distance[i]);  // otherwise nothing fits in between
    }
    accel::WorldEntry* const entry = cells[c].entry;
    const auto stays_enclosed = [&](int i) {
      return scene_.world.only_opaque_between(batch.rays.origin.at(i),
                                              batch.rays.origin.at(i) + batch.distance[i] * batch.rays.direction.at(i));
    };
    if (only_opaque(entry) || std::all_of(cell.index, cell.index + cell.count, stays_enclosed))
      opaque(cell, entry);
    else
      mixed(cell, entry);
  }
}

void Tracer::cast_shadows(const Light& light, const RayState& eye, ShadowBatch& batch) {
  if (!light.shadows() || batch.count == 0) return;
  if (rays_alone(light, eye) || light_on_way_changes(light, eye)) {
    for (int i = 0; i < batch.count; ++i) {
      random_.begin(batch.key[i]);
      batch.light[i] = shadowed(light, batch.rays.origin.at(i), {batch.rays.direction.at(i), batch.distance[i]}, eye,
                                batch.lit[i], batch.light[i]);
    }
    return;
  }
  statistics_.shadow_rays += static_cast<std::uint64_t>(batch.count);
  if (eye.gather && !scene_.world.has_transparent_shadows()) {  // from all over the scene: cells would have a ray each
    double limit[RayBatch::kSize];
    bool blocked[ShadowBatch::kMax] = {};
    for (int i = 0; i < batch.count; ++i) limit[i] = batch.distance[i] - kShadowTolerance;
    scene_.world.occluded_batch(batch.rays, 0, batch.count, contact_tolerance(light), limit, nullptr, blocked);
    for (int i = 0; i < batch.count; ++i)
      if (blocked[i] && batch.distance[i] > 2 * kShadowTolerance) batch.light[i] = Rgb();
    return;
  }
  by_cells(
      light, eye, batch,
      [&](const Travellers& cell, accel::WorldEntry* entry) {
        block(scene_.world, contact_tolerance(light), cell, entry, batch);
      },
      [&](const Travellers& cell, accel::WorldEntry* entry) {
        filter_batch(light, eye, entry, cell.index, cell.count, batch);
      });
}

void Tracer::look_for_light(const Light& light, const RayState& eye, ShadowBatch& batch, bool* known) {
  std::fill_n(known, batch.count, false);
  if (scene_.quality < 4 || !light.shadows() || rays_alone(light, eye)) return;
  const bool changes = light_on_way_changes(light, eye);
  const bool draws = scene_.effects && (scene_.effects->interior_draws_count || scene_.effects->air_draws_count);
  if (changes && draws) return;
  const auto know = [&](const Travellers& cell) {
    for (int k = 0; k < cell.count; ++k) known[cell.index[k]] = true;
    statistics_.shadow_rays += static_cast<std::uint64_t>(cell.count);
  };
  by_cells(
      light, eye, batch,
      [&](const Travellers& cell, accel::WorldEntry* entry) {
        block(scene_.world, contact_tolerance(light), cell, entry, batch);
        if (changes) dim(light, eye, cell.index, cell.count, batch);
        know(cell);
      },
      [&](const Travellers& cell, accel::WorldEntry* entry) {
        if (draws || changes) return;
        filter_batch(light, eye, entry, cell.index, cell.count, batch);
        know(cell);
      });
}

// Fog and media take their share of the light of those rays `index` of a batch that nothing blocks.
void Tracer::dim(const Light& light, const RayState& eye, const int* index, int count, ShadowBatch& batch) {
  RayState ray = eye;
  for (int k = 0; k < count; ++k) {
    const int i = index[k];
    if (batch.light[i] == Rgb()) continue;
    ray.ray = batch.rays.at(i);
    shadow_volumes({eye, batch.lit[i], light}, ray, batch.distance[i], false, batch.light[i]);
  }
}

// filter_along() for the rays `index` of a batch: where transparent surfaces may be met. Nothing but media of
// containers acts between them here.
void Tracer::filter_batch(const Light& light, const RayState& eye, const accel::WorldEntry* entry, const int* index,
                          int count, ShadowBatch& batch) {
  const InteriorScope scope(*this);
  // Those that have met a transparent surface.
  struct Way {
    int index;
    Ray ray;
    InteriorRange interiors;
    bool hollow;
    double distance;
    RandomSource random;
  };
  BatchOf<Way> ways;
  RayState ray = eye;  // all that ways do not have of their own
  const bool draws = scene_.effects && scene_.effects->interior_draws_count;
  // True: there is more of the way beyond the surface.
  const auto meet = [&](Way& way, const shapes::Hit& hit) {
    const ShadowQuery query{eye, batch.lit[way.index], light};
    Rgb& color = batch.light[way.index];
    if (draws) random_ = way.random;
    ray.ray = way.ray, ray.interiors = way.interiors, ray.hollow = way.hollow;
    if (filter_through(query, ray, hit, color)) return false;
    shadow_volumes(query, ray, hit.t, true, color);
    way.interiors = crossed(way.interiors, hit.shape->surface->interior);
    way.hollow = all_hollow(way.interiors);
    way.ray.origin = hit.point;
    way.distance -= hit.t;
    if (draws) way.random = random_;
    return way.distance > 2 * kShadowTolerance;
  };
  Travellers open;
  for (int k = 0; k < count; ++k) open.add(index[k], batch.rays.at(index[k]), batch.distance[index[k]]);
  BatchOf<shapes::Hit> enclosure(static_cast<std::size_t>(count));
  shapes::Hit* const hits = enclosure.data();
  bool found[ShadowBatch::kMax];
  scene_.world.intersect_batch(open.rays, 0, open.count, shapes::RayKind::shadow, contact_tolerance(light), entry, hits,
                               found, open.limit);
  for (int k = 0; k < open.count; ++k) {
    if (found[k] && hits[k].t < kAboveShadowTolerance && !hits[k].shape->surface->opaque)
      found[k] = scene_.world.intersect(open.rays.at(k), shapes::RayKind::shadow, kAboveShadowTolerance, open.limit[k],
                                        hits[k], entry);
    if (!found[k]) continue;
    const int i = open.index[k];
    if (hits[k].shape->surface->opaque) {
      batch.light[i] = Rgb();
      continue;
    }
    Way& way = ways.emplace_back(Way{i, open.rays.at(k), eye.interiors, eye.hollow, batch.distance[i], random_});
    if (draws) way.random.begin(batch.key[i]);
    if (!meet(way, hits[k])) ways.pop_back();
  }
  while (!ways.empty()) {
    if (cancel_ && cancel_->load(std::memory_order_relaxed)) throw Cancelled();
    open.count = 0;
    for (const Way& way : ways) open.add(way.index, way.ray, way.distance);
    scene_.world.intersect_batch(open.rays, 0, open.count, shapes::RayKind::shadow, kAboveShadowTolerance, entry, hits,
                                 found, open.limit);
    std::size_t onward = 0;  // those that go on are moved up
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (!found[k] || !meet(ways[k], hits[k])) continue;
      if (onward != k) ways[onward] = ways[k];
      ++onward;
    }
    ways.erase(ways.begin() + static_cast<std::ptrdiff_t>(onward), ways.end());
  }
}

}  // namespace verisim::shading
