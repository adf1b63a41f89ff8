#pragma once

namespace guidelight {

/// Asks for the cache line at an address that will be read soon. The empty statement is for GCC 12,
/// which takes a function that does nothing else for one without effect and drops the calls of it.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

}  // namespace guidelight
