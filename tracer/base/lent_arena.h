// Threads for a while: a oneTBB arena of so many, kept for whoever asks next.
//
// oneTBB 2021.8 loses 7 kB with each arena that was used and is destroyed: a program that draws pictures for days, as
// the live view or Python do, would grow by that with every picture. So there are as many as were ever wanted at once.
#pragma once

#include <tbb/task_arena.h>

#include <utility>

namespace verisim {

class LentArena {
 public:
  explicit LentArena(int threads);  // tbb::task_arena::automatic: as many as there are processors
  ~LentArena();
  LentArena(const LentArena&) = delete;
  LentArena& operator=(const LentArena&) = delete;

  template <class Body>
  void execute(Body&& body) {
    arena_->execute(std::forward<Body>(body));
  }

 private:
  const int threads_;
  tbb::task_arena* const arena_;
};

}  // namespace verisim
