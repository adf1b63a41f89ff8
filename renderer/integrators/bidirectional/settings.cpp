#include "renderer/integrators/bidirectional/settings.h"

namespace guidelight {
namespace {

constexpr const char* kNoMerging = "Vertices are not merged.";

}  // namespace

BidirectionalSettings::BidirectionalSettings(BidirectionalKind which) : kind(which) {
  switch (which) {
    case BidirectionalKind::LightTracing:
      emission = next_event = connections = merging = false;
      break;
    case BidirectionalKind::Bdpt:
      merging = false;
      break;
    case BidirectionalKind::ProbabilisticPpm:
      alpha = 2.0f / 3;
      [[fallthrough]];
    case BidirectionalKind::Bpm:
      emission = next_event = light_tracing = connections = false;
      merge_direct = true;
      break;
    case BidirectionalKind::Bdpm:
      next_event = connections = false;
      merge_direct = true;
      scene_radius = 5;
      break;
    case BidirectionalKind::Vcm:
      break;
  }
}

bool BidirectionalSettings::merges() const {
  return merging && kind >= BidirectionalKind::ProbabilisticPpm;
}

bool BidirectionalSettings::connects_to_random_vertices() const {
  return connections && connect_to == 1;
}

bool BidirectionalSettings::ends_at_first_finite_vertex() const {
  const bool only_traces_light = !emission && !next_event && !connections && !merges();
  return kind == BidirectionalKind::ProbabilisticPpm || only_traces_light;
}

std::vector<Parameter> BidirectionalSettings::parameters() {
  const bool combines = kind == BidirectionalKind::Bdpt || kind == BidirectionalKind::Vcm;
  const bool is_vcm = kind == BidirectionalKind::Vcm;
  const bool is_bdpm = kind == BidirectionalKind::Bdpm;
  const std::string no_connections = connections ? "" : "Vertices are not connected.";
  std::vector<Parameter> list = {
      {"max_length", "Longest path", "Longest path in segments, -1 has no limit.", "segments",
       &max_length, -1, 1024},
      {"min_length", "Shortest path",
       "Shortest path in segments: 1 shows emitters, 2 begins with direct light.", "segments",
       &min_length, 1, 1024},
      {"light_paths", "Light paths", "Light paths per pixel and pass.", "per pixel", &light_paths,
       0.01, 100, true},
      guide_parameter(),
  };
  const auto add = [&](bool shown, const Parameter& parameter) {
    if (shown) list.push_back(parameter);
  };
  add(combines || is_bdpm, {"emission", "Find emitters",
                            "Technique s = 0: camera paths that hit a light.", "", &emission});
  add(combines,
      {"next_event", "Connect to lights",
       "Technique s = 1: camera vertices connected to a point on a light.", "", &next_event});
  add(combines || is_bdpm,
      {"light_tracing", "Connect to lens",
       "Technique t = 1: light vertices connected to the camera.", "", &light_tracing});
  add(combines, {"connections", "Connect vertices",
                 "Techniques with s, t >= 2: light vertices connected to camera vertices.", "",
                 &connections});
  add(combines,
      {"connect_to", "Connected with",
       "Every vertex of the pixel's own light path, or random vertices of all light paths.", "",
       Parameter::Choice{&connect_to, {"own_path", "random_vertices"}}, 0, 0, false,
       no_connections});
  add(combines, {"random_vertices", "Random vertices",
                 "Vertices per camera vertex, when they are chosen at random.", "",
                 &random_vertices, 1, 64, false,
                 !connections      ? no_connections
                 : connect_to == 0 ? "Vertices are connected with the pixel's own path."
                                   : ""});
  add(is_vcm, {"merging", "Merge vertices", "Merge camera vertices with photons.", "", &merging});
  const bool can_merge = kind >= BidirectionalKind::ProbabilisticPpm;
  for (Parameter parameter : radius_parameters()) {
    if (!merging) parameter.unused = kNoMerging;
    add(can_merge, parameter);
  }
  add(is_bdpm, {"neighbors", "Photons",
                "Photons of one estimate; the radius above limits how far they are looked for.",
                "per estimate", &neighbors, 1, 10000, true});
  add(is_bdpm, {"kernel", "Kernel", "How photons count within an estimate.", "",
                Parameter::Choice{&kernel, {"constant", "cone", "epanechnikov"}}});
  add(can_merge && !is_bdpm,
      {"alpha", "Radius reduction", "The radius of pass i is r*i^((alpha-1)/2); 1 keeps it.", "",
       &alpha, 0.01, 1, false, merging ? "" : kNoMerging});
  add(is_vcm,
      {"merge_direct", "Merge direct light",
       "Merge also direct light and directly visible caustics, which connections do better.", "",
       &merge_direct, 0, 0, false, merging ? "" : kNoMerging});
  add(can_merge && !is_bdpm,
      {"lean", "Save memory", "Keep photons only, and merge with those of the pass before.", "",
       &lean});
  return list;
}

std::unique_ptr<IntegratorSettings> BidirectionalSettings::clone() const {
  return std::make_unique<BidirectionalSettings>(*this);
}

}  // namespace guidelight
