// HTTP on the loopback interface for one page of our own: nobody without the token in the address is answered, nor a
// page of another origin.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace verisim::cli {

struct PageRequest {
  std::map<std::string, std::string> parameters;
  std::string body;
};
struct PageReply {
  std::string type = "application/octet-stream", body;
  int status = 200;
};

class Server {
 public:
  Server();
  ~Server();
  // What is answered to GET and POST below the token; "" is the page itself. Before start().
  void on(const std::string& name, std::function<PageReply(const PageRequest&)> answer);
  // Listens on 127.0.0.1, port 0: any free one; an empty token: a random one. Returns the address to open. Throws
  // std::runtime_error.
  std::string listen(int port, const std::string& token = {});
  // Answers, in threads of its own; needs no more rights than to accept.
  void start();
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace verisim::cli
