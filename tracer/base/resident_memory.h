// How much memory the process has in use now: its resident pages, of every thread and library.
#pragma once

#include <atomic>
#include <cstddef>

namespace verisim {

// In bytes; 0 where the system does not tell (/proc). The file that tells it is opened once and stays open: asking
// costs a microsecond, and goes on when nothing may be opened any more.
std::size_t resident_memory();

// A limit that large blocks are held to before they are taken (cli/large_blocks.cpp); 0: none.
inline std::atomic<std::size_t> memory_limit{0};

}  // namespace verisim
