// What is made from a description and shared by all copies of an object: found again by the description while anything
// uses it.
#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace verisim::shapes {

// The Payload that `make` makes of a source, or the one made before of the same source.
template <class Payload, class Source, class Make>
std::shared_ptr<const Payload> shared_payload(const std::shared_ptr<const Source>& source, Make&& make) {
  // An expired entry may belong to an older source that lived at the same address.
  struct Known {
    std::weak_ptr<const Source> source;
    std::weak_ptr<const Payload> payload;
  };
  static std::mutex mutex;
  static std::unordered_map<const Source*, Known> known;
  const std::lock_guard lock(mutex);
  if (const auto at = known.find(source.get()); at != known.end()) {
    if (auto payload = at->second.payload.lock(); payload && at->second.source.lock() == source) return payload;
  }
  static std::size_t many = 64;
  if (known.size() > many) {
    std::erase_if(known, [](const auto& entry) { return entry.second.payload.expired(); });
    many = std::max<std::size_t>(64, 2 * known.size());  // a scene may have thousands of them
  }
  std::shared_ptr<const Payload> payload = make();
  known[source.get()] = {source, payload};
  return payload;
}

}  // namespace verisim::shapes
