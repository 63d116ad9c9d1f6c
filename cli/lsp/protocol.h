// The wire of the Language Server Protocol: JSON-RPC messages with a header, over two file descriptors.
#pragma once

#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace verisim::cli::lsp {

using Json = nlohmann::json;

class Connection {
 public:
  Connection(int in, int out) : in_(in), out_(out) {}

  // The next message; nothing: the other side has closed. Bad JSON gives a discarded value. Throws std::runtime_error
  // on a header that cannot be understood.
  std::optional<Json> read();
  // May be called by any thread.
  void notify(const std::string& method, Json params);
  void request(const std::string& id, const std::string& method, Json params);
  void answer(const Json& id, Json result);
  void fail(const Json& id, int code, const std::string& message);

 private:
  void send(const Json& message);

  int in_, out_;
  std::string buffer_;
  std::mutex mutex_;
};

inline constexpr int kParseError = -32700, kInvalidRequest = -32600, kMethodNotFound = -32601, kInvalidParams = -32602,
                     kInternalError = -32603, kNotInitialized = -32002, kRequestFailed = -32803;

// A request that cannot be served; what() is shown to the user.
struct RequestError : std::runtime_error {
  RequestError(int c, const std::string& message) : std::runtime_error(message), code(c) {}
  int code;
};

}  // namespace verisim::cli::lsp
