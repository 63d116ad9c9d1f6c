// Bounds of a function's value that come closer octave by octave. Whether a value is below a limit is mostly known long
// before the value is.
//
// Rounding never turns the order of two numbers around: bounds stay bounds, exactly, through operations that only ever
// rise or only ever fall.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "tracer/functions/program.h"
#include "tracer/math/vec.h"
#include "tracer/noise/noise_kernels.h"

namespace verisim::functions {

// Of one value: equal where it is known.
struct Bounds {
  double low, high;
};

// A sum of octaves of noise.
class OctaveSum {
 public:
  // One sum: how far it is.
  struct Partial {
    int done = 0;      // octaves
    Vec3 next;         // the place of the next one
    double last, sum;  // what the last one is, and all so far
  };
  // Room for sums one after the other, of the same arguments but for the place.
  struct Workspace {
    textures::EightPoints points;
    // Whether sums can be broken off, how many octaves there are, how much larger the coordinates become, and what the
    // octaves from each one add at most, for what the octave before it is.
    bool known = false, gradual = false;
    int count = 0, generator = 0;
    double growth = 0;
    std::array<double, 9> rest{};
  };
  virtual ~OctaveSum() = default;
  // Bounds of the computed value with a few octaves, and with some more of them. The arguments are a place and
  // parameters.
  virtual Bounds begin(std::span<const double> arguments, Partial& sum, Workspace& workspace) const = 0;
  virtual Bounds narrow(std::span<const double> arguments, Partial& sum, Workspace& workspace) const = 0;
};

// A program of x, y and z that asks for one such sum and does little to it.
class Narrowing {
 public:
  // Null: the function is not one.
  static std::unique_ptr<const Narrowing> of(const Function* function);

  static constexpr std::size_t kMaxRegisters = 32;
  struct Workspace {
    explicit Workspace(const Narrowing& narrowing) : registers(narrowing.registers_) {}
    std::array<Bounds, kMaxRegisters> registers;
    OctaveSum::Workspace sums;
  };
  // What the program computes at a point, as far as it is known.
  struct Value {
    Vec3 p;
    OctaveSum::Partial sum;
    Bounds bounds;
    bool exact() const { return bounds.low == bounds.high; }
  };
  void begin(const Vec3& p, Value& value, Workspace& workspace) const;
  // One step closer; false: the value was known, or is NaN.
  bool narrow(Value& value, Workspace& workspace) const;

 private:
  struct Step {
    Code code;
    std::uint8_t to, a, b;
  };
  static void run(std::span<const Step> steps, Bounds* registers);
  template <class Sum>
  Bounds evaluate(const Vec3& p, Workspace& workspace, Sum sum) const;

  const OctaveSum* sum_ = nullptr;
  std::vector<std::uint8_t> arguments_;
  std::uint8_t of_sum_ = 0, result_ = 0;
  std::vector<Step> before_, behind_;              // each sets a register of its own
  std::array<Bounds, kMaxRegisters> registers_{};  // where it begins
};

}  // namespace verisim::functions
