#include "renderer/session/checkpoints.h"

#include "renderer/error.h"
#include "renderer/session/picture_export.h"

namespace guidelight {

namespace {

std::string value_of(const Metadata& data, const std::string& key) {
  const auto found = data.find(key);
  return found == data.end() ? "nothing" : found->second;
}

/// Refuses the first entry that is not the same.
void require_equal(const Metadata& saved, const Metadata& ours, const std::string& path) {
  Metadata all = saved;
  all.insert(ours.begin(), ours.end());
  for (const auto& [key, ignored] : all) {
    const std::string theirs = value_of(saved, key), wanted = value_of(ours, key);
    if (theirs == wanted) continue;
    if (key == "scene_hash") {
      throw Error("{}: the scene {} has changed since the checkpoint was saved: render it again",
                  path, value_of(ours, "scene"));
    }
    throw Error(
        "{}: the checkpoint is of another render, with {} {} and not {}: resume with what it was "
        "saved with, or choose another checkpoint",
        path, key.starts_with("set.") ? key.substr(4) : key, theirs, wanted);
  }
}

/// As describe_render calls them.
Metadata with_details(Metadata identity, uint64_t seed, int width, int height) {
  identity["seed"] = fmt::format("{}", seed);
  identity["size"] = fmt::format("{}x{}", width, height);
  return identity;
}

}  // namespace

Metadata identity_of(const RenderJob& job) {
  Metadata identity = describe_render(job, Snapshot());
  for (const char* changing : {"passes", "seconds", "seed", "size", "guides"}) {
    identity.erase(changing);
  }
  return identity;
}

SaveProgress save_to(const std::string& path, const RenderJob& job) {
  return [path, seed = job.seed, identity = identity_of(job)](const RenderProgress& progress) {
    write_checkpoint(path, {progress.film, progress.next_pass, progress.seconds, seed, identity});
  };
}

RenderProgress resume_from(const Checkpoint& checkpoint, const RenderJob& job,
                           const std::string& path) {
  const Camera& camera = job.scene->camera();
  require_equal(describe_checkpoint(checkpoint),
                with_details(identity_of(job), job.seed, camera.width(), camera.height()), path);
  return {checkpoint.film, checkpoint.next_pass, checkpoint.seconds};
}

Metadata describe_checkpoint(const Checkpoint& checkpoint) {
  return with_details(checkpoint.identity, checkpoint.seed, checkpoint.film->width(),
                      checkpoint.film->height());
}

}  // namespace guidelight
