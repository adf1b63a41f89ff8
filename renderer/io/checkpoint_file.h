#pragma once

#include <memory>
#include <string>

#include "renderer/image/film.h"
#include "renderer/io/image_file.h"

namespace guidelight {

/// A render that can be gone on with: the film's sums and what they belong to.
struct Checkpoint {
  std::shared_ptr<const Film> film;
  uint32_t next_pass = 0;
  double seconds = 0;
  uint64_t seed = 0;
  /// What the film shows: scene, integrator, settings, camera … Two checkpoints with the same
  /// identity and different seeds may be merged; a render resumes only from its own.
  Metadata identity;
};

/// File format: one line of JSON (format version, size, filter, counters, identity), then the
/// film's state as little-endian doubles. Throws Error naming the path.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);
Checkpoint read_checkpoint(const std::string& path);
/// Whether a file begins like a checkpoint, of any version.
bool is_checkpoint(const std::string& path);

}  // namespace guidelight
