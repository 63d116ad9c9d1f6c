// The terms of a pixel's colour: where both programs tell them, what each has changed; where one does, how much of
// each is missing or too much. All in linear light, where they add up.
#include <fmt/format.h>

#include <map>
#include <set>

#include "compare/causes/families.h"
#include "compare/causes/fog_density.h"
#include "compare/causes/moved_light.h"
#include "compare/causes/registration.h"
#include "compare/causes/transfer.h"

namespace verisim::compare {
namespace {

using Key = std::pair<std::string, std::string>;  // kind and name
constexpr const char* kOverlapping[] = {"highlights", "reflection", "transparency"};

constexpr const char* kLitElsewhere = "light elsewhere";  // the part of a light that mirrors and glass show

bool overlaps(const std::string& kind) {
  return std::find(std::begin(kOverlapping), std::end(kOverlapping), kind) != std::end(kOverlapping);
}

std::map<Key, Pixels> terms_of(const Case& c, const PixelTags& tags) {
  std::map<Key, Pixels> out;
  for (const PixelTags::Part& part : tags.parts)
    if (part.kind != kLitElsewhere) out[{part.kind, part.name}] = c.numbers_of(tags, part.light);
  return out;
}

Pixels sum_of(const Case& c, const std::map<Key, Pixels>& terms) {
  Pixels out(c.size());
  for (const auto& [key, light] : terms)
    if (!overlaps(key.first))
      for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) out[i][k] += light[i][k];
  return out;
}

double squares(const Pixels& p) {
  double sum = 0;
  for (const Pixel& v : p) sum += squared_distance(v, {});
  return sum;
}

// y = factor x for each channel, and how much of y that is.
struct Proportion {
  std::array<double, 3> factor{};
  double explained = 0;
  bool one() const {
    const auto [low, high] = std::minmax_element(factor.begin(), factor.end());
    return *high - *low < 0.1 * std::max(std::fabs(*low), std::fabs(*high));
  }
};
Proportion proportion(const Pixels& x, const Pixels& y, const Mask* judged = nullptr) {
  Proportion out;
  std::array<double, 3> xx{}, xy{}, yy{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (judged && !(*judged)[i]) continue;
    for (std::size_t k = 0; k < 3; ++k)
      xx[k] += x[i][k] * x[i][k], xy[k] += x[i][k] * y[i][k], yy[k] += y[i][k] * y[i][k];
  }
  double all = 0, fitted = 0;
  // A channel without any light takes part in what the others say.
  double mean = 0, weights = 0;
  for (std::size_t k = 0; k < 3; ++k) mean += xy[k], weights += xx[k];
  for (std::size_t k = 0; k < 3; ++k) {
    out.factor[k] = xx[k] > 1e-6 * weights && weights > 0 ? xy[k] / xx[k] : weights > 0 ? mean / weights : 0;
    all += yy[k], fitted += xx[k] > 0 ? xy[k] * xy[k] / xx[k] : 0;
  }
  out.explained = all > 0 ? fitted / all : 0;
  return out;
}

// A change that is told as a part of what is, as a part of what was.
Proportion of_what_was(Proportion p) {
  constexpr double kMax = 0.999;
  for (double& f : p.factor) f = 1 / (1 - std::min(f, kMax)) - 1;
  return p;
}

std::string in_words(const std::string& kind, const std::string& name) {
  if (kind == "own light") return "ambient light";
  if (kind == "background") return "background";
  return name.empty() || kind != "light" ? kind : name;
}

// What to call a light that is so many times what it was.
std::pair<std::string, std::string> strength(const std::string& kind, const std::string& name, const Proportion& p) {
  const std::string words = in_words(kind, name);
  const double mean = (p.factor[0] + p.factor[1] + p.factor[2]) / 3;
  const bool light = kind == "light";
  if (p.one() && mean < -0.97)
    return {light ? "light missing" : words + " missing", light ? "the " + name : "there is none"};
  if (p.one() && mean > 9)
    return {light ? "light strength" : words, (light ? "the " + name + ": " : "") + "more than ten times as much"};
  if (p.one())
    return {light ? "light strength" : words, fmt::format("{}{:.1f} % {}", light ? "the " + name + ": " : "",
                                                          100 * std::fabs(mean), mean < 0 ? "less" : "more")};
  return {light ? "light color" : words,
          fmt::format("{}red, green and blue are {:.3f}, {:.3f} and {:.3f} times the reference's",
                      light ? "the " + name + ": " : "", 1 + p.factor[0], 1 + p.factor[1], 1 + p.factor[2])};
}

constexpr double kProportional = 0.97;

// Pixels that show another object than in the reference, be it in a mirror or through something.
Mask elsewhere(const Case& c) {
  const auto object = [](const PixelTags::Tag& tag) { return tag.kind == "object" || tag.kind == "secondary object"; };
  Mask out(c.size());
  for (const PixelTags::Tag& tag : c.tags.reference->tags) {
    if (!object(tag)) continue;
    const auto same = [&](const PixelTags::Tag& other) { return other.kind == tag.kind && other.name == tag.name; };
    const Mask before = c.pixels_with(*c.tags.reference, same), after = c.pixels_with(*c.tags.test, same);
    for (std::size_t i = 0; i < c.size(); ++i) out[i] = out[i] || before[i] != after[i];
  }
  return out;
}

class Terms {
 public:
  Terms(const Case& c, Suspicions& out)
      : c_(c),
        out_(out),
        was_(c.tags.reference ? terms_of(c, *c.tags.reference) : std::map<Key, Pixels>()),
        is_(c.tags.test ? terms_of(c, *c.tags.test) : std::map<Key, Pixels>()),
        transfer_(c, sum_of(c, c.tags.reference ? was_ : is_), c.tags.reference ? c.reference : c.test) {
    for (const Pixel& p : c.reference) lit_.push_back({light(p[0]), light(p[1]), light(p[2])});
    if (c.tags.both()) outlines_kept_ = share_of(c, elsewhere(c)) < 0.2;
  }

  void compare_both() {
    lights();
    std::map<std::string, std::array<Pixels, 2>> kinds;
    for (const auto& [side, terms] : {std::pair(0, &was_), std::pair(1, &is_)})
      for (const auto& [key, light] : *terms)
        if (key.first != "light") kinds[key.first][static_cast<std::size_t>(side)] = light;
    for (auto& [kind, sides] : kinds) {
      for (Pixels& side : sides) side.resize(c_.size());
      const Pixels change = minus(sides[1], sides[0]);
      if (squares(change) <= 0) continue;
      if (squares(sides[0]) == 0 || squares(sides[1]) == 0) {
        whole_effect(in_words(kind, ""), squares(sides[1]) == 0, change);
        continue;
      }
      Mask where(c_.size());
      for (std::size_t i = 0; i < c_.size(); ++i) where[i] = squared_distance(change[i], {}) > 0;
      const Proportion p = proportion(sides[0], change, kind == "own light" ? &where : nullptr);
      auto [what, detail] = strength(kind, "", p);
      if (p.explained < kProportional) what = in_words(kind, ""), detail = "differently distributed";
      // Ambient light and background are as bright as objects say: what else has changed has changed them.
      const bool alone = told_alone(kind, change);
      const bool of_objects = kind == "own light" || kind == "background";
      add(what, detail, change,
          alone && outlines_kept_        ? 0.95
          : of_objects                   ? 0.6
          : p.explained >= kProportional ? 0.95
                                         : 0.85);
    }
  }

  // How much of the difference the two sides' terms tell.
  double told() const {
    const Pixels before = sum_of(c_, was_), after = sum_of(c_, is_);
    return c_
        .repaired(
            "", "",
            [&](std::size_t i) {
              Pixel p;
              for (std::size_t k = 0; k < 3; ++k) p[k] = transfer_.code(lit_[i][k] + after[i][k] - before[i][k]);
              return p;
            },
            1)
        .explained;
  }

  // With one side's terms: how much of each the difference holds.
  void fit_one(bool of_reference) {
    constexpr float kWhite = 254.5f;
    Mask judged(c_.size());
    Pixels rest(c_.size());
    for (std::size_t i = 0; i < c_.size(); ++i) {
      judged[i] = std::all_of(c_.test[i].begin(), c_.test[i].end(), [](float v) { return v < kWhite; }) &&
                  std::all_of(c_.reference[i].begin(), c_.reference[i].end(), [](float v) { return v < kWhite; });
      for (std::size_t k = 0; k < 3; ++k) rest[i][k] = light(c_.test[i][k]) - lit_[i][k];
    }
    const SeenSurfaces surfaces = surfaces_of(*c_.tags.any(), judged);
    for (const auto& [key, term] : of_reference ? was_ : is_) {
      const auto more = [&] { return of_reference ? rest : minus(Pixels(c_.size()), rest); };
      if (key.first == "light") moved(key.second, term, more(), surfaces);
      if (key.first == "light") shadowed(key.second, term);
      if (key.first == "fog") density("fog", term, more(), judged);
      const Proportion p = proportion(term, rest, &judged);
      auto [what, detail] = strength(key.first, key.second, of_reference ? p : of_what_was(p));
      const double mean = (p.factor[0] + p.factor[1] + p.factor[2]) / 3;
      if (!of_reference && p.one() && std::fabs(mean - 1) < 0.03) {
        what = key.first == "light" ? "light added" : in_words(key.first, "") + " added";
        detail = key.first == "light" ? "the " + key.second : "there is none in the reference";
      }
      if (key.first == "transparency" || key.first == "reflection") detail = of_owner(term, detail);
      Pixels change = term;
      for (Pixel& v : change)
        for (std::size_t k = 0; k < 3; ++k) v[k] *= static_cast<float>(p.factor[k]);
      add(what, detail, change, weight::kRepaired * (p.one() ? 1 : 0.97));
    }
  }

 private:
  float light(float code) const { return static_cast<float>(transfer_.light(code)); }
  static Pixels minus(Pixels a, const Pixels& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) a[i][k] -= b[i][k];
    return a;
  }

  // "sphere (s.pov:3): 10 % more" where one object shows nearly all pixels of this term that are far from right.
  std::string of_owner(const Pixels& term, const std::string& detail) const {
    constexpr float kFar = 0.1f;
    const float far = kFar * *std::max_element(c_.squared.begin(), c_.squared.end());
    Mask shown(c_.size());
    for (std::size_t i = 0; i < c_.size(); ++i) shown[i] = c_.squared[i] > far && squared_distance(term[i], {}) > 0;
    const std::string owner = owner_of(c_, *c_.tags.any(), shown);
    return owner.empty() ? detail : owner + ": " + detail;
  }

  SeenSurfaces surfaces_of(const PixelTags& tags, const Mask& judged) const {
    SeenSurfaces out{c_.numbers_of(tags, tags.surfaces.point), c_.numbers_of(tags, tags.surfaces.normal),
                     c_.numbers_of(tags, tags.surfaces.diffuse)};
    for (std::size_t i = 0; i < c_.size(); ++i)
      if (!judged[i]) out.normal[i] = {};
    return out;
  }

  // `more`: what the side without terms has more than the one with them.
  void moved(const std::string& name, const Pixels& term, const Pixels& more, SeenSurfaces surfaces) {
    Vec3 from(0.0);
    const std::size_t place = name.find('<');
    if (place == std::string::npos ||
        std::sscanf(name.c_str() + place, "<%lf, %lf, %lf>", &from.x, &from.y, &from.z) != 3)
      return;
    const Pixels none(c_.size());
    Pixels here = term;  // without what is lit elsewhere
    for (const PixelTags::Part& part : c_.tags.any()->parts)
      if (part.kind == kLitElsewhere && part.name == name)
        here = minus(here, c_.numbers_of(*c_.tags.any(), part.light));
    for (std::size_t i = 0; i < c_.size(); ++i)
      if (squared_distance(here[i], {}) < 0.5f * squared_distance(term[i], {})) surfaces.normal[i] = {};
    const std::optional<MovedLight> other = moved_light(from, here, minus(here, minus(none, more)), surfaces);
    if (!other) return;
    Pixels change = minus(other->light, here);
    for (std::size_t i = 0; i < c_.size(); ++i)
      if (surfaces.normal[i] == Pixel{}) change[i] = {};
    const Vec3& at = other->position;
    add("light moved",
        fmt::format("the {} is at about <{:.3g}, {:.3g}, {:.3g}> in the {}", name, at.x, at.y, at.z,
                    c_.tags.reference ? "test picture" : "reference"),
        c_.tags.reference ? change : minus(none, change), weight::kRepaired);
  }

  // Where the side without terms shows exactly what is left without this light, and elsewhere the light: in shadows.
  void shadowed(const std::string& name, const Pixels& term) {
    constexpr float kSeen = 4, kSame = 1.5f;  // code values
    constexpr double kMaxPart = 0.7, kLeast = 0.3;
    const bool known = c_.tags.reference != nullptr;
    const Pixels &own = known ? c_.reference : c_.test, &other = known ? c_.test : c_.reference;
    Mask mask(c_.size());
    std::size_t seen = 0, dark = 0;
    for (std::size_t i = 0; i < c_.size(); ++i) {
      Pixel without;
      for (std::size_t k = 0; k < 3; ++k) without[k] = transfer_.code(light(own[i][k]) - term[i][k]);
      if (squared_distance(without, own[i]) < kSeen * kSeen) continue;
      mask[i] = c_.wrong[i] && squared_distance(without, other[i]) < kSame * kSame;
      ++seen, dark += mask[i];
    }
    if (static_cast<double>(dark) > kMaxPart * static_cast<double>(seen) || share_of(c_, mask) < kLeast) return;
    Suspicion s = c_.placed(
        "shadows", fmt::format("only the {} has one of the {} here", known ? "test picture" : "reference", name), mask,
        1);
    s.sure = 0.85 * s.explained;
    out_.push_back(std::move(s));
  }

  void density(const std::string& air, const Pixels& term, const Pixels& more, const Mask& judged) {
    const auto other = other_fog(sum_of(c_, c_.tags.reference ? was_ : is_), term, more, judged);
    if (!other) return;
    const bool known = c_.tags.reference != nullptr;
    add(air, fmt::format("{:.2f} times as dense as in the reference", known ? other->density : 1 / other->density),
        known ? other->change : minus(Pixels(c_.size()), other->change), weight::kRepaired);
  }

  void add(const std::string& what, const std::string& detail, const Pixels& change, double weight) {
    Suspicion s = c_.repaired(
        what, detail,
        [&](std::size_t i) {
          Pixel p;
          for (std::size_t k = 0; k < 3; ++k) p[k] = transfer_.code(lit_[i][k] + change[i][k]);
          return p;
        },
        weight);
    if (s.explained > 0.05) out_.push_back(std::move(s));
  }

  // A program that draws none of an effect has this fault for sure, whatever else there is.
  void whole_effect(const std::string& effect, bool missing, const Pixels& change) {
    constexpr float kSeen = 1e-4f;
    Mask mask(c_.size());
    for (std::size_t i = 0; i < c_.size(); ++i)
      mask[i] = std::max({std::fabs(change[i][0]), std::fabs(change[i][1]), std::fabs(change[i][2])}) > kSeen;
    Suspicion s = c_.placed(effect + (missing ? " missing" : " added"),
                            missing ? "there is none" : "there is none in the reference", mask, 1);
    if (s.explained < 0.1 || s.precision < 0.3) return;
    s.sure = 0.88 + 0.12 * s.explained;
    out_.push_back(std::move(s));
  }

  // Whether the other terms, those that are not part of it, are what they were.
  bool told_alone(const std::string& kind, const Pixels& change) const {
    double others = 0;
    std::set<Key> keys;
    for (const auto* terms : {&was_, &is_})
      for (const auto& [key, light] : *terms)
        if (key.first != kind && !overlaps(key.first)) keys.insert(key);
    for (const Key& key : keys) {
      const auto of = [&](const std::map<Key, Pixels>& terms) {
        const auto it = terms.find(key);
        return it == terms.end() ? Pixels(c_.size()) : it->second;
      };
      others += squares(minus(of(is_), of(was_)));
    }
    if (overlaps(kind)) return std::fabs(others - squares(change)) < 0.2 * others;
    return others < 0.05 * squares(change);
  }

  void lights() {
    std::vector<const std::pair<const Key, Pixels>*> lost, gained;
    for (const auto& term : was_)
      if (term.first.first == "light" && !is_.contains(term.first)) lost.push_back(&term);
    for (const auto& term : is_)
      if (term.first.first == "light" && !was_.contains(term.first)) gained.push_back(&term);
    for (std::size_t i = 0; i < std::max(lost.size(), gained.size()); ++i) {
      if (i < lost.size() && i < gained.size())
        add("light moved",
            fmt::format("the {} shines in place of the {}", gained[i]->first.second, lost[i]->first.second),
            minus(gained[i]->second, lost[i]->second), weight::kKnown);
      else if (i < lost.size())
        add("light missing", "the " + lost[i]->first.second, minus(Pixels(c_.size()), lost[i]->second), weight::kKnown);
      else
        add("light added", "the " + gained[i]->first.second, gained[i]->second, weight::kKnown);
    }
    for (const auto& [key, before] : was_)
      if (const auto it = is_.find(key); key.first == "light" && it != is_.end())
        changed_light(key.second, before, it->second);
  }

  void changed_light(const std::string& name, const Pixels& before, const Pixels& after) {
    constexpr double kShadow = 0.5;
    const Pixels change = minus(after, before);
    const double all = squares(change);
    if (all <= 0) return;
    if (const Proportion p = proportion(before, change); p.explained > kProportional) {
      const auto [what, detail] = strength("light", name, p);
      return add(what, detail, change, weight::kKnown);
    }
    double lost = 0, won = 0;  // light where there was none, and the reverse
    for (std::size_t i = 0; i < c_.size(); ++i) {
      const bool dark_before = squared_distance(before[i], {}) == 0, dark_after = squared_distance(after[i], {}) == 0;
      (dark_before ? won : lost) += dark_before != dark_after ? squared_distance(change[i], {}) : 0;
    }
    if (won + lost > kShadow * all)
      return add("shadows",
                 fmt::format("of the {}: {}", name,
                             won > 3 * lost   ? "missing"
                             : lost > 3 * won ? "too much of them"
                                              : "elsewhere"),
                 change, 0.85);
    if (!surface_of_some(before, change))
      add("light", fmt::format("the {} is differently distributed", name), change, weight::kPlace);
  }

  // A light that is only different on some objects, or changes from pixel to pixel, is not to blame: their texture is.
  bool surface_of_some(const Pixels& before, const Pixels& change) {
    constexpr double kMax = 0.97, kElsewhere = 0.15, kRough = 0.6;
    const auto energy = [&](const Pixels& light, const Mask& mask) {
      double sum = 0;
      for (std::size_t i = 0; i < c_.size(); ++i) sum += mask[i] ? squared_distance(light[i], {}) : 0;
      return sum;
    };
    struct Object {
      std::string name;
      Mask mask;
      double change = 0;
    };
    std::vector<Object> objects;
    for (const PixelTags::Tag& tag : c_.tags.reference->tags)
      if (tag.kind == "object") {
        Object& o = objects.emplace_back();
        o.name = tag.name,
        o.mask = c_.pixels_with(*c_.tags.reference, [&](const PixelTags::Tag& other) { return &other == &tag; }),
        o.change = energy(change, o.mask);
      }
    std::stable_sort(objects.begin(), objects.end(),
                     [](const Object& a, const Object& b) { return a.change > b.change; });
    Mask changed(c_.size());
    std::string names;
    double seen = 0, all = squares(change);
    for (const Object& o : objects) {
      if (seen >= kMax * all) break;
      seen += o.change, names += (names.empty() ? "" : ", ") + o.name;
      for (std::size_t i = 0; i < c_.size(); ++i) changed[i] = changed[i] || o.mask[i];
    }
    const bool some = energy(before, changed) < (1 - kElsewhere) * squares(before);
    const bool rough = squares(blurred(c_, change, 1.5)) < kRough * all;
    if (!some && !rough) return false;
    const auto [what, patterns] = texture_of(changed);
    if (!what) return false;
    add(what, patterns + " of " + names, change, 0.92);
    return true;
  }

  // The patterns that these pixels show; whether pigments or normals are to blame: normals do not change ambient light.
  std::pair<const char*, std::string> texture_of(const Mask& mask) const {
    std::string pigments, normals;
    for (const PixelTags::Tag& tag : c_.tags.reference->tags) {
      if (tag.kind != "texture") continue;
      const Mask with = c_.pixels_with(*c_.tags.reference, [&](const PixelTags::Tag& other) { return &other == &tag; });
      std::size_t both = 0;
      for (std::size_t i = 0; i < c_.size(); ++i) both += with[i] && mask[i] && c_.wrong[i];
      if (static_cast<double>(both) < 0.3 * static_cast<double>(c_.wrong_count)) continue;
      std::string& list = tag.name.starts_with("normal") ? normals : pigments;
      list += (list.empty() ? "" : ", ") + tag.name;
    }
    const auto own = [&](const std::map<Key, Pixels>& terms) {
      const auto it = terms.find({"own light", "ambient and emission"});
      return it == terms.end() ? Pixels(c_.size()) : it->second;
    };
    const bool own_light_changed = squares(minus(own(is_), own(was_))) > 0;
    if (!normals.empty() && !own_light_changed) return {"normals", normals};
    if (!pigments.empty()) return {"texture", pigments};
    return {nullptr, ""};
  }

  const Case& c_;
  Suspicions& out_;
  std::map<Key, Pixels> was_, is_;
  Transfer transfer_;
  Pixels lit_;
  bool outlines_kept_ = false;  // objects are seen where they were
};

}  // namespace

void suspect_terms(const Case& c, Suspicions& out) {
  if (!c.tags.any()) return;
  Terms terms(c, out);
  if (c.tags.both()) terms.compare_both();
  // What both sides tell needs no fit; and where they tell of no difference, it came later.
  if (!c.tags.both()) terms.fit_one(c.tags.reference != nullptr);
}

std::optional<double> told_by_terms(const Case& c) {
  if (!c.tags.both() || c.tags.reference->parts.empty() || c.tags.test->parts.empty()) return std::nullopt;
  Suspicions none;
  return Terms(c, none).told();
}

}  // namespace verisim::compare
