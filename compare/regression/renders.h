// The two pictures of a scene in a run: verisim's, and what it is compared with. Scenes of several passes are summed
// here; runs of a noisy scene are told apart by numbers.
#pragma once

#include <optional>

#include "compare/compare.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {

// "lights/shadow.pov" as a file name that no other scene has.
std::string file_stem(const std::string& name);
// Files of the scene's own folder and of the library by their names alone.
std::string short_names(std::string text, const WorkingCopy& copy, const std::vector<std::filesystem::path>& library);

class Renders {
 public:
  // `options` outlives this.
  Renders(const RunOptions& options, std::filesystem::path work, std::optional<OracleProgram> oracle, int threads_each)
      : options_(options), work_(std::move(work)), oracle_(std::move(oracle)), threads_each_(threads_each) {}

  // verisim's picture, in the file `output`. `files_read` gets the scene's own files by their original names.
  NativeResult native(const SceneRequest& request, const std::filesystem::path& output, int run,
                      std::vector<std::filesystem::path>& files_read) const;
  // A picture by another renderer. Throws std::runtime_error with what it said when there is none.
  Picture by(const NativeRenderer& renderer, const SceneRequest& request, const std::filesystem::path& output) const;
  // The oracle's, or what takes its place.
  OracleRender reference(const SceneRequest& request, const std::vector<std::filesystem::path>& files_read,
                         int variant) const;

  std::filesystem::path native_output(const SceneRequest& request, const std::string& stem, int run) const;
  // Pictures as good as the reference.
  std::vector<std::filesystem::path> alternatives(const SceneRequest& request) const;
  // What takes the oracle's place; empty: nothing.
  std::filesystem::path stored_picture(const SceneRequest& request) const;
  // The file that the reference was read from, when it is there to be read again; empty: POV-Ray's, or a sum of passes.
  std::filesystem::path reference_file(const SceneRequest& request) const;
  NativeRequest native_request(const SceneRequest& request, const WorkingCopy& copy) const;
  std::vector<std::filesystem::path> library_paths() const {
    return oracle_ ? oracle_->library_paths : std::vector<std::filesystem::path>();
  }
  const std::optional<OracleProgram>& oracle() const { return oracle_; }
  const std::filesystem::path& work() const { return work_; }

 private:
  NativeResult rendered(const NativeRenderer& renderer, const SceneRequest& request,
                        const std::filesystem::path& output, int run,
                        std::vector<std::filesystem::path>& files_read) const;
  std::filesystem::path command_output(const SceneRequest& request, int variant) const;
  OracleRender by_command(const SceneRequest& request, int variant) const;
  NativeResult native_passes(const SceneRequest& request, const std::filesystem::path& output, int run,
                             std::vector<std::filesystem::path>& files_read) const;
  OracleRender oracle_picture(const SceneRequest& request, const OracleOptions& options, int variant,
                              const std::vector<std::filesystem::path>& files_read) const;

  const RunOptions& options_;
  std::filesystem::path work_;
  std::optional<OracleProgram> oracle_;
  int threads_each_;
};

}  // namespace verisim::compare
