#include "tracer/shapes/julia/julia_algebra.h"

#include "tracer/functions/plain_library.h"

namespace verisim::shapes::julia {

namespace {

namespace one_function {
using namespace one_ray;
#include "tracer/shapes/julia/julia_functions.inc"
}  // namespace one_function

}  // namespace

Number image_by_function(const Field& f, const Number& h) {
  const one_function::ComplexFunctions<functions::PlainLibrary> complex{};
  const auto image = [&](const auto& z) { return complex.image(f, z); };
  return one_function::hypercomplex_of<Number>(image(one_function::first_of(h)), image(one_function::second_of(h)));
}

}  // namespace verisim::shapes::julia
