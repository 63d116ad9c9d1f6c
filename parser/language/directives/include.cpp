// #include and the files it reads (spec 01 section 17). A file is tokenised once, and again only when it has changed.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "parser/language/impl.h"
#include "parser/source/confinement.h"
#include "parser/source/standard_includes.h"

namespace verisim::parser {
namespace fs = std::filesystem;

void Parser::Impl::allow_read(const fs::path& path) {
  if (!search->may_read(path))
    error(Code::file_access, fmt::format("The scene may not read '{}'.", path.string()),
          "--allow-read PATH permits it.");
  if (!search->memory_file(path) && files_seen.insert(path.string()).second) report.files_read.push_back(path);
}

void Parser::Impl::open_search(fs::path scene_folder) {
  std::vector<fs::path> folders = options.library_paths;
  if (options.standard_includes)
    for (fs::path& folder : standard_include_folders()) folders.push_back(std::move(folder));
  search = std::make_unique<FileSearch>(std::move(folders), std::move(scene_folder), options.allow_read,
                                        options.allow_write, options.files);
}

std::shared_ptr<const TokenFile> Parser::Impl::load(const fs::path& path, const std::string& name, bool main) {
  allow_read(path);
  const std::shared_ptr<const MemoryFile> memory = search->memory_file(path);
  if (memory && !memory->bytes())
    error(Code::bad_file, fmt::format("'{}' holds samples: it cannot be read as text.", path.string()));
  std::error_code failed;
  if (options.unsaved)
    if (const std::optional<std::string> text = options.unsaved(path)) return load_unsaved(path, name, *text, main);
  const std::uintmax_t size = memory ? memory->bytes()->size() : fs::file_size(path, failed);
  const fs::file_time_type time = memory || failed ? fs::file_time_type{} : fs::last_write_time(path, failed);
  CachedFile& cached = file_cache[path.string()];
  if (!failed && cached.tokens && cached.size == size && cached.time == time) return cached.tokens;
  cached.tokens.reset();
  std::shared_ptr<const Source> source;
  try {
    source = memory ? Source::of(name, *memory->bytes(), options.limits.max_file_bytes)
                    : Source::read(path, name, options.limits.max_file_bytes);
  } catch (const std::runtime_error& e) {
    error(Code::internal, e.what());
  }
  const std::size_t left = options.limits.max_tokens - std::min(tokens_total, options.limits.max_tokens);
  cached.tokens = tokenise(std::move(source), names, left, main);
  cached.size = size;
  cached.time = time;
  tokens_total += cached.tokens->tokens.size();
  return cached.tokens;
}

// What an editor holds of a file; its tokens stay with the others that are kept by their path.
std::shared_ptr<const TokenFile> Parser::Impl::load_unsaved(const fs::path& path, const std::string& name,
                                                            const std::string& text, bool main) {
  CachedFile& cached = file_cache[path.string()];
  if (!cached.tokens || cached.tokens->source->text() != text)
    cached.tokens = tokenise(std::make_shared<Source>(name, text), names, options.limits.max_tokens, main);
  return cached.tokens;
}

void Parser::Impl::include() {
  const std::uint32_t call = index(position) - 1;
  const Spot at = next();
  const std::string name = utf8(string(true));
  const auto known = include_locations.find(name);
  fs::path path;
  if (std::error_code failed; known != include_locations.end() && fs::exists(known->second, failed)) {
    path = known->second;
  } else {
    const std::optional<fs::path> found = search->find_include(name);
    if (!found) missing_include(name, at);
    path = *found;
    include_locations[name] = path;
  }
  enter_file(load(path, path.string(), false), call);
}

void Parser::Impl::missing_include(const std::string& name, Spot at) {
  Diagnostic d =
      diagnostic(Severity::error, Code::missing_include, fmt::format("Cannot find include file '{}'.", name), {}, at);
  if (at.file) advise_file(d, name, at, true);
  throw ParseError{std::move(d)};
}

fs::path Parser::writable_file(const std::string& name) {
  if (name.empty() || name.find('\0') != std::string::npos || !impl_->search->may_write(name))
    error(Code::file_access, fmt::format("The scene may not write '{}'.", name),
          confinement.writes_named_only
              ? "In the sandbox scenes write nowhere; --allow-write PATH permits it."
              : "Scenes write below the current folder and their own; --allow-write PATH permits "
                "more.");
  impl_->fonts.clear();
  if (!impl_->options.scratch.empty()) return impl_->search->redirect(name, impl_->options.scratch);
  return name;
}

std::shared_ptr<const MemoryFile> Parser::memory_file(const std::string& name) const {
  return impl_->search->memory_file(name);
}

fs::path Parser::find_file(const std::string& name, std::string_view extensions) {
  if (const auto memory = memory_file(name)) {
    if (!memory->bytes()) error(Code::bad_file, fmt::format("'{}' holds samples: a file is wanted here.", name));
    impl_->report.files_kept.push_back(memory);
    return memory->path();
  }
  std::optional<fs::path> found;
  if (!fs::path(name).has_extension()) {
    for (std::size_t begin = 0; begin < extensions.size() && !found;) {
      const std::size_t end = std::min(extensions.find(' ', begin), extensions.size());
      found = impl_->search->find_exact(name + std::string(extensions.substr(begin, end - begin)));
      begin = end + 1;
    }
  }
  if (!found) found = impl_->search->find_exact(name);
  if (!found) {
    const Spot at = impl_->place_of(Code::missing_file);
    Diagnostic d =
        impl_->diagnostic(Severity::error, Code::missing_file, fmt::format("Cannot find file '{}'.", name), {}, at);
    impl_->advise_file(d, name, at, false);
    throw ParseError{std::move(d)};
  }
  impl_->allow_read(*found);
  return *found;
}

const std::string& Parser::find_font(const std::string& name) {
  const auto known = impl_->fonts.find(name);
  return known != impl_->fonts.end() ? known->second
                                     : impl_->fonts.emplace(name, find_file(name, ".ttf .TTF").string()).first->second;
}

}  // namespace verisim::parser
