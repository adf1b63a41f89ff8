#include "renderer/photons/photon_map.h"

#include <gtest/gtest.h>

#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

/// A diffuse vertex at the origin, seen from above, whose true surface is tilted from the shading
/// normal +z.
PathVertex tilted_vertex(const Scene& scene, float tilt) {
  const Ray ray{.origin = Vec3(0, 0, 1), .direction = Vec3(0, 0, -1)};
  PathVertex vertex{};
  vertex.point = scene.surface_point(ray, scene.intersect(ray));
  vertex.point.geometric_normal = Vec3(std::sin(tilt), 0, std::cos(tilt));
  vertex.wo = Vec3(0, 0, 1);
  vertex.length = 1;
  return vertex;
}

std::shared_ptr<const Scene> grey_plate() {
  SceneDescription description = testing::empty_scene();
  const int grey = testing::add_diffuse(description, Color(0.5f));
  testing::add_rectangle(description, Mat4(1), grey);
  return testing::build(description);
}

/// Of light that comes slantwise, at x = i mm.
SurfacePhoton photon_beside(PathVertex vertex, int i, Vec3 normal, float power) {
  vertex.wo = Vec3(0.6f, 0, 0.8f);
  vertex.point.position = Vec3(0.001f * static_cast<float>(i), 0, 0);
  vertex.point.geometric_normal = normal;
  return make_surface_photon(vertex, Color(power), false);
}

TEST(PhotonMap, light_has_passed_the_cosine_where_the_photon_is) {
  const auto scene = grey_plate();
  // The light comes along the surface of the vertex, nearly, but not of the photon.
  constexpr float kTilt = 0.6f;
  constexpr float kGrazing = 1e-3f;
  const PathVertex vertex = tilted_vertex(*scene, kTilt);
  const float angle = kPi / 2 - kTilt - kGrazing;
  const Vec3 wi(-std::sin(angle), 0, std::cos(angle));
  PathVertex left = vertex;
  left.point.position = Vec3(0.01f, 0, 0);
  left.point.geometric_normal = Vec3(0, 0, 1);
  left.wo = wi;
  const SurfacePhoton photon = make_surface_photon(left, Color(2.0f), false);
  Parallel parallel(1);
  const PhotonMap map({&photon, 1}, parallel);
  constexpr float kRadius = 0.1f;
  const EstimateSettings settings{
      .neighbors = 4, .max_distance = kRadius, .kernel = Kernel::Constant, .max_length = 9};
  const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
  // f · Φ/(πr²), for the cosines of the photon's surface and of the shading normal are the same.
  const float expected = 0.5f * kInvPi * 2 / (kPi * kRadius * kRadius);
  EXPECT_NEAR(luminance(map.radiance(vertex, scattering, settings)), expected, 0.01f * expected);
}

TEST(PhotonMap, estimates_of_a_surface_too_small_are_not_made) {
  const auto scene = grey_plate();
  const PathVertex vertex = tilted_vertex(*scene, 0);
  std::vector<SurfacePhoton> photons;
  for (int i = 0; i < 100; ++i) {
    // Nine on another surface for each on that of the vertex.
    photons.push_back(photon_beside(vertex, i, i % 10 == 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), 1));
  }
  Parallel parallel(1);
  const PhotonMap map(photons, parallel);
  const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
  EstimateSettings settings{.neighbors = 5, .max_distance = 10, .max_length = 9};
  settings.oversearch = 4;
  EXPECT_EQ(luminance(map.radiance(vertex, scattering, settings)), 0);
  settings.oversearch = 16;
  EXPECT_GT(luminance(map.radiance(vertex, scattering, settings)), 0);
}

TEST(PhotonMap, estimates_that_rest_on_few_photons_are_not_made) {
  const auto scene = grey_plate();
  const PathVertex vertex = tilted_vertex(*scene, 0);
  std::vector<SurfacePhoton> photons;
  for (int i = 0; i < 20; ++i) {
    // One is as bright as all others together: 20 of them count as (38)²/(19² + 19) = 3.8.
    photons.push_back(photon_beside(vertex, i, Vec3(0, 0, 1), i == 7 ? 19.0f : 1.0f));
  }
  Parallel parallel(1);
  const PhotonMap map(photons, parallel);
  const Scattering scattering(vertex.point, vertex.wo, TransportMode::Radiance);
  EstimateSettings settings{
      .neighbors = 20, .max_distance = 10, .kernel = Kernel::Constant, .max_length = 9};
  settings.min_effective = 3.6f;
  EXPECT_GT(luminance(map.radiance(vertex, scattering, settings)), 0);
  settings.min_effective = 4;
  EXPECT_EQ(luminance(map.radiance(vertex, scattering, settings)), 0);
}

}  // namespace
}  // namespace guidelight
