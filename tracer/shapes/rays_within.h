// Searches from within an object (subsurface scattering) ask for everything in front, also where shapes leave out what
// is near: POV-Ray's rays know that they are such. CSG asks its parts for all hits, so the thread tells them.
#pragma once

namespace verisim::shapes {

class RaysWithin {
 public:
  RaysWithin() : before_(flag()) { flag() = true; }
  ~RaysWithin() { flag() = before_; }
  RaysWithin(const RaysWithin&) = delete;
  RaysWithin& operator=(const RaysWithin&) = delete;

  static bool now() { return flag(); }

 private:
  static bool& flag() {
    static thread_local bool within = false;
    return within;
  }

  const bool before_;
};

}  // namespace verisim::shapes
