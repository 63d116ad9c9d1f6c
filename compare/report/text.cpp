// Reports as text: the terminal's table, Markdown for a pull request, GitHub annotations, JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "compare/compare.h"
#include "compare/report/known_answers.h"
#include "compare/report/verisimilitude.h"
#include "compare/report/markdown_cell.h"
#include "compare/report/markup.h"

namespace verisim::compare {
namespace {

constexpr const char *kReset = "\033[0m", *kBold = "\033[1m", *kGreen = "\033[32m", *kYellow = "\033[33m",
                     *kRed = "\033[31m";

const char* color_of(Status status) {
  switch (status) {
    case Status::exact:
    case Status::match:
      return kGreen;
    case Status::unsupported:
      return kYellow;
    default:
      return kRed;
  }
}

// The length of the well-formed UTF-8 sequence at i; 0 if there is none.
std::size_t utf8_length(const std::string& s, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < s.size() ? static_cast<unsigned char>(s[k]) : 0u; };
  const unsigned first = byte(i);
  const std::size_t n = first < 0x80                    ? 1
                        : first >= 0xc2 && first < 0xe0 ? 2
                        : first >= 0xe0 && first < 0xf0 ? 3
                        : first >= 0xf0 && first < 0xf5 ? 4
                                                        : 0;
  for (std::size_t k = 1; k < n; ++k)
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
  if ((first == 0xe0 && byte(i + 1) < 0xa0) || (first == 0xed && byte(i + 1) >= 0xa0) ||
      (first == 0xf0 && byte(i + 1) < 0x90) || (first == 0xf4 && byte(i + 1) >= 0x90))
    return 0;
  return n;
}

// Control characters and broken UTF-8 of a hostile scene name or message must not reach a terminal or a report.
std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    const bool control = c < 0x20 || c == 0x7f ||
                         (c == 0xc2 && n == 2 && static_cast<unsigned char>(text[i + 1]) < 0xa0);  // C0, DEL, C1
    if (n == 0)
      out += "\xef\xbf\xbd";  // U+FFFD
    else if (control)
      out += ' ';
    else
      out.append(text, i, n);
    i += std::max<std::size_t>(n, 1);
  }
  return out;
}

std::size_t glyphs(const std::string& s) {
  return static_cast<std::size_t>(
      std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}
// The end of a name tells more than its beginning.
std::string fitted(std::string s, std::size_t width) {
  if (glyphs(s) > width && width > 1) {
    while (glyphs(s) > width - 1) s.erase(0, 1);
    while (!s.empty() && (static_cast<unsigned char>(s[0]) & 0xc0) == 0x80) s.erase(0, 1);
    s = "…" + s;
  }
  return s + std::string(width - std::min(width, glyphs(s)), ' ');
}

std::string decibels(double psnr) {
  return psnr < kPsnrOfEqualPictures ? fmt::format("{:.2f}", psnr) : fmt::format("{:.0f}", kPsnrOfEqualPictures);
}
std::string ratio(double oracle, double native) {
  return native > 0 && oracle > 0 ? fmt::format("{:.1f}x", oracle / native) : "-";
}

// A message is cut where a character ends.
std::string shortened(std::string s, std::size_t bytes) {
  if (s.size() <= bytes) return s;
  s.resize(bytes);
  while (!s.empty() && (static_cast<unsigned char>(s.back()) & 0xc0) == 0x80) s.pop_back();
  if (!s.empty() && (static_cast<unsigned char>(s.back()) & 0x80)) s.pop_back();
  return s + "…";
}

std::string summary_line(const Run& run) {
  std::string out = fmt::format("{} {}", run.summary.scenes, run.summary.scenes == 1 ? "scene" : "scenes");
  for (const auto& [status, count] : run.summary.count)
    if (count) out += fmt::format(", {} {}", count, to_string(status));
  const Summary& s = run.summary;
  const bool cpu = s.oracle_cpu_seconds > 0 && s.native_cpu_seconds > 0;
  const double oracle = cpu ? s.oracle_cpu_seconds : s.oracle_seconds,
               native = cpu ? s.native_cpu_seconds : s.native_seconds;
  out += fmt::format("; {} {:.2f} s, {} {:.2f} s{}", run.reference_name, oracle, run.test_name, native,
                     cpu ? " of CPU time" : "");
  if (native > 0 && oracle > 0) out += fmt::format(", ratio {}", ratio(oracle, native));
  if (run.cancelled) out += " (broken off)";
  return out;
}

// CPU seconds of both sides; wall time where one of them is unknown (a renderer that is a function, a stored picture).
std::pair<double, double> seconds_of(const SceneResult& s) {
  if (s.oracle_cpu_seconds > 0 && s.native_cpu_seconds > 0) return {s.oracle_cpu_seconds, s.native_cpu_seconds};
  return {s.oracle_seconds, s.native_seconds};
}

std::string common_tag(const CommonTag& tag) {
  return fmt::format("{} {}: {:.0f} % of the wrong pixels, {:.1f} % of the right ones", tag.kind, tag.name, tag.bad_pct,
                     tag.good_pct);
}

std::string reason(const SceneResult& s) {
  std::string out = s.reason;
  if (!s.suspicions.empty()) out += fmt::format("; suspect {}: {}", s.suspicions[0].what, s.suspicions[0].detail);
  if (s.blame && !s.blame->common.empty()) out += "; " + common_tag(s.blame->common[0]);
  if (!s.request.known_failure.empty())
    out += fmt::format("{}{}: {}", out.empty() ? "" : "; ",
                       s.passed() ? "passes, though it was known to fail" : "known to fail", s.request.known_failure);
  if (s.fit && !s.fit->text().empty()) out += fmt::format(" ({})", s.fit->text());
  return out;
}

std::string trend(const SceneResult& s) {
  if (!s.previous) return "";
  if (*s.previous != s.status) return fmt::format(" (was {})", to_string(*s.previous));
  if (s.metrics && s.previous_rmse && std::fabs(s.metrics->rmse - *s.previous_rmse) > 0.005)
    return fmt::format(" (rmse was {:.3f})", *s.previous_rmse);
  return "";
}

std::string xml(const std::string& text) { return markup_escaped(printable(text)); }

}  // namespace

std::string markdown_cell(const std::string& text) {
  std::string out;
  for (char c : printable(text)) {
    if (c == '|' || c == '<' || c == '`' || c == '*' || c == '_' || c == '[') out += '\\';
    out += c;
  }
  return out;
}

namespace {

// GitHub's workflow commands: percent, line ends, and in properties comma and colon are escaped.
std::string github_escape(const std::string& text, bool property) {
  std::string out;
  for (char c : text) {  // line ends are escaped, not lost
    if (c == '%' || c == '\r' || c == '\n' || (property && (c == ':' || c == ',')))
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string terminal_table(const Run& run, bool color, int columns) {
  std::size_t name_width = 12;
  for (const SceneResult& s : run.scenes) name_width = std::max(name_width, glyphs(s.request.name));
  constexpr int kFigures = 101;  // everything after the name
  if (columns > 0)
    name_width = std::min<std::size_t>(name_width, static_cast<std::size_t>(std::max(16, columns - kFigures)));
  std::string out = fmt::format("{}{} {:<13} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>8} {:>8} {:>7}{}\n",
                                color ? kBold : "", fitted("scene", name_width), "status", "RMSE", "PSNR", "SSIM",
                                "FLIP", "<=1 [%]", "<=2 [%]", "max", run.oracle_version.empty() ? "ref [s]" : "POV [s]",
                                "ours [s]", "ratio", color ? kReset : "");  // CPU seconds
  for (const SceneResult& s : run.scenes) {
    out += fitted(printable(s.request.name), name_width) + ' ';
    out += fmt::format("{}{:<13}{}", color ? color_of(s.status) : "", to_string(s.status), color ? kReset : "");
    if (s.metrics) {
      const Metrics& m = *s.metrics;
      const auto [oracle, native] = seconds_of(s);
      out += fmt::format(" {:>7.3f} {:>7} {:>7.4f} {:>7.4f} {:>8.3f} {:>7.3f} {:>7.1f} {:>8.2f} {:>8.2f} {:>7}", m.rmse,
                         decibels(m.psnr), m.ssim_mean, m.flip_mean, m.within_1_pct, m.within_2_pct, m.max_abs, oracle,
                         native, ratio(oracle, native));
    }
    const bool explain =
        (!s.passed() && !s.reason.empty()) || !s.request.known_failure.empty() || !s.suspicions.empty() || s.fit;
    if (explain) out += ' ' + shortened(printable(reason(s)), 300);
    if (const std::string known = known_answer(s, run); !known.empty()) out += "  " + printable(known);
    if (const std::string like = verisimilitude(s, run); !like.empty()) out += "  " + printable(like);
    out += trend(s) + '\n';
  }
  if (const std::string known = known_answers(run); !known.empty()) out += printable(known) + '\n';
  return out + summary_line(run) + '\n';
}

std::string terminal_layers(const std::vector<LayerResult>& layers) {
  std::string out;
  for (const LayerResult& l : layers)
    out += fmt::format("layer {} ({}): {}{}\n", printable(l.name), l.kind, to_string(l.status),
                       !l.reason.empty() ? ": " + printable(l.reason)
                       : l.max_abs > 0   ? fmt::format(", largest difference {:.4g}", l.max_abs)
                                         : "");
  return out;
}

std::string terminal_metrics(const Metrics& m, bool color) {
  const auto line = [&](const char* name, const std::string& value, const char* unit) {
    return fmt::format("{}{:<18}{} {:>12} {}\n", color ? kBold : "", name, color ? kReset : "", value, unit);
  };
  std::string out = line("size", fmt::format("{}x{}", m.width, m.height), "pixels");
  out += line("max_abs", fmt::format("{:.2f}", m.max_abs), "/255");
  out += line("mae", fmt::format("{:.4f}", m.mae), "/255");
  out += line("rmse", fmt::format("{:.4f}", m.rmse), "/255");
  out += line("bias", fmt::format("{:+.4f}", m.bias), "/255");
  out += line("psnr", decibels(m.psnr), "dB");
  out += line("within_1", fmt::format("{:.4f}", m.within_1_pct), "% of pixels");
  out += line("within_2", fmt::format("{:.4f}", m.within_2_pct), "% of pixels");
  out += line("ssim_mean", fmt::format("{:.6f}", m.ssim_mean), "");
  out += line("ssim_block_min", fmt::format("{:.6f}", m.ssim_block_min), "worst 8x8 block");
  out += line("solid_2_pixels", fmt::format("{}", m.solid_2_pixels),
              m.solid_2_pixels ? fmt::format("in patches, the worst around {}, {}", m.solid_x, m.solid_y).c_str()
                               : "in patches");
  out += line("drift_max", fmt::format("{:.4f}", m.drift_max),
              m.drift_max > 0 ? fmt::format("/255, mean of 16x16 pixels around {}, {}", m.drift_x, m.drift_y).c_str()
                              : "/255, mean of 16x16 pixels");
  out += line(
      "one_sided_pixels", fmt::format("{}", m.one_sided_pixels),
      m.one_sided_pixels ? fmt::format("connected, around {}, {}", m.one_sided_x, m.one_sided_y).c_str() : "connected");
  out += line("leaning", fmt::format("{:.4f}", m.signs.share()),
              fmt::format("of the pixels: {} brighter, {} darker", m.signs.brighter, m.signs.darker).c_str());
  out += line("flip_mean", fmt::format("{:.6f}", m.flip_mean), "LDR-FLIP");
  if (m.hdr_flip_mean) out += line("hdr_flip_mean", fmt::format("{:.6f}", *m.hdr_flip_mean), "HDR-FLIP");
  out += line("ciede2000_mean", fmt::format("{:.4f}", m.ciede2000_mean), "");
  out += line("ciede2000_p95", fmt::format("{:.4f}", m.ciede2000_p95), "");
  if (m.edge_rmse)
    out += line("edge_rmse", fmt::format("{:.4f}", *m.edge_rmse),
                fmt::format("/255, on {:.1f} % of the pixels", m.edge_pct).c_str());
  if (m.interior_rmse) out += line("interior_rmse", fmt::format("{:.4f}", *m.interior_rmse), "/255");
  if (m.alpha_max_abs) out += line("alpha_max_abs", fmt::format("{:.2f}", *m.alpha_max_abs), "/255");
  if (m.nan_pixels) out += line("nan_pixels", fmt::format("{}", m.nan_pixels), "NaN or infinite");
  for (std::size_t i = 0; i < std::min<std::size_t>(5, m.worst.size()); ++i) {
    const WorstPixel& p = m.worst[i];
    out += fmt::format("  pixel {},{}: {:.0f} {:.0f} {:.0f} is {:.0f} {:.0f} {:.0f} in the other, {:.0f} apart\n", p.x,
                       p.y, p.reference[0], p.reference[1], p.reference[2], p.test[0], p.test[1], p.test[2], p.error);
  }
  return out;
}

std::string terminal_blame(const SceneResult& s) {
  std::string out = fmt::format("{}: {}{}{}\n", printable(s.request.name), to_string(s.status),
                                s.reason.empty() ? "" : ": ", printable(s.reason));
  for (const Suspicion& v : s.suspicions)
    out += fmt::format("suspect {}: {} (explains {:.0f} %)\n", v.what, v.detail, 100 * v.explained);
  if (!s.blame) return s.blame_failed.empty() ? out : out + printable(s.blame_failed) + "\n";
  const Blame& b = *s.blame;
  out += fmt::format("{} of {} pixels differ by more than {} code values\n", b.bad, b.bad + b.good, b.limit);
  constexpr std::size_t kLines = 12;
  if (!b.common.empty()) out += "\nwhat they have in common       wrong   right    phi\n";
  for (std::size_t i = 0; i < std::min(kLines, b.common.size()); ++i)
    out += fmt::format("  {:<26} {:>7.2f} % {:>5.2f} % {:>6.3f}  {}\n", b.common[i].kind, b.common[i].bad_pct,
                       b.common[i].good_pct, b.common[i].correlation, printable(b.common[i].name));
  out += "\nobject: part of the squared difference, of the picture, its wrong pixels, RMSE, bias, worst pixel\n";
  for (std::size_t i = 0; i < std::min(kLines, b.objects.size()); ++i) {
    const ObjectError& o = b.objects[i];
    out += fmt::format("  {:>6.2f} % {:>6.2f} % {:>6.2f} % {:>8.3f} {:>+8.3f}  {},{}  {}\n", 100 * o.share,
                       o.pixels_pct, o.bad_pct, o.rmse, o.bias, o.worst_x, o.worst_y, printable(o.name));
  }
  if (s.metrics && !s.metrics->worst.empty()) {
    std::string switches;
    for (const std::string& w : s.request.switches) switches += " " + printable(w);
    out += fmt::format("\nthe worst pixel: verisim explain {} {} {} +W{} +H{}{}\n", printable(s.request.scene.string()),
                       s.metrics->worst[0].x, s.metrics->worst[0].y, s.request.width, s.request.height, switches);
  }
  return out;
}

std::string markdown_report(const Run& run) {
  std::string out =
      fmt::format("### {} verisim compare\n\n{}\n\n", run.summary.failed() ? "❌" : "✅", summary_line(run));
  std::vector<const SceneResult*> order;
  for (const SceneResult& s : run.scenes) order.push_back(&s);
  std::stable_sort(order.begin(), order.end(),
                   [](const SceneResult* a, const SceneResult* b) { return a->failed() > b->failed(); });
  out +=
      "| scene | status | RMSE | SSIM | FLIP | within 1 [%] | oracle [CPU s] | verisim [CPU s] | note |\n| --- | --- | "
      "---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
  for (const SceneResult* s : order) {
    const std::string figures =
        s->metrics ? fmt::format("{:.3f} | {:.4f} | {:.4f} | {:.3f}", s->metrics->rmse, s->metrics->ssim_mean,
                                 s->metrics->flip_mean, s->metrics->within_1_pct)
                   : "| | |";
    const auto [oracle, native] = seconds_of(*s);
    out += fmt::format("| {} | {} | {} | {:.2f} | {:.2f} | {}{} |\n", markdown_cell(s->request.name),
                       to_string(s->status), figures, oracle, native,
                       s->failed() ? markdown_cell(shortened(reason(*s), 200)) : "", markdown_cell(trend(*s)));
  }
  return out;
}

namespace {

// The line of the scene file that a text names as "room.pov:11"; empty when it names none.
std::optional<int> line_in(const std::string& text, const std::string& file) {
  for (std::size_t at = text.find(file + ":"); at != std::string::npos; at = text.find(file + ":", at + 1)) {
    const char* digits = text.c_str() + at + file.size() + 1;
    if (const int line = std::atoi(digits); line > 0) return line;
  }
  return std::nullopt;
}

// Where the error is, or the object that wrong pixels show.
std::optional<int> line_of(const SceneResult& s) {
  const std::string file = s.request.scene.filename().string();
  if (const auto line = line_in(s.reason, file)) return line;
  if (!s.blame) return std::nullopt;
  for (const CommonTag& tag : s.blame->common)
    if (const auto line = line_in(tag.name, file)) return line;
  return s.blame->objects.empty() ? std::nullopt : line_in(s.blame->objects[0].name, file);
}

}  // namespace

std::string github_annotations(const Run& run) {
  std::string out;
  for (const SceneResult& s : run.scenes) {
    if (!s.failed()) continue;
    const char* level = s.status == Status::unsupported ? "warning" : "error";
    std::string place;
    if (!s.request.scene.empty()) {  // a scene that is gone has none
      place = fmt::format("file={},", github_escape(s.request.scene.string(), true));
      if (const auto line = line_of(s)) place += fmt::format("line={},", *line);
    }
    out += fmt::format("::{} {}title={}::{}\n", level, place, github_escape("verisim: " + s.request.name, true),
                       github_escape(fmt::format("{}: {}", to_string(s.status), reason(s)), false));
  }
  out += fmt::format("::notice title=verisim compare::{}\n", github_escape(summary_line(run), false));
  return out;
}

std::string junit_report(const Run& run) {
  int failures = 0, errors = 0, skipped = 0;
  double total = 0;
  std::string cases;
  for (const SceneResult& s : run.scenes) {
    std::string body;
    const std::string message = xml(shortened(reason(s), 2000));
    switch (s.passed() || s.failed() ? s.status : Status::unsupported) {
      case Status::exact:
      case Status::match:
        break;
      case Status::unsupported:
        ++skipped, body = fmt::format("<skipped message=\"{}\"/>", message);
        break;
      case Status::differ:
        ++failures, body = fmt::format("<failure type=\"differ\" message=\"{}\"/>", message);
        break;
      default:
        ++errors, body = fmt::format("<error type=\"{}\" message=\"{}\"/>", to_string(s.status), message);
    }
    if (s.metrics)
      body += fmt::format(
          "<system-out>rmse {:.4f} psnr {} ssim {:.5f} flip {:.5f} within_1_pct {:.4f} max_abs {:.1f}</system-out>",
          s.metrics->rmse, decibels(s.metrics->psnr), s.metrics->ssim_mean, s.metrics->flip_mean,
          s.metrics->within_1_pct, s.metrics->max_abs);
    total += s.native_seconds;
    cases += fmt::format("    <testcase classname=\"verisim.compare\" name=\"{}\" time=\"{:.3f}\">{}</testcase>\n",
                         xml(s.request.name), s.native_seconds, body);
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"verisim compare\" tests=\"{}\" "
      "failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
      "time=\"{:.3f}\" timestamp=\"{}\">\n{}  </testsuite>\n</testsuites>\n",
      run.scenes.size(), failures, errors, skipped, total, run.started.substr(0, 19), cases);
}

}  // namespace verisim::compare
