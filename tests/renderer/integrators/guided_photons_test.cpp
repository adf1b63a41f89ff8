// Photons know which guide their light path began with.

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/integrators/integrator.h"
#include "renderer/photons/photon_cloud.h"
#include "renderer/transport/guide_mixture.h"
#include "tests/renderer/transport/guide_scenes.h"

namespace guidelight {
namespace {

PhotonCloud photons_of(const char* integrator, const std::shared_ptr<const Scene>& scene,
                       const std::vector<GuidePath>& guides) {
  Film film(16, 16);
  Parallel parallel(2);
  PhotonRequest request(1000000);
  const IntegratorInfo& info = find_integrator(integrator);
  info.create(scene, *info.make_settings(scene->description().hints))
      ->render_pass(0, film,
                    {.parallel = &parallel,
                     .photons = &request,
                     .guides = GuideMixture::build(scene, guides)});
  return std::move(request.cloud());
}

TEST(GuidedPhotons, LieInTheConeOfTheirGuide) {
  const guide_test::LitScene& lit = guide_test::lit_scenes().front();
  const auto scene = lit.build();
  std::vector<GuidePath> guides = guide_test::guides_for(*scene, lit);
  guides.resize(2);
  guides[0].enabled = false;  // positions are those of the whole list
  const Vec3 axis = glm::normalize(guides[1].vertices[1].position - guides[1].vertices[0].position);
  constexpr float kPackingError = 0.002f;  // [rad] of directions
  for (const char* integrator : {"photon_map", "sppm", "vcm", "bdpm"}) {
    size_t guided = 0;
    const PhotonCloud cloud = photons_of(integrator, scene, guides);
    for (const auto& photon : cloud.points) {
      if (photon.guide < 0) continue;
      ++guided;
      EXPECT_EQ(photon.guide, 1);
      if (photon.bounce > 1) continue;
      EXPECT_GE(glm::dot(-photon.direction, axis),
                std::cos(guides[1].vertices[0].cone + kPackingError));
    }
    EXPECT_GT(guided, cloud.points.size() / 20) << integrator;
    EXPECT_LT(guided, cloud.points.size()) << integrator;
  }
}

TEST(GuidedPhotons, AreNoneWithoutGuides) {
  const auto scene = guide_test::lit_scenes().front().build();
  const PhotonCloud cloud = photons_of("sppm", scene, {});
  EXPECT_FALSE(cloud.points.empty());
  for (const auto& photon : cloud.points) EXPECT_EQ(photon.guide, -1);
}

}  // namespace
}  // namespace guidelight
