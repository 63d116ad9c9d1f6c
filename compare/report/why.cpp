#include "compare/report/why.h"

#include <fmt/format.h>

#include <map>
#include <regex>

namespace verisim::compare {
namespace {

// Of a figure {0} and its limit {1}.
const std::map<std::string, const char*> kSentences{
    {"within_1_pct", "{0} % of the pixels are within one code value of the reference; {1} % must be"},
    {"within_2_pct", "{0} % of the pixels are within two code values of the reference; {1} % must be"},
    {"rmse", "the root mean square difference is {0} code values; {1} are allowed"},
    {"mae", "the mean absolute difference is {0} code values; {1} are allowed"},
    {"bias", "the picture is {0} code values to one side on average; {1} are allowed"},
    {"max_abs", "the largest difference is {0} code values; {1} are allowed"},
    {"psnr", "the peak signal-to-noise ratio is {0} dB; {1} dB are needed"},
    {"ssim_mean", "the structural similarity (SSIM) is {0}; {1} is needed"},
    {"ssim_block_min", "the structural similarity (SSIM) of the worst 8x8 block is {0}; {1} is needed"},
    {"flip_mean", "the mean FLIP error is {0}; {1} is allowed"},
    {"hdr_flip_mean", "the mean HDR-FLIP error is {0}; {1} is allowed"},
    {"ciede2000_mean", "the mean colour difference (CIEDE2000) is {0}; {1} is allowed"},
    {"ciede2000_p95", "5 % of the pixels have a colour difference (CIEDE2000) above {0}; {1} is allowed"},
    {"solid_2_pixels", "{0} pixels of patches are wrong by more than two code values; {1} may be"},
    {"solid_4_pixels", "{0} pixels of patches are wrong by more than four code values; {1} may be"},
    {"one_sided_pixels", "{0} connected pixels all go to one side, each by however little; {1} may"},
    {"leaning", "{0} of the pixels go to one side, each by however little; {1} may"},
    {"drift_max", "16x16 pixels differ by {0} code values on average, all to one side; {1} are allowed"},
    {"alpha_max_abs", "alpha differs by up to {0} code values; {1} are allowed"}};

}  // namespace

std::string why(const SceneResult& scene) {
  static const std::regex kFigure(R"(^(.*?)((?:blurred )?\w+) (-?[0-9.]+(?:e[-+]?\d+)?) ([<>]) ([0-9.]+)(.*)$)");
  std::smatch parts;
  const std::string& reason = scene.reason;
  // Messages of programs may be long; the sentences of verdicts are not.
  if (reason.size() > 400 || scene.status == Status::error || !std::regex_match(reason, parts, kFigure)) return reason;
  const auto known = kSentences.find(parts[2]);
  std::string sentence = parts[1].str();
  if (known != kSentences.end())
    sentence += fmt::format(fmt::runtime(known->second), parts[3].str(), parts[5].str());
  else
    sentence += fmt::format("{} is {}; the limit is {}", parts[2].str(), parts[3].str(), parts[5].str());
  if (!sentence.empty()) sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence + parts[6].str() + (parts[6].length() == 0 ? "." : "");
}

}  // namespace verisim::compare
