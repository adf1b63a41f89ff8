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

TEST(IrradianceMap, a_bright_surface_behind_a_thin_wall_is_another) {
  // Two square plates of side 1 face up: a bright one, and 5 cm below a dim one of few photons.
  constexpr float kBrightPower = 1;
  constexpr float kDimPower = 1e-3f;
  const auto scene = grey_plate();
  PathVertex vertex = tilted_vertex(*scene, 0);
  Rng rng(1, 0, 0);
  std::vector<SurfacePhoton> photons;
  for (int i = 0; i < 100000; ++i) {
    const bool is_bright = i % 1000 != 0;
    vertex.point.position = Vec3(rng.next_vec2() - 0.5f, is_bright ? 0.05f : 0.0f);
    photons.push_back(
        make_surface_photon(vertex, Color(is_bright ? kBrightPower : kDimPower), false));
  }
  Parallel parallel(1);
  const PhotonMap map(photons, parallel);
  const EstimateSettings settings{.max_distance = 0.5f, .max_length = 9};
  const IrradianceMap irradiance(map, settings, 8, parallel);
  const Vec3 up(0, 0, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec2 place = 0.5f * (rng.next_vec2() - 0.5f);
    const auto above = irradiance.irradiance(Vec3(place, 0.05f), up, settings.max_distance);
    // k = 60 leaves 13 %, of which the largest of 100 may be 4 times.
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->r, 99900, 0.55f * 99900);
    const auto below = irradiance.irradiance(Vec3(place, 0), up, settings.max_distance);
    EXPECT_TRUE(!below || below->r < 0.02f * 99900);
  }
}

}  // namespace
}  // namespace guidelight
