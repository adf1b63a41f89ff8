// The balance heuristic by recurrence against the oracle that multiplies out every density. Paths
// are made by real walks and closed in every way, so what is tested is what the integrators use.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/transport/path_weights.h"
#include "tests/renderer/test_scenes.h"
#include "tests/renderer/transport/explicit_path.h"

namespace guidelight {
namespace {

using testing::ExplicitPath;
using testing::OracleWeights;

constexpr int kLongest = 8;  // segments of a subpath
/// The oracle takes directions from positions, which in single precision says little where two lie
/// closer than this; walks end there.
constexpr float kShortestSegment = 0.03f;

/// One subpath with everything that happened on it.
struct Walk {
  struct Step {
    Subpath path;  // as the segment arrived
    PathVertex vertex;
    bool is_delta;  // how it scattered, known once the walk went on
  };
  std::vector<Step> steps;
  std::optional<Subpath> escape;
};

/// Visitor that writes a walk down.
struct Recorder {
  Walk& walk;
  void escaped(uint32_t, Subpath& path) {
    note_scattering(path);
    walk.escape = path;
  }
  bool visit(uint32_t, Subpath& path, const PathVertex& vertex, const Scattering& scattering) {
    note_scattering(path);
    if (vertex.hit.t < kShortestSegment) return false;
    walk.steps.push_back({path, vertex, !scattering.is_connectible()});
    return vertex.length < kLongest;
  }
  void end_segment() {}
  void note_scattering(const Subpath& path) {
    if (!walk.steps.empty()) walk.steps.back().is_delta = !path.is_connectible;
  }
};

/// What can be told about agreement over many closures.
struct OracleAgreement {
  size_t compared = 0;
  double largest = 0;  // difference relative to the weight
  size_t above = 0;    // 1e-4
  std::string worst;

  void compare(double weight, double expected, const std::string& what) {
    ++compared;
    const double difference = std::abs(weight - expected) / std::max(expected, 1e-4);
    if (!(difference <= 1e-4)) ++above;
    if (!(difference <= largest)) {
      largest = difference;
      worst = fmt::format("{}: weight {} oracle {}", what, weight, expected);
    }
  }
};

class Closures {
 public:
  Closures(std::shared_ptr<const Scene> scene, const TechniqueCounts& counts, float eta)
      : scene_(std::move(scene)), counts_(counts), weights_(counts), eta_(eta) {}

  /// Makes one pair of subpaths and compares the weights of all ways to close it.
  void try_path(uint64_t number) {
    Rng rng(1, 2, number);
    Walk camera, light;
    EmissionSample emission;
    Vec3 lens(0);
    const Vec2 size(scene_->camera().width(), scene_->camera().height());
    run(TransportMode::Radiance, start_camera_path(*scene_, rng.next_vec2() * size, rng), camera,
        &lens);
    const auto start = start_light_path(*scene_, Rng(3, 4, number), counts_.emission, emission);
    if (start) run(TransportMode::Importance, *start, light, nullptr);

    Rng extra(5, 6, number);
    for (size_t t = 0; t < camera.steps.size(); ++t) close_at(camera, t, lens, extra);
    if (camera.escape) close_escape(camera, lens);
    if (!start) return;
    ExplicitPath base;
    base.light = start->light;
    base.light_point = emission.point;
    base.light_position = base.light->is_delta() || base.light->is_infinite()
                              ? emission.ray.origin
                              : emission.point.position;
    base.towards = -emission.ray.direction;
    for (size_t s = 0; s < light.steps.size(); ++s) {
      if (!light.steps[s].vertex.is_connectible()) continue;
      close_at_lens(base, light, s, extra);
      for (size_t t = 0; t < camera.steps.size(); ++t) {
        connect(base, light, s, camera, t, lens);
        merge(base, light, s, camera, t, lens);
      }
    }
  }

  const OracleAgreement& agreement() const { return agreement_; }

 private:
  void run(TransportMode mode, Subpath start, Walk& walk, Vec3* origin) {
    RandomWalk random_walk(*scene_, mode, &weights_);
    Recorder recorder{walk};
    if (origin) *origin = start.origin;
    random_walk.run({&start, 1}, recorder);
  }

  /// Appends x of a light walk up to step `last` as seen from the light.
  static void append_light(ExplicitPath& path, const Walk& walk, size_t last) {
    for (size_t i = 0; i <= last; ++i) path.vertices.push_back(vertex_of(walk, i, i == last));
  }
  /// Appends those of a camera walk from step `first` to the lens.
  static void append_camera(ExplicitPath& path, const Walk& walk, size_t first, Vec3 lens) {
    for (size_t i = first + 1; i-- > 0;) path.vertices.push_back(vertex_of(walk, i, i == first));
    path.lens = lens;
  }
  /// Where a subpath ends it is connected, so it scatters by a finite lobe there.
  static ExplicitPath::Vertex vertex_of(const Walk& walk, size_t i, bool is_end) {
    return {walk.steps[i].vertex.point, !is_end && walk.steps[i].is_delta};
  }

  OracleWeights oracle(const ExplicitPath& path) const {
    return testing::oracle_weights(*scene_, path, counts_, eta_);
  }

  void close_at(const Walk& camera, size_t t, Vec3 lens, Rng& rng) {
    const auto& [path, vertex, unused] = camera.steps[t];
    if (vertex.point.light && t > 0 &&
        !is_black(vertex.point.light->radiance(vertex.point, vertex.wo))) {
      ExplicitPath full;
      full.light = vertex.point.light;
      full.light_point = vertex.point;
      full.light_position = vertex.point.position;
      append_scattered(full, camera, t - 1, lens);
      const EmissionEnd end = end_on_light(*scene_, path, vertex, is_direct_caustic(camera, t));
      agreement_.compare(path_weight(weights_, end, eta_), oracle(full).connection[0], "hit");
    }
    if (!vertex.is_connectible()) return;
    const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
    const float u_light = rng.next_float();
    const Vec2 u_point = rng.next_vec2();
    const auto direct = connect_to_light(*scene_, vertex, scattering, u_light, u_point);
    if (!direct) return;
    const Light& light = *scene_->choose_light(u_light)->light;
    const auto sample = light.sample_direct(vertex.point.position, u_point);
    ExplicitPath full;
    full.light = &light;
    full.light_point = sample->point;
    full.light_position = sample->position;
    full.towards = sample->wi;
    append_camera(full, camera, t, lens);
    agreement_.compare(path_weight(weights_, vertex, *direct, eta_), oracle(full).connection[1],
                       fmt::format("next event t={}", t + 2));
  }

  /// As append_camera, but the end has scattered as the walk did.
  static void append_scattered(ExplicitPath& path, const Walk& walk, size_t first, Vec3 lens) {
    for (size_t i = first + 1; i-- > 0;) path.vertices.push_back(vertex_of(walk, i, false));
    path.lens = lens;
  }

  static bool is_direct_caustic(const Walk& camera, size_t end) {
    size_t finite = 0;
    for (size_t i = 0; i < end; ++i) finite += !camera.steps[i].is_delta;
    return finite == 1 && !camera.steps[0].is_delta;
  }

  void close_escape(const Walk& camera, Vec3 lens) {
    if (camera.steps.empty()) return;
    for (const Light* light : scene_->infinite_lights()) {
      if (light->is_delta() || is_black(light->radiance_from(camera.escape->ray.direction)))
        continue;
      ExplicitPath full;
      full.light = light;
      full.towards = camera.escape->ray.direction;
      append_scattered(full, camera, camera.steps.size() - 1, lens);
      const EmissionEnd end = end_at_infinity(*scene_, *camera.escape, *light,
                                              is_direct_caustic(camera, camera.steps.size()));
      agreement_.compare(path_weight(weights_, end, eta_), oracle(full).connection[0], "escape");
    }
  }

  void close_at_lens(const ExplicitPath& base, const Walk& light, size_t s, Rng& rng) {
    const PathVertex& vertex = light.steps[s].vertex;
    const Scattering scattering(vertex.point, vertex.wo, TransportMode::Importance);
    const Vec2 u_lens = rng.next_vec2();
    const auto lens = connect_to_lens(scene_->camera(), vertex, scattering, u_lens);
    if (!lens) return;
    ExplicitPath full = base;
    append_light(full, light, s);
    full.lens = scene_->camera().connect(vertex.point.position, u_lens)->lens_position;
    agreement_.compare(path_weight(weights_, vertex, *lens, eta_),
                       oracle(full).connection[full.length()], fmt::format("lens s={}", s + 2));
  }

  void connect(const ExplicitPath& base, const Walk& light, size_t s, const Walk& camera, size_t t,
               Vec3 lens) {
    const PathVertex& from_light = light.steps[s].vertex;
    const PathVertex& from_camera = camera.steps[t].vertex;
    if (!from_camera.is_connectible()) return;
    const auto connection =
        connect_vertices(from_light, {from_light.point, from_light.wo, TransportMode::Importance},
                         from_camera, {from_camera.point, from_camera.wo, TransportMode::Radiance});
    if (!connection) return;
    ExplicitPath full = base;
    append_light(full, light, s);
    append_camera(full, camera, t, lens);
    agreement_.compare(path_weight(weights_, from_light, from_camera, *connection, eta_),
                       oracle(full).connection[s + 2],
                       fmt::format("connection s={} t={}", s + 2, t + 2));
  }

  /// Pretends that the light vertex lies where the camera's does: its photon is moved there.
  void merge(const ExplicitPath& base, const Walk& light, size_t s, const Walk& camera, size_t t,
             Vec3 lens) {
    const PathVertex& vertex = camera.steps[t].vertex;
    if (!vertex.is_connectible() || s + t == 0) return;
    // The light path arrives at x_m = the camera's vertex from its own x_{m-1}.
    const PathVertex& before = s > 0 ? light.steps[s - 1].vertex : light.steps[s].vertex;
    const bool is_at_light = s == 0;
    if (is_at_light || light.steps[s - 1].is_delta || !before.is_connectible()) return;
    PathVertex photon = arrive_at(light, s, vertex);
    if (photon.length == 0) return;
    const Vec3 wi = photon.wo;
    const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
    if (is_black(scattering.value(wi))) return;
    ExplicitPath full = base;
    append_light(full, light, s - 1);
    append_camera(full, camera, t, lens);
    const Merge densities{photon.partials, photon.length, scattering.pdf(wi) * vertex.survival,
                          scattering.pdf_reverse(wi) * vertex.survival};
    agreement_.compare(path_weight(weights_, vertex, densities, eta_),
                       oracle(full).merging[photon.length],
                       fmt::format("merge m={} t={}", photon.length, t + 2));
  }

  /// The light walk's step s - 1, scattered towards another point instead: step s as it would have
  /// arrived there, by the definition of the partials (docs/mis.md).
  PathVertex arrive_at(const Walk& light, size_t s, const PathVertex& target) const {
    const PathVertex& from = light.steps[s - 1].vertex;
    PathVertex photon = target;
    photon.length = 0;
    const Vec3 d = target.point.position - from.point.position;
    const Vec3 w = glm::normalize(d);
    const Scattering scattering(from.point, from.wo, TransportMode::Importance);
    const float pdf = scattering.pdf(w) * from.survival;
    if (!(pdf > 0) || is_black(scattering.value(w))) return photon;
    const float pdf_backward = scattering.pdf_reverse(w) * from.survival;
    const MisSums sums =
        mis_sums(from.partials, pdf_backward, weights_.count_before_light_vertex(from.length),
                 weights_.mergeable_light_vertex(from.length), weights_.independence(pdf_backward));
    const float squared = glm::dot(d, d);
    const float inverse_pdf =
        squared / (pdf * std::abs(glm::dot(w, target.point.geometric_normal)));
    const float chain = inverse_pdf * std::abs(glm::dot(w, from.point.geometric_normal)) / squared;
    photon.partials = {inverse_pdf, chain * sums.connection, chain * sums.merging};
    photon.wo = -w;
    photon.length = from.length + 1;
    return photon;
  }

  std::shared_ptr<const Scene> scene_;
  TechniqueCounts counts_;
  MisWeights weights_;
  float eta_;
  OracleAgreement agreement_;
};

// -- Scenes. A room with one wall left out, so that light from outside comes in.

SceneDescription furnished_room() {
  SceneDescription scene = testing::room();
  const auto add_bsdf = [&](auto model) {
    scene.bsdfs.push_back({.name = "", .line = 0, .model = model});
    return static_cast<int>(scene.bsdfs.size()) - 1;
  };
  testing::add_sphere(scene, {-0.5f, -0.6f, -0.4f}, 0.35f, add_bsdf(ConductorBsdf{}));
  testing::add_sphere(scene, {0.5f, -0.6f, -0.2f}, 0.35f, add_bsdf(DielectricBsdf{}));
  DielectricBsdf frosted;
  frosted.alpha_u = frosted.alpha_v = FloatInput{0.3f};
  testing::add_sphere(scene, {0, 0.2f, -0.5f}, 0.25f, add_bsdf(frosted));
  ConductorBsdf brushed;
  brushed.alpha_u = brushed.alpha_v = FloatInput{0.2f};
  testing::add_sphere(scene, {0.6f, 0.4f, -0.5f}, 0.2f, add_bsdf(brushed));
  testing::add_sphere(scene, {-0.6f, 0.4f, -0.5f}, 0.2f, add_bsdf(PlasticBsdf{}));
  return scene;
}

void add_emitter(SceneDescription& scene, auto model) {
  scene.emitters.push_back({.name = "", .line = 0, .model = model});
}

struct OracleCase {
  std::string name;
  std::function<void(SceneDescription&)> change;
};

const std::vector<OracleCase>& oracle_cases() {
  static const std::vector<OracleCase> list = {
      {"area", [](SceneDescription&) {}},
      {"sphere_light",
       [](SceneDescription& scene) {
         testing::add_sphere(scene, {0.2f, -0.2f, 0.2f}, 0.1f).radiance = ColorInput{Color(20)};
       }},
      {"point",
       [](SceneDescription& scene) {
         add_emitter(scene, PointEmitter{{0, 0.5f, 0}, Color(1)});
       }},
      {"spot",
       [](SceneDescription& scene) {
         SpotEmitter spot;
         spot.to_world = glm::rotate(glm::translate(Mat4(1), Vec3(0, 0.8f, 0.2f)),
                                     glm::radians(90.0f), Vec3(1, 0, 0));
         spot.cutoff_angle = 1;
         spot.beam_width = 0.5f;
         add_emitter(scene, spot);
       }},
      {"sun",
       [](SceneDescription& scene) {
         scene.shapes.erase(scene.shapes.begin() + 2);
         add_emitter(scene, DirectionalEmitter{{0.2f, -1, -0.3f}, Color(3)});
       }},
      {"environment",
       [](SceneDescription& scene) {
         scene.shapes.erase(scene.shapes.begin() + 2);
         add_emitter(scene, ConstantEmitter{Color(2)});
       }},
      {"environment_map",
       [](SceneDescription& scene) {
         scene.shapes.erase(scene.shapes.begin() + 2);
         Image sky(8, 4, 3);
         for (size_t i = 0; i < sky.data().size(); ++i) {
           sky.data()[i] = 0.2f + static_cast<float>(i % 7);
         }
         add_emitter(scene, EnvironmentEmitter{std::make_shared<const Image>(sky)});
       }},
      {"sky",
       [](SceneDescription& scene) {
         scene.shapes.erase(scene.shapes.begin() + 2);
         SunSkyEmitter sky;
         sky.sun_direction = glm::normalize(Vec3(0.3f, 1, 0.2f));
         sky.sun_radius_scale = 10;
         add_emitter(scene, sky);
       }},
      {"projector",
       [](SceneDescription& scene) {
         Image slide(4, 4, 3);
         for (size_t i = 0; i < slide.data().size(); ++i) {
           slide.data()[i] = static_cast<float>(i % 3);
         }
         ProjectorEmitter projector;
         projector.to_world = glm::translate(Mat4(1), Vec3(0, 0, 0.8f)) *
                              glm::rotate(Mat4(1), glm::radians(180.0f), Vec3(0, 1, 0));
         projector.image = std::make_shared<const Image>(slide);
         add_emitter(scene, projector);
       }},
      {"thin_lens",
       [](SceneDescription& scene) {
         scene.camera.model = CameraModel::ThinLens;
         scene.camera.aperture_radius = 0.05f;
       }},
      {"orthographic",
       [](SceneDescription& scene) { scene.camera.model = CameraModel::Orthographic; }},
  };
  return list;
}

class MisOracle : public ::testing::TestWithParam<OracleCase> {};

TEST_P(MisOracle, WeightsOfAllClosures) {
  SceneDescription description = furnished_room();
  GetParam().change(description);
  const auto scene = testing::build(std::move(description));
  for (const bool merge_direct : {false, true}) {
    TechniqueCounts counts;
    counts.light_tracing = 0.7f;
    counts.connections = 1.3f;
    counts.merge_direct = merge_direct;
    // Larger and smaller than the inverse of the densities that occur.
    if (merge_direct) counts.independent_angle = 0.5f;
    Closures closures(scene, counts, 0.02f);
    for (uint64_t i = 0; i < 8000; ++i) closures.try_path(i);
    const OracleAgreement& agreement = closures.agreement();
    EXPECT_GT(agreement.compared, 20000u);
    // Single precision leaves a few short segments, where it cannot tell directions, further off.
    EXPECT_LE(static_cast<double>(agreement.above), 1e-3 * static_cast<double>(agreement.compared))
        << agreement.worst;
    EXPECT_LE(agreement.largest, 1e-2) << agreement.worst;
    RecordProperty("closures", static_cast<int>(agreement.compared));
    RecordProperty("above_1e-4", static_cast<int>(agreement.above));
    RecordProperty("largest", fmt::format("{}", agreement.largest));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MisOracle, ::testing::ValuesIn(oracle_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight
