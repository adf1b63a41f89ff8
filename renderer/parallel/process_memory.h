#pragma once

#include <cstdint>

namespace guidelight {

/// Memory that this process holds at the moment [bytes]; 0 where that cannot be found out.
uint64_t resident_bytes();

// For programs that run for hours and whose pictures come and go, in all sizes and from many
// threads. Both do nothing where the allocator knows nothing of the kind.

/// From now on large blocks are the system's as soon as they are freed. glibc would soon keep
/// blocks of up to 32 MB in its arenas, which fall to pieces and grow.
void return_large_blocks_to_the_system();
/// Gives back the pages that lie free between the small blocks in use. Takes milliseconds, and may
/// be called from any thread.
void return_free_pages_to_the_system();

}  // namespace guidelight
