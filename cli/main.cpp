#include <cstdlib>  // tells whether this is glibc
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/program.h"

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // Parsing and building free large blocks that rendering takes again: keep them, instead of giving them back and having new pages cleared.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 16 << 20);
#endif
  return verisim::cli::run({argv, argv + argc});
}
