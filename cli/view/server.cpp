#include "cli/view/server.h"

#include <httplib.h>
#include <sys/random.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

constexpr std::size_t kThreads = 24;        // each page that is open waits in one
constexpr std::size_t kMaxBytes = 1 << 16;  // of a request

std::string random_token() {
  unsigned char bytes[16];
  if (getrandom(bytes, sizeof bytes, 0) != sizeof bytes) throw std::runtime_error("no random numbers for a token");
  std::string token;
  for (const unsigned char b : bytes) token += fmt::format("{:02x}", b);
  return token;
}

}  // namespace

struct Server::Impl {
  httplib::Server http;
  std::string token, host;
  std::map<std::string, std::function<PageReply(const PageRequest&)>> answers;
  std::thread thread;

  // A page elsewhere that guessed the port, also by a name of its own that leads to this machine.
  bool foreign(const httplib::Request& request) const {
    if (request.get_header_value("Host") != host) return true;
    return request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host;
  }

  void answer(const httplib::Request& request, httplib::Response& response) const {
    response.set_header("Cache-Control", "no-store");
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    response.set_header("Content-Security-Policy",
                        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self' "
                        "data: blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
    const std::string start = "/" + token + "/";
    if (foreign(request) || !request.path.starts_with(start)) {
      response.status = 403;
      return response.set_content("Not yours: open the address that the program printed.\n", "text/plain");
    }
    const auto found = answers.find(request.path.substr(start.size()));
    if (found == answers.end()) {
      response.status = 404;
      return response.set_content("There is nothing of this name.\n", "text/plain");
    }
    PageRequest asked;
    for (const auto& [name, value] : request.params) asked.parameters[name] = value;
    asked.body = request.body;
    PageReply reply;
    try {
      reply = found->second(asked);
    } catch (const std::exception& error) {
      reply = {"text/plain", error.what(), 400};
    }
    response.status = reply.status;
    response.set_content(std::move(reply.body), reply.type);
  }
};

Server::Server() : impl_(std::make_unique<Impl>()) {
  const auto answer = [this](const httplib::Request& q, httplib::Response& r) { impl_->answer(q, r); };
  impl_->http.Get(".*", answer);
  impl_->http.Post(".*", answer);
  impl_->http.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  impl_->http.set_payload_max_length(kMaxBytes);
  impl_->http.set_tcp_nodelay(true);
}
Server::~Server() { stop(); }

void Server::on(const std::string& name, std::function<PageReply(const PageRequest&)> answer) {
  impl_->answers[name] = std::move(answer);
}

std::string Server::listen(int port, const std::string& token) {
  impl_->token = token.empty() ? random_token() : token;
  const bool bound =
      port == 0 ? (port = impl_->http.bind_to_any_port("127.0.0.1")) > 0 : impl_->http.bind_to_port("127.0.0.1", port);
  if (!bound) throw std::runtime_error(fmt::format("cannot listen on 127.0.0.1:{}; is the port taken?", port));
  impl_->host = fmt::format("127.0.0.1:{}", port);
  return fmt::format("http://{}/{}/", impl_->host, impl_->token);
}

void Server::start() {
  impl_->thread = std::thread([this] { impl_->http.listen_after_bind(); });
  // stop() is heard by a server that runs, and by no other.
  while (!impl_->http.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void Server::stop() {
  impl_->http.stop();
  if (impl_->thread.joinable()) impl_->thread.join();
}

}  // namespace verisim::cli
