// From a file to a scene or to diagnostics: every error, whatever its kind, becomes one of the latter.
#include "parser/parse.h"

#include <locale.h>

#include <new>
#include <stdexcept>

#include "parser/language/parser.h"

namespace verisim::parser {
namespace {

// Numbers of SDL have a point, whatever language the program around us speaks: as long as this lives, for this thread.
class PointInNumbers {
 public:
  PointInNumbers() {
    locale_ = newlocale(LC_NUMERIC_MASK, "C", duplocale(uselocale(nullptr)));
    if (locale_) before_ = uselocale(locale_);
  }
  ~PointInNumbers() {
    if (!locale_) return;
    uselocale(before_);
    freelocale(locale_);
  }
  PointInNumbers(const PointInNumbers&) = delete;
  PointInNumbers& operator=(const PointInNumbers&) = delete;

 private:
  locale_t locale_ = nullptr, before_ = nullptr;
};

template <class Run>
ParseResult guarded(const std::string& name, const ParseOptions& options, Run&& run) {
  const PointInNumbers c_locale;
  ParseResult result;
  const auto fail = [&](Diagnostic diagnostic) {
    result.whole = false;
    if (options.message) options.message(diagnostic);
    result.errors.push_back(std::move(diagnostic));
  };
  const auto plain = [&](Code code, const std::string& text) {
    Diagnostic d;
    d.code = code;
    d.file = name;
    d.message = text;
    fail(std::move(d));
  };
  try {
    Parser parser(options, result);
    run(parser);
    if (result.errors.empty()) result.scene = std::move(parser.scene());
  } catch (ParseError& e) {
    fail(std::move(e.diagnostic));
  } catch (const std::bad_alloc&) {
    plain(Code::size_limit, "The scene needs more memory than there is.");
  } catch (const std::exception& e) {
    plain(Code::file_failed, e.what());
  }
  return result;
}

}  // namespace

ParseResult parse_file(const std::filesystem::path& path, const ParseOptions& options) {
  return guarded(path.string(), options, [&](Parser& parser) { parser.run(path); });
}

ParseResult parse_text(const std::string& text, const std::string& name, const ParseOptions& options) {
  return guarded(name, options, [&](Parser& parser) { parser.run_text(text, name); });
}

}  // namespace verisim::parser
