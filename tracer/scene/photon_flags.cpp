// Flags of photons that turn each other off (spec 07 3.2).
#include "tracer/scene/object.h"

namespace verisim::scene {

PhotonFlags::TurnedOff PhotonFlags::set_target(double density) {
  target = density > 0;
  if (!target) return TurnedOff::nothing;
  target_spacing = density;
  if (!pass_through || refraction == Flag::off) return TurnedOff::nothing;
  if (refraction == Flag::on) {
    pass_through = false;
    return TurnedOff::pass_through;
  }
  refraction = Flag::off;
  return TurnedOff::refraction;
}

PhotonFlags::TurnedOff PhotonFlags::set_refraction(bool on) {
  refraction = on ? Flag::on : Flag::off;
  if (!on || !pass_through || !target) return TurnedOff::nothing;
  pass_through = false;
  return TurnedOff::pass_through;
}

PhotonFlags::TurnedOff PhotonFlags::set_pass_through(bool on) {
  pass_through = on;
  if (!on || !target || refraction == Flag::off) return TurnedOff::nothing;
  refraction = Flag::off;
  return TurnedOff::refraction;
}

void PhotonFlags::inherit(const PhotonFlags& parent, std::vector<TurnedOff>* turned_off) {
  if (!parent.given) return;
  const auto note = [&](TurnedOff what) {
    if (turned_off && what != TurnedOff::nothing) turned_off->push_back(what);
  };
  if (parent.target) note(set_target(parent.target_spacing));
  if (parent.pass_through) note(set_pass_through(true));
  if (parent.reflection != Flag::unset) reflection = parent.reflection;
  if (parent.refraction != Flag::unset) note(set_refraction(parent.refraction == Flag::on));
  if (!parent.collect) collect = false;
  given = true;
}

}  // namespace verisim::scene
