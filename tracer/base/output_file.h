// Where every file that the program makes is opened: pictures, reports, statistics, heat maps, photon maps.
//
//   OutputFile file("report.json");
//   std::fputs(text, file.get());
//   file.publish();
//
// A regular file appears whole or not at all: it is written without a name, or under a temporary one, and then takes
// the place of what had its name; readers never see half of it. What a symbolic link names is replaced, not the link.
// Anything else, a device, a pipe, an open file of this process (/dev/stdout), is written through and stays what it is.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace verisim {

class OutputFile {
 public:
  // Throws std::runtime_error naming the file and the reason, as all here.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();  // unpublished: nothing is left behind
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::FILE* get() { return file_.get(); }
  // Gives the written file its name, in the place of what had it.
  void publish();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void open_new(const std::optional<unsigned>& mode);

  std::filesystem::path name_;              // as the user knows it
  std::filesystem::path path_, temporary_;  // behind all links
  std::unique_ptr<std::FILE, Closer> file_;
  bool in_place_ = false;
  bool named_ = false;  // there is a file under the temporary name
};

// What a path names behind symbolic links, whether it is there or not.
std::filesystem::path behind_links(const std::filesystem::path& path);

// For long work that ends in a file: throws at its beginning what would go wrong at its end. Nothing is opened that is
// not a regular file.
void require_writable(const std::filesystem::path& path);

void write_text_file(const std::filesystem::path& path, std::string_view text);

// For libraries that want a name: `body` writes a file with the given ending, which then becomes `path` in the way of
// an OutputFile; "-" is standard output.
void write_by_name(const std::filesystem::path& path, std::string_view extension,
                   const std::function<void(const std::filesystem::path& temporary)>& body);

// Copies a whole file into an open one.
void copy_into(const std::filesystem::path& from, std::FILE* to);

}  // namespace verisim
