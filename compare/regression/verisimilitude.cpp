#include "compare/regression/verisimilitude.h"

#include "compare/regression/programs/command_renderer.h"
#include "compare/regression/result_store.h"

namespace verisim::compare {
namespace {

Likeness likeness_of(const std::string& renderer, const Metrics& m) {
  return {renderer, m.ciede2000_mean, m.flip_mean, m.rmse};
}

// One of the names that the program gives, or a command.
NativeRenderer renderer_of(const std::string& name, const RunOptions& options) {
  const auto known = options.beside.find(name);
  return known == options.beside.end() ? command_renderer(name) : known->second;
}

Likeness measured(const std::string& name, const SceneRequest& request, const Picture& photograph,
                  const RunOptions& options, const Renders& renders, std::size_t number) {
  try {
    const std::string stem = file_stem(request.name) + ".beside" + std::to_string(number);
    const Picture picture = renders.by(renderer_of(name, options), request, renders.native_output(request, stem, 0));
    const FittedPair pair = fit_to_reference(photograph, picture, request.fit);
    return likeness_of(name, measure(pair.reference, pair.test, metric_options(request)));
  } catch (const std::exception& error) {
    return {name, 0, 0, 0, error.what()};
  }
}

}  // namespace

std::vector<Likeness> likenesses(const SceneRequest& request, const Picture& photograph, const Metrics& judged,
                                 const RunOptions& options, const Renders& renders) {
  std::vector<Likeness> out{likeness_of("", judged)};
  for (const std::string& name : request.beside)
    out.push_back(measured(name, request, photograph, options, renders, out.size()));
  return out;
}

}  // namespace verisim::compare
