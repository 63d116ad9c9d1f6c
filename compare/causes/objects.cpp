// What became of the objects. Where both programs say what their pixels show, objects are known by name and place: what
// one of them lost, moved or changed can be read off. Where only one does, its objects' outlines are looked for in the
// other picture.
#include <fmt/format.h>

#include <numbers>
#include <set>

#include "compare/causes/families.h"
#include "compare/causes/outline.h"
#include "compare/causes/registration.h"

namespace verisim::compare {
namespace {

struct SeenObject {
  std::string name, copy;  // "sphere (s.pov:3)"; the same with its place
  bool parent = false;     // a CSG object
  bool secondary = false;  // seen in a mirror or through something
  bool placed = false;     // the next two are known
  std::array<double, 3> middle{}, size{};
  Mask mask;
  std::size_t pixels = 0;
};

std::vector<SeenObject> seen_in(const Case& c, const PixelTags& tags) {
  std::vector<SeenObject> out;
  std::vector<int> index(tags.tags.size(), -1);
  for (std::size_t i = 0; i < tags.tags.size(); ++i) {
    const PixelTags::Tag& tag = tags.tags[i];
    const bool secondary = tag.kind == "secondary object";
    if (tag.kind != "copy" && tag.kind != "parent" && !secondary) continue;
    index[i] = static_cast<int>(out.size());
    SeenObject& s = out.emplace_back();
    const std::size_t at = tag.name.rfind(" at <");
    s.name = tag.name.substr(0, at), s.copy = tag.name, s.parent = tag.kind == "parent", s.secondary = secondary;
    if (secondary && at != std::string::npos)
      s.name += tag.name.substr(tag.name.rfind('>') + 1);  // ", in a reflection"
    s.mask.assign(c.size(), 0);
    if (at != std::string::npos)
      s.placed = std::sscanf(tag.name.c_str() + at, " at <%lf, %lf, %lf>, size <%lf, %lf, %lf>", &s.middle[0],
                             &s.middle[1], &s.middle[2], &s.size[0], &s.size[1], &s.size[2]) == 6;
  }
  for (std::size_t i = 0; i < c.size(); ++i)
    if (const int set = c.set_of(tags, i); set >= 0 && static_cast<std::size_t>(set) < tags.sets.size())
      for (int tag : tags.sets[static_cast<std::size_t>(set)])
        if (tag >= 0 && static_cast<std::size_t>(tag) < index.size() && index[static_cast<std::size_t>(tag)] >= 0) {
          SeenObject& s = out[static_cast<std::size_t>(index[static_cast<std::size_t>(tag)])];
          s.mask[i] = 1, ++s.pixels;
        }
  return out;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct Match {
  const SeenObject *was = nullptr, *is = nullptr;
};

// By place; what is left by name, the nearest first.
std::vector<Match> matches(const std::vector<SeenObject>& was, const std::vector<SeenObject>& is) {
  std::vector<Match> out;
  std::set<const SeenObject*> taken;
  for (const SeenObject& a : was) out.push_back({&a, nullptr});
  const auto pair_up = [&](const std::function<bool(const SeenObject&, const SeenObject&)>& fit) {
    for (Match& m : out) {
      if (m.is) continue;
      const SeenObject* best = nullptr;
      for (const SeenObject& b : is)
        if (!taken.contains(&b) && b.parent == m.was->parent && b.secondary == m.was->secondary && fit(*m.was, b) &&
            (!best || distance(b.middle, m.was->middle) < distance(best->middle, m.was->middle)))
          best = &b;
      if (best) m.is = best, taken.insert(best);
    }
  };
  pair_up([](const SeenObject& a, const SeenObject& b) { return a.copy == b.copy; });
  pair_up([](const SeenObject& a, const SeenObject& b) { return a.name == b.name; });
  for (const SeenObject& b : is)
    if (!taken.contains(&b)) out.push_back({nullptr, &b});
  return out;
}

Mask either(const Mask& a, const Mask& b) {
  Mask out = a;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] || b[i];
  return out;
}
Mask common(const Mask& a, const Mask& b) {
  Mask out = a;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] && b[i];
  return out;
}
Mask difference(const Mask& a, const Mask& b) {
  Mask out = a;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] != b[i];
  return out;
}

// What both programs know is as good as sure, if it accounts for a good part of the difference: shadows and mirror
// images of the object are wrong, too.
void add_known(const Case& c, const std::string& what, const std::string& detail, const Mask& mask, double certainty,
               Suspicions& out) {
  constexpr double kBase = 0.55;
  Suspicion s = c.placed(what, detail, mask, 1);
  if (s.explained < 0.05) return;
  s.sure = weight::kKnown * certainty * (kBase + (1 - kBase) * s.explained);
  out.push_back(std::move(s));
}

std::string vector_text(const std::array<double, 3>& v) {
  return fmt::format("<{:.4g}, {:.4g}, {:.4g}>", v[0], v[1], v[2]);
}

struct Change {
  std::string what, detail;
  std::array<double, 3> move{};
};

// How the box of an object has changed, if it has.
std::optional<Change> change_of(const SeenObject& was, const SeenObject& is) {
  constexpr double kSame = 2e-3;
  if (!was.placed || !is.placed || was.copy == is.copy) return std::nullopt;
  Change out;
  double largest = 1e-9;
  for (std::size_t k = 0; k < 3; ++k)
    out.move[k] = is.middle[k] - was.middle[k], largest = std::max({largest, was.size[k], is.size[k]});
  std::array<double, 3> ratio{};
  int changed = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ratio[k] = was.size[k] > 1e-9 * largest ? is.size[k] / was.size[k] : 1;
    changed += std::fabs(is.size[k] - was.size[k]) > kSame * std::max(was.size[k], 1e-3 * largest);
  }
  const auto [low, high] = std::minmax_element(ratio.begin(), ratio.end());
  if (changed == 0)
    out.what = "object moved",
    out.detail = fmt::format("{}: by {}, to {}", was.name, vector_text(out.move), vector_text(is.middle));
  else if (changed == 3 && *high / *low < 1 + 2 * kSame)
    out.what = "object scaled",
    out.detail = fmt::format("{}: {:.1f} % {}", was.name, 100 * std::fabs(*high - 1), *high > 1 ? "larger" : "smaller");
  else if (changed == 1)
    out.what = "object scaled", out.detail = fmt::format("{}: its box has the size {}, not {}", was.name,
                                                         vector_text(is.size), vector_text(was.size));
  else
    out.what = "object rotated",
    out.detail = fmt::format("{}: turned, or of another shape: its box has the size {}, not {}", was.name,
                             vector_text(is.size), vector_text(was.size));
  return out;
}

bool same_move(const Change& a, const Change& b) {
  return a.what == b.what && distance(a.move, b.move) < 1e-3 * (1e-3 + distance(a.move, {}));
}

void changed_objects(const Case& c, const std::vector<Match>& all, Suspicions& out) {
  constexpr double kPartOfParent = 0.85, kSecondary = 0.97;
  struct Found {
    Match match;
    Change change;
  };
  std::vector<Found> changes;
  for (const Match& m : all) {
    // What is seen nowhere in mirrors any more may be there: the mirror's fault.
    if ((!m.was || !m.is) && !(m.was ? m.was : m.is)->secondary)
      changes.push_back({m, {m.was ? "object missing" : "object added", (m.was ? m.was : m.is)->copy}});
    else if (auto change = m.was && m.is ? change_of(*m.was, *m.is) : std::nullopt)
      changes.push_back({m, *change});
  }
  for (const Found& f : changes) {
    const SeenObject& any = f.match.was ? *f.match.was : *f.match.is;
    // A CSG object is named if what is known of its parts is known of it, and then in their place.
    const auto same_as = [&](const Found& other) {
      const SeenObject& theirs = other.match.was ? *other.match.was : *other.match.is;
      return &other != &f && (other.match.was == nullptr) == (f.match.was == nullptr) &&
             same_move(f.change, other.change) && theirs.parent != any.parent &&
             share_of(c, common(theirs.mask, any.mask)) > 0;
    };
    const bool shared = std::any_of(changes.begin(), changes.end(), same_as);
    if (any.parent && !shared) continue;
    const Mask mask = f.match.was && f.match.is ? either(f.match.was->mask, f.match.is->mask) : any.mask;
    add_known(c, f.change.what, f.change.detail, mask,
              any.secondary           ? kSecondary
              : !any.parent && shared ? kPartOfParent
                                      : 1,
              out);
  }
}

// The same boxes, and other outlines: of few objects, for all of them change when the camera does.
void changed_outlines(const Case& c, const std::vector<Match>& all, Suspicions& out) {
  std::size_t kept = 0, other = 0;
  for (const Match& m : all)
    if (m.was && m.is && m.was->copy == m.is->copy && !m.was->parent && !m.was->secondary)
      ++kept, other += difference(m.was->mask, m.is->mask) != Mask(c.size());
  if (other > 2 && other > kept / 2) return;
  for (const Match& m : all) {
    if (!m.was || !m.is || m.was->copy != m.is->copy || m.was->parent || m.was->secondary) continue;
    const Mask changed = difference(m.was->mask, m.is->mask);
    const double share = share_of(c, changed);
    if (share < 0.3) continue;
    Suspicion s = c.placed(
        "object shape", fmt::format("{}: seen at {} pixels in place of {}", m.was->name, m.is->pixels, m.was->pixels),
        changed, 1);
    s.sure = weight::kPlace * share * (m.was->placed ? 1 : 0.7);
    out.push_back(std::move(s));
  }
}

// Where an object is seen in mirrors or through something.
Mask images_of(const Case& c, const SeenObject& object, const std::vector<SeenObject>& all) {
  Mask out(c.size());
  for (const SeenObject& other : all)
    if (other.secondary && other.copy.starts_with(object.copy)) out = either(out, other.mask);
  return out;
}

bool has_passed_objects(const PixelTags& tags) {
  return std::any_of(tags.tags.begin(), tags.tags.end(),
                     [](const PixelTags::Tag& tag) { return tag.kind == "passed object"; });
}

// A texture may differ here and there: that most of the surface is right says little against it.
Suspicion surface(std::string what, std::string detail, const Case& c, const Mask& mask, double least) {
  Suspicion s = c.placed(std::move(what), std::move(detail), mask, weight::kPlace);
  // Where it fills the picture nothing else can be wrong, unless it is not seen.
  const bool fills = std::count(mask.begin(), mask.end(), 0) == 0 && !has_passed_objects(*c.tags.any());
  s.sure = weight::kPlace * s.explained * (fills ? 1 : std::max(least, std::sqrt(s.precision)));
  return s;
}

// Wrong pixels on both sides of an object's border only.
void outline(const Case& c, const SeenObject& object, double inside, Suspicions& out) {
  constexpr double kAllOfIt = 0.97, kMaxOfPicture = 0.6, kWeight = 0.45;
  if (inside > kAllOfIt || static_cast<double>(object.pixels) > kMaxOfPicture * static_cast<double>(c.size())) return;
  const Mask around = dilated(c, object.mask, 1);
  if (part_of_wrong(c, around) < kAllOfIt) return;
  Suspicion s = c.placed("object shape", object.name + ": its outline", around, 1);
  s.sure = kWeight * s.explained;
  out.push_back(std::move(s));
}

// Where an object is what it was and looks otherwise. Other surfaces that are wrong by less speak
// against it: twice, for they are not explained and want another cause.
// `images`: where the object is seen in mirrors or through something.
void surfaces(const Case& c, const SeenObject& object, const Mask& mask, const Mask& images, Suspicions& out) {
  constexpr double kLeastShare = 0.5;
  const double share = share_of(c, mask);
  outline(c, object, share, out);
  if (share < kLeastShare) return;
  Suspicions of_it;
  suspect_tone_of(c, object.name, mask, of_it);
  of_it.push_back(surface("object", object.name + ": its surface", c, mask, 0.6));
  const Mask direct = common(c.wrong, directly_seen(c, *c.tags.any()));
  const double covered =
      object.secondary ? 1 : part_of_wrong(c, common(direct, either(mask, images))) / part_of_wrong(c, direct);
  for (Suspicion& s : of_it) s.sure *= covered * covered, out.push_back(std::move(s));
}

// How strongly the mask's border shows in a picture: differences across it.
double border(const Case& c, const Mask& mask, const Pixels& picture) {
  double sum = 0;
  for (int y = 0; y + 1 < c.height; ++y)
    for (int x = 0; x + 1 < c.width; ++x) {
      const std::size_t i = c.at(x, y);
      for (std::size_t j : {c.at(x + 1, y), c.at(x, y + 1)})
        if (mask[i] != mask[j]) sum += squared_distance(picture[i], picture[j]);
    }
  return sum;
}

// Where the other picture shows an object's outline.
struct Elsewhere {
  bool found = false;    // there, and not where it should be
  double part = 0;       // of the outline
  Outline::Place place;  // of the test's outline, seen from the reference's
  bool zoomed() const { return place.zoom != 1; }
  std::string detail(const Case& c) const {
    if (zoomed())
      return fmt::format("{:.0f} % {}", 100 * std::fabs(place.zoom - 1), place.zoom > 1 ? "larger" : "smaller");
    return fmt::format("by {:.0f}, {:.0f} pixels (right, down)", place.dx * c.reduced + 0.0,
                       place.dy * c.reduced + 0.0);
  }
};
Elsewhere look_elsewhere(const Case& c, const Mask& mask, int reach) {
  constexpr double kFound = 0.55, kMore = 0.25;
  const bool of_reference = c.tags.reference != nullptr;
  const Pixels &own = of_reference ? c.reference : c.test, &other = of_reference ? c.test : c.reference;
  const Outline outline(c, mask, own);
  Elsewhere out;
  out.place = outline.best(reach, other);
  out.part = outline.found_at(out.place, other);
  out.found = out.part > kFound && out.part > outline.found_at({}, other) + kMore;
  if (!of_reference) out.place = {-out.place.dx, -out.place.dy, 1 / out.place.zoom};
  return out;
}

// With one side's word only.
void outlines_of_one_side(const Case& c, Suspicions& out) {
  constexpr double kAllOfIt = 0.97, kGone = 0.3, kLeastShare = 0.5, kMaxOfPicture = 0.6;
  const std::vector<SeenObject> objects = seen_in(c, *c.tags.any());
  const auto sky = [](const PixelTags::Tag& tag) { return tag.kind == "object" && is_sky(tag); };
  if (const Mask background = c.pixels_with(*c.tags.any(), sky); part_of_wrong(c, background) > kAllOfIt)
    out.push_back(surface("background", "what is seen where there is no object", c, background, 0));
  for (const SeenObject& object : objects) {
    if (object.secondary) continue;
    surfaces(c, object, object.mask, images_of(c, object, objects), out);
    const int reach = std::max(3, c.width / 20);
    const Mask around = dilated(c, object.mask, reach);
    if (share_of(c, around) < kLeastShare || object.pixels < 6 ||
        static_cast<double>(object.pixels) > kMaxOfPicture * static_cast<double>(c.size()))
      continue;
    const double was = border(c, object.mask, c.reference), is = border(c, object.mask, c.test);
    // What is wrong around it has to be explained, too: where there is much, the object is rather elsewhere.
    const double only_there = share_of(c, object.mask) / share_of(c, around);
    const Elsewhere elsewhere = look_elsewhere(c, object.mask, reach);
    const double gone = 0.95 * only_there * (elsewhere.found ? 0.5 : 1);
    // It is there for the side that tells of it.
    if (c.tags.reference ? is < kGone * was : was < kGone * is)
      out.push_back(c.placed(c.tags.reference ? "object missing" : "object added", object.copy, object.mask, gone));
    if (elsewhere.found) {
      Suspicion s = c.placed(elsewhere.zoomed() ? "object scaled" : "object moved",
                             fmt::format("{}: {}", object.name, elsewhere.detail(c)), around, 1);
      s.sure = weight::kRepaired * s.explained * elsewhere.part;
      out.push_back(std::move(s));
    }
    double mx = 0, my = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
      if (object.mask[i])
        mx += static_cast<double>(i % static_cast<std::size_t>(c.width)),
            my += static_cast<double>(i / static_cast<std::size_t>(c.width));
    mx /= static_cast<double>(object.pixels), my /= static_cast<double>(object.pixels);
    double known = 0;
    const auto attempt = [&](const char* what, const Freedom& freedom, const auto& detail) {
      const Registered r = registered(c, freedom, mx, my, around);
      Suspicion s = c.placed(what, fmt::format("{}: {}", object.name, detail(r.motion)), around, 1);
      s.explained *= std::max(0.0, r.explained);
      s.sure = c.tested * 0.95 * weight::kRepaired * s.explained *
               (known > 0 && 1 - r.explained > 0.6 * (1 - known) ? 0.8 : 1);
      known = std::max(known, r.explained);
      out.push_back(std::move(s));
    };
    attempt("object moved", {true, false, false, false}, [&](const Motion& m) {
      return fmt::format("by {:.1f}, {:.1f} pixels (right, down)", m.dx * c.reduced, m.dy * c.reduced);
    });
    if (!object.placed) continue;  // what has no end has no size
    attempt("object scaled", {true, true, false, false}, [](const Motion& m) {
      return fmt::format("{:.1f} % {}", 100 * std::fabs(m.zoom_x), m.zoom_x > 0 ? "larger" : "smaller");
    });
    attempt("object rotated", {true, false, false, true}, [](const Motion& m) {
      return fmt::format("by {:.1f} degrees in the picture", 180 / std::numbers::pi * m.turn);
    });
  }
}

}  // namespace

void suspect_objects(const Case& c, Suspicions& out) {
  if (!c.tags.any()) return;
  if (!c.tags.both()) return outlines_of_one_side(c, out);
  const std::vector<SeenObject> was = seen_in(c, *c.tags.reference), is = seen_in(c, *c.tags.test);
  const std::vector<Match> all = matches(was, is);
  changed_objects(c, all, out);
  changed_outlines(c, all, out);
  for (const Match& m : all) {
    if (!m.was || !m.is) continue;
    Suspicions of_it;
    surfaces(c, *m.was, common(m.was->mask, m.is->mask), images_of(c, *m.was, was), of_it);
    for (Suspicion& s : of_it) s.sure *= m.was->secondary ? 0.95 : 1, out.push_back(std::move(s));
  }
  const auto sky = [](const PixelTags::Tag& tag) { return tag.kind == "object" && is_sky(tag); };
  const Mask background = common(c.pixels_with(*c.tags.reference, sky), c.pixels_with(*c.tags.test, sky));
  if (share_of(c, background) > 0.5)
    out.push_back(c.placed("background", "what is seen where there is no object", background, weight::kRepaired));
}

}  // namespace verisim::compare
