#pragma once

#include <cstdint>

namespace guidelight {

/// Memory that this process holds at the moment; 0 where that cannot be found out.
uint64_t resident_bytes();

}  // namespace guidelight
