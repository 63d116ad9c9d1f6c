// #version and what follows from it (spec 01 section 20).
#include <cmath>

#include "parser/language/impl.h"

namespace verisim::parser {

void Parser::Impl::version_directive() {
  const bool first = frames.empty() && index(position) == 1;
  if (!version_seen && !first) version_is_first = false;
  const Token& token = peek();
  if (token.kind == TokenKind::identifier && names[token.id()].text == "unofficial") skip_token();
  double value;
  {
    const Live operators(*this, true);
    value = scalar();
  }
  const double stored = std::floor(value * 100 + 0.5);
  if (!(stored <= 370)) error(Code::version_limits, "This scene needs a later version of POV-Ray than 3.7.");
  if (peek_blocked().punctuation == ';')
    skip_token();
  else if (stored >= 310)
    message_at(here(), Severity::possible_error, Code::missing_semicolon, "A semicolon ';' is missing behind #version.",
               {}, semicolon_behind(here()));
  version_seen = true;
  set_version(static_cast<int>(std::max(stored, -1e6)));
}

void Parser::Impl::set_version(int value) {
  language_version = value;
  if (!noise_generator_given) scene.settings.noise_generator = *noise_generator = value < 350 ? 1 : 2;
}

// ---- The public face ----

int Parser::version() const { return impl_->language_version; }
int Parser::effective_version() const {
  return impl_->version_seen || impl_->options.version ? impl_->language_version : 362;
}
void Parser::set_charset(Charset charset) { impl_->charset = charset; }
Parser::Charset Parser::charset() const { return impl_->charset; }

void Parser::set_noise_generator(int generator) {
  impl_->noise_generator_given = true;
  impl_->scene.settings.noise_generator = *impl_->noise_generator = generator;
}

}  // namespace verisim::parser
