#include "app/guide_arguments.h"

#include <filesystem>

#include "app/message.h"
#include "renderer/io/guide_file.h"
#include "renderer/transport/guide_check.h"

namespace guidelight {

void GuideArguments::add_to(CLI::App& command) {
  command.add_option("--guides", path,
                     "Guide paths to follow; without it NAME.guides.json beside the scene");
}

std::string GuideArguments::file_for(const Scene& scene) const {
  if (!path.empty()) return path;
  const std::string beside = guide_file_beside(scene.description().path);
  return std::filesystem::exists(beside) ? beside : "";
}

GuideList GuideArguments::read(const Scene& scene) const {
  const std::string file = file_for(scene);
  if (file.empty()) return nullptr;
  const auto guides = std::make_shared<const std::vector<GuidePath>>(read_guides(file));
  for (const GuidePath& guide : *guides) {
    if (!guide.enabled) continue;
    for (const GuideFault& fault : check_guide(scene, guide)) {
      say("guidelight: warning: {}: guide '{}' is left out: vertex {}: {}\n", file, guide.name,
          fault.vertex, fault.message);
    }
  }
  return guides;
}

}  // namespace guidelight
