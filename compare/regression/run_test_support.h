// A folder of scenes with a script in the place of POV-Ray and a function in the place of our renderer.
#pragma once

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

inline void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}
inline void script(const fs::path& path, const std::string& text) {
  write(path, "#!/bin/sh\n" + text);
  chmod(path.c_str(), 0755);
}

// Every scene file holds the name of the picture that the oracle will answer with.
class RunTest : public testing::Test {
 protected:
  RunTest() {
    image::write_picture(scene_like_picture(32, 24), pictures() / "plain.png");
    image::write_picture(changed(scene_like_picture(32, 24), [](double v) { return std::min(255.0, v + 30); }),
                         pictures() / "bright.png");
    std::mt19937 random(5);
    for (int i = 1; i <= 8; ++i) {
      std::normal_distribution<double> noise(0, 8);
      image::write_picture(changed(scene_like_picture(32, 24),
                                   [&](double v) { return std::clamp(std::round(v + noise(random)), 0.0, 255.0); }),
                           pictures() / fmt::format("noisy{}.png", i));
    }
    script(root() / "pov",
           "if [ \"$1\" = --version ]; then echo 'POV-Ray 3.7.test'; exit 0; fi\n"
           "for a in \"$@\"; do case \"$a\" in +I*) in=\"${a#+I}\";; +O*) out=\"${a#+O}\";; +WT*) t=\"${a#+WT}\";; "
           "esac; done\n"
           "echo \"$in\" >> " +
               (root() / "oracle.log").string() +
               "\n"
               "case $(cat $in) in crash) kill -SEGV $$;; hang) sleep 60;; noisy) cp " +
               pictures().string() + "/noisy$t.png $out;; *) cp " + pictures().string() + "/plain.png $out;; esac\n");
    options_.oracle.program = root() / "pov";
    options_.oracle.cache = root() / "cache";
    options_.oracle.time_limit = 20;
    options_.native = [this](const NativeRequest& request) { return native(request); };
    options_.native_version = "test 1";
  }

  const fs::path& root() const { return folder_.path(); }
  fs::path pictures() const {
    fs::create_directories(root() / "pictures");
    return root() / "pictures";
  }
  void scene(const std::string& name, const std::string& text) { write(root() / "scenes" / name, text); }
  Suite suite() const { return load_suite({root() / "scenes"}, {32, 24, {"-A"}}); }
  std::map<std::string, SceneResult> run() {
    last_ = run_suite(suite(), options_);
    std::map<std::string, SceneResult> out;
    for (const SceneResult& s : last_.scenes) out[s.request.name] = s;
    return out;
  }
  int oracle_runs() const {
    std::ifstream in(root() / "oracle.log");
    return static_cast<int>(std::count(std::istreambuf_iterator<char>(in), {}, '\n'));
  }

  NativeResult native(const NativeRequest& request) {
    ++native_runs_;
    std::ifstream in(request.scene);
    std::string text;
    std::getline(in, text);
    NativeResult out;
    out.files_read = {request.scene};
    if (text == "throws") throw std::runtime_error("thrown");
    if (text == "unsupported" || text == "bad") {
      out.outcome = text == "bad" ? NativeResult::Outcome::error : NativeResult::Outcome::unsupported;
      out.message = request.scene.string() + ":1:1: isosurface";
      return out;
    }
    out.outcome = NativeResult::Outcome::rendered;
    if (text == "noisy") out.stochastic_features = {"radiosity"};
    if (text == "forgets") return out;
    fs::copy_file(pictures() / (text == "noisy"                   ? fmt::format("noisy{}.png", 2 + 2 * request.run)
                                : text == "bright" || all_bright_ ? "bright.png"
                                                                  : "plain.png"),
                  request.output);
    out.seconds = 0.5, out.rays = {{"camera", 768}};
    return out;
  }

  TemporaryFolder folder_;
  RunOptions options_;
  compare::Run last_;
  std::atomic<int> native_runs_{0};
  bool all_bright_ = false;
};

}  // namespace verisim::compare
