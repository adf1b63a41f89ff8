#include "renderer/io/mitsuba/importer.h"

namespace guidelight::mitsuba {

/// Homogeneous, absorbing only. sigma_a is given, or follows from sigma_t and the albedo.
int Importer::medium(const Node& node) {
  if (const auto known = media_.find(&node); known != media_.end()) return known->second;
  Properties properties(node, warnings_);
  if (node.type != "homogeneous") {
    warnings_.add(node.source, plugin_name(node),
                  fmt::format("{} is not supported; vacuum stands in.", plugin_name(node)));
    return media_[&node] = kNone;
  }
  // A grid or constant volume stands where a number could; only constant ones can be read.
  const auto coefficient = [&](Properties::Names names, Color fallback) {
    const Node* property = properties.find(names);
    if (!property) return fallback;
    if (property->tag != "volume") {
      return color_input(*property, SpectrumUse::Coefficient).value;
    }
    Properties volume(*property, warnings_);
    return constant_color(volume, {"value"}, fallback, SpectrumUse::Coefficient);
  };
  MediumDescription medium{node.id, node.source.line, Color(0)};
  const Color sigma_s = coefficient({"sigma_s"}, Color(0));
  const Color sigma_t = coefficient({"sigma_t"}, Color(1));
  const Color albedo = coefficient({"albedo"}, Color(0.75f));
  const float scale = properties.number({"scale"}, 1) * properties.number({"density"}, 1);
  bool scatters = !is_black(sigma_s);
  if (properties.find({"sigma_a"}) || scatters) {
    medium.sigma_a = scale * coefficient({"sigma_a"}, Color(0));
  } else if (properties.find({"sigma_t"}) || properties.find({"albedo"})) {
    medium.sigma_a = scale * glm::max(sigma_t * (Color(1) - albedo), Color(0));
    scatters = !is_black(albedo);
  } else {
    warnings_.add(node.source, "medium without coefficients",
                  "the medium gives no coefficients (named materials are not supported); it does "
                  "not absorb.");
  }
  if (scatters) {
    warnings_.add(node.source, "medium scatters",
                  "scattering inside media is not supported; the medium only absorbs.");
  }
  properties.ignore({"material", "g"});
  properties.objects("phase");
  properties.warn_about_the_rest();
  scene_.media.push_back(medium);
  return media_[&node] = static_cast<int>(scene_.media.size()) - 1;
}

}  // namespace guidelight::mitsuba
