#include "ui/photons/density_mesh.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

/// Photons spread evenly over the square [0, 1]² in z = 0, of which every `stride`th is shown.
PhotonCloud even_photons(size_t total, size_t stride) {
  PhotonCloud cloud;
  cloud.total = total;
  Rng rng(1, 0, 0);
  for (size_t i = 0; i < total; i += stride) {
    const Vec2 u = rng.next_vec2();
    cloud.points.push_back({Vec3(u, 0), Vec3(0, 0, 1), Color(1), 1, false, -1});
  }
  return cloud;
}

DisplayMesh square() {
  const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  DisplayMesh mesh;
  for (const int i : {0, 1, 2, 0, 2, 3}) mesh.vertices.push_back({corners[i], 0, 0x80808080});
  return mesh;
}

float area_of(const DisplayMesh& mesh) {
  float area = 0;
  for (size_t i = 0; i < mesh.vertices.size(); i += 3) {
    const auto* corner = &mesh.vertices[i];
    area += 0.5f * glm::length(glm::cross(corner[1].position - corner[0].position,
                                          corner[2].position - corner[0].position));
  }
  return area;
}

TEST(PhotonSearch, FindsTheDensityOfAllPhotonsByThoseThatAreShown) {
  Parallel parallel(1);
  for (const size_t stride : {1, 4}) {
    const PhotonSearch search(even_photons(40000, stride), 0.2f, parallel);
    // The mean over places; one estimate from 24 photons is off by a fifth.
    double sum = 0;
    constexpr int kSide = 8;
    for (int i = 0; i < kSide * kSide; ++i) {
      const Vec2 place = 0.2f + 0.6f * Vec2(i % kSide, i / kSide) / float{kSide};
      sum += search.density(Vec3(place, 0), Vec3(0, 0, 1)) / (kSide * kSide);
    }
    EXPECT_NEAR(sum, 40000, 0.1 * 40000) << stride;  // three standard errors
    const auto radius = search.radius_of(100, Vec3(0.5f, 0.5f, 0), Vec3(0, 0, 1));
    ASSERT_TRUE(radius);
    EXPECT_NEAR(*radius, std::sqrt(100 / (kPi * 40000)), 0.4f * *radius);
  }
}

TEST(PhotonSearch, LeavesOutPhotonsOfOtherSurfaces) {
  Parallel parallel(1);
  const PhotonSearch search(even_photons(10000, 1), 0.1f, parallel);
  EXPECT_EQ(search.density({0.5f, 0.5f, 0.05f}, {0, 0, 1}), 0) << "above the square";
  EXPECT_EQ(search.density({3, 3, 0}, {0, 0, 1}), 0) << "beside it";
  EXPECT_FALSE(search.radius_of(10, {3, 3, 0}, {0, 0, 1}));
}

TEST(DensityMesh, PartsCoverTheWhole) {
  const DisplayMesh fine = subdivided(square(), 1000);
  EXPECT_NEAR(static_cast<double>(fine.vertices.size()) / 3, 1000, 60);
  EXPECT_NEAR(area_of(fine), 1, 1e-4);
}

TEST(DensityMesh, DenserPlacesAreNearerToTheEndOfTheScale) {
  Parallel parallel(1);
  PhotonCloud cloud = even_photons(20000, 1);
  for (auto& point : cloud.points) point.position.x *= point.position.x;  // dense at x = 0
  const DensityMap map = make_density_map(subdivided(square(), 400), {cloud, 0.3f, parallel});
  EXPECT_GT(map.low, 0);
  EXPECT_GT(map.high, 2 * map.low);
  const auto green = [&](float x) {  // Viridis gets greener along the scale
    double sum = 0, count = 0;
    for (const auto& vertex : map.mesh.vertices) {
      if (std::abs(vertex.position.x - x) > 0.1f) continue;
      sum += vertex.color >> 8 & 255;
      ++count;
    }
    return sum / count;
  };
  EXPECT_GT(green(0.1f), green(0.9f) + 20);
}

TEST(DensityMesh, WithoutPhotonsThereIsNoScale) {
  Parallel parallel(1);
  const DensityMap map = make_density_map(square(), {PhotonCloud{}, 0.1f, parallel});
  EXPECT_EQ(map.low, 0);
  EXPECT_EQ(map.high, 0);
}

}  // namespace
}  // namespace guidelight
