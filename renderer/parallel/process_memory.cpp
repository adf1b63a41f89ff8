#include "renderer/parallel/process_memory.h"

#include <unistd.h>

#include <fstream>

namespace guidelight {

uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");  // the second number: pages in memory
  uint64_t all = 0, resident = 0;
  if (!(file >> all >> resident)) return 0;
  return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace guidelight
