#include "renderer/parallel/process_memory.h"

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace guidelight {

uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");  // the second number: pages in memory
  uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

void return_large_blocks_to_the_system() {
#ifdef __GLIBC__
  constexpr int kLarge = 1 << 20;  // [bytes]
  mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

void return_free_pages_to_the_system() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace guidelight
