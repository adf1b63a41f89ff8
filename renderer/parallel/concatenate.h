#pragma once

#include <algorithm>
#include <vector>

#include "renderer/parallel/parallel.h"

namespace guidelight {

/// Replaces `all` by what pieces of parallel work have left, one batch after the other; its memory
/// is kept. Throws Stopped.
template <class T>
void concatenate(const std::vector<std::vector<T>>& batches, std::vector<T>& all,
                 Parallel& parallel) {
  std::vector<size_t> begin(batches.size() + 1);
  for (size_t i = 0; i < batches.size(); ++i) begin[i + 1] = begin[i] + batches[i].size();
  all.resize(begin.back());
  parallel.for_each(batches.size(), [&](size_t i) {
    std::copy(batches[i].begin(), batches[i].end(), all.begin() + begin[i]);
  });
}

}  // namespace guidelight
