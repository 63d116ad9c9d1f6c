#include "tracer/base/lent_arena.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace verisim {
namespace {

// Those that nobody has now, by their number of threads.
class Arenas {
 public:
  tbb::task_arena* take(int threads) {
    const std::lock_guard lock(mutex_);
    std::vector<std::unique_ptr<tbb::task_arena>>& idle = idle_[threads];
    if (idle.empty()) return new tbb::task_arena(threads);
    tbb::task_arena* const arena = idle.back().release();
    idle.pop_back();
    return arena;
  }
  void give_back(int threads, tbb::task_arena* arena) {
    std::unique_ptr<tbb::task_arena> idle(arena);
    const std::lock_guard lock(mutex_);
    idle_[threads].push_back(std::move(idle));
  }

 private:
  std::mutex mutex_;
  std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> idle_;
};

Arenas& arenas() {
  static auto& all = *new Arenas;  // never destroyed: oneTBB may have ended before
  return all;
}

}  // namespace

LentArena::LentArena(int threads) : threads_(threads), arena_(arenas().take(threads)) {}

LentArena::~LentArena() {
  try {
    arenas().give_back(threads_, arena_);
  } catch (...) {  // no memory to note it down: the arena is destroyed
  }
}

}  // namespace verisim
