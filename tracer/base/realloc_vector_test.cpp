#include "tracer/base/realloc_vector.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace verisim {
namespace {

// From the heap to pages of their own and back, while others grow beside it.
TEST(ReallocVector, KeepsItsValuesHoweverItGrows) {
  ReallocVector<std::uint32_t> list, beside;
  constexpr std::uint32_t kCount = 1'000'000;
  for (std::uint32_t i = 0; i < kCount; ++i) list.push_back(i * 7), beside.push_back(i);
  list.push_back(list[0]);
  list.append(std::vector<std::uint32_t>{1, 2, 3});
  list.reserve(3 * kCount);
  list.set_capacity(list.size());
  ASSERT_EQ(list.size(), kCount + 4);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_TRUE(list[i] == i * 7 && beside[i] == i) << i;
  EXPECT_EQ(list[kCount], 0u);
  EXPECT_EQ(list[kCount + 3], 3u);
  ReallocVector<std::uint32_t> moved = std::move(list);
  EXPECT_EQ(moved[kCount + 2], 2u);
  ReallocVector<std::uint32_t> few;
  few.reserve(kCount);
  for (std::uint32_t i = 0; i < 10; ++i) few.push_back(i);
  few.set_capacity(10);
  for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(few[i], i);
}

}  // namespace
}  // namespace verisim
