#include "compare/oracle/content_hash.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <new>
#include <vector>

namespace verisim::compare {

struct ContentHash::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  ~State() { EVP_MD_CTX_free(context); }
  void raw(const void* data, std::size_t size) { EVP_DigestUpdate(context, data, size); }
  void number(std::uint64_t n) {
    std::array<unsigned char, 8> bytes;
    for (unsigned char& b : bytes) b = static_cast<unsigned char>(n), n >>= 8;
    raw(bytes.data(), bytes.size());
  }
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) {
  // Without it, for want of memory at the library's first use, it would look for its locks at address 0.
  if (!OSSL_LIB_CTX_get0_global_default()) throw std::bad_alloc();
  if (!state_->context || EVP_DigestInit_ex(state_->context, EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
}
ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view text) {
  state_->number(text.size());
  state_->raw(text.data(), text.size());
}

void ContentHash::add_file(const std::filesystem::path& path) {
  std::error_code failed;
  std::ifstream in;
  if (std::filesystem::is_regular_file(path, failed)) in.open(path, std::ios::binary);
  if (!in.is_open()) return state_->number(~std::uint64_t{0});
  std::vector<char> buffer(1 << 16);
  std::uint64_t size = 0;
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0) {
    state_->raw(buffer.data(), static_cast<std::size_t>(in.gcount()));
    size += static_cast<std::uint64_t>(in.gcount());
  }
  state_->number(size);
}

std::string ContentHash::hex() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  EVP_DigestFinal_ex(state_->context, digest.data(), &size);
  std::string out;
  for (unsigned int i = 0; i < size; ++i) {
    constexpr char kDigits[] = "0123456789abcdef";
    out += kDigits[digest[i] >> 4];
    out += kDigits[digest[i] & 15];
  }
  return out;
}

}  // namespace verisim::compare
