#include "cli/lsp/protocol.h"

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <stdexcept>

#include "compare/json_text.h"

namespace verisim::cli::lsp {
namespace {

constexpr std::size_t kLargestMessage = std::size_t{1} << 28;

// The value of Content-Length, whose name is written in any case.
std::optional<std::size_t> content_length(std::string_view header) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find("\r\n"), header.size());
    std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 2, header.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    std::string name(line.substr(0, colon));
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (name != "content-length") continue;
    line.remove_prefix(colon + 1);
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    std::size_t length = 0;
    const auto [last, error] = std::from_chars(line.data(), line.data() + line.size(), length);
    if (error == std::errc() && last != line.data() && length <= kLargestMessage) return length;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Json> Connection::read() {
  std::size_t wanted = 0;  // bytes with the header; 0: not known yet
  std::size_t body = 0;
  for (;;) {
    if (!wanted) {
      if (const std::size_t end = buffer_.find("\r\n\r\n"); end != std::string::npos) {
        body = end + 4;
        const auto length = content_length(std::string_view(buffer_).substr(0, end + 2));
        if (!length) throw std::runtime_error("a message without a Content-Length that can be read");
        wanted = body + *length;
      } else if (buffer_.size() > 65536) {
        throw std::runtime_error("what comes in is no message of the Language Server Protocol");
      }
    }
    if (wanted && buffer_.size() >= wanted) break;
    char bytes[65536];
    const ssize_t got = ::read(in_, bytes, sizeof bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    buffer_.append(bytes, static_cast<std::size_t>(got));
  }
  Json message = compare::parse_json(std::string_view(buffer_).substr(body, wanted - body));
  buffer_.erase(0, wanted);
  return message;
}

void Connection::send(const Json& message) {
  const std::string body = compare::json_text(message);
  const std::string text = "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  const std::lock_guard lock(mutex_);
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t n = ::write(out_, text.data() + sent, text.size() - sent);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;  // the client is gone; the next read ends the server
    sent += static_cast<std::size_t>(n);
  }
}

void Connection::notify(const std::string& method, Json params) {
  send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Connection::request(const std::string& id, const std::string& method, Json params) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}});
}

void Connection::answer(const Json& id, Json result) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Connection::fail(const Json& id, int code, const std::string& message) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

}  // namespace verisim::cli::lsp
