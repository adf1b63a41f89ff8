#include "renderer/integrators/mutation_parameters.h"

namespace guidelight {

void add_mutation_parameters(MutationWeights& weights, std::vector<Parameter>& list) {
  const auto add = [&](const char* key, const char* label, const char* help, float& value) {
    list.push_back({key, label, help, "", &value, 0, 1});
  };
  add("bidirectional", "Bidirectional (BD)",
      "How often a part of the path is replaced by an independent one.", weights.bidirectional);
  add("guided", "Guides (UP)", "How often a path follows a guide path, where there is one.",
      weights.guided);
  add("lens", "Lens (LP)", "How often the path moves a little in the picture.", weights.lens);
  add("caustic", "Caustic (CP)",
      "How often light turns a little where it leaves for what the eye sees.", weights.caustic);
  add("multi_chain", "Multi-chain",
      "How often a path through several specular surfaces moves a little.", weights.multi_chain);
  add("lens_subpath", "Lens subpath (LS)",
      "How often the path is seen from an independent place in the picture.", weights.lens_subpath);
  add("photon_map", "Photon map (PM)",
      "How often the path turns where the eye's first diffuse vertex sends it back to the light.",
      weights.photon_map);
}

}  // namespace guidelight
