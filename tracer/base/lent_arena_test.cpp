#include "tracer/base/lent_arena.h"

#include <gtest/gtest.h>

#include <atomic>

#include "tracer/base/parallel.h"
#include "tracer/base/resident_memory.h"
#include "tracer/base/sanitizers.h"

namespace verisim {
namespace {

void use_one(std::atomic<int>& sum) {
  LentArena arena(2);
  arena.execute([&] { parallel_for(16, 1, [&](std::size_t i) { sum += static_cast<int>(i); }); });
}

TEST(LentArena, RunsLoopsWithItsThreads) {
  LentArena outer(3);
  outer.execute([] { EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 3); });
  LentArena inner(2);  // at the same time
  inner.execute([] { EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 2); });
}

TEST(LentArena, ThousandsTakeNoMemory) {
#ifdef VERISIM_SANITIZED
  GTEST_SKIP() << "sanitizers keep memory of their own";
#endif
  std::atomic<int> sum{0};
  for (int i = 0; i < 100; ++i) use_one(sum);
  const std::size_t before = resident_memory();
  for (int i = 0; i < 2000; ++i) use_one(sum);
  EXPECT_LT(resident_memory(), before + (std::size_t{2} << 20));  // 14 MB with arenas that end
  EXPECT_EQ(sum, 2100 * 120);
}

}  // namespace
}  // namespace verisim
