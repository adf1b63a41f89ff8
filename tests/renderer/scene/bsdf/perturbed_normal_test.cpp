#include <gtest/gtest.h>

#include "tests/renderer/scene/bsdf/bsdf_cases.h"

namespace guidelight::bsdf_test {
namespace {

template <typename... Models>
std::shared_ptr<const Bsdf> build_with_texture(std::shared_ptr<const Image> image,
                                               Models... models) {
  SceneDescription scene;
  scene.textures.push_back(
      {.name = "", .line = 0, .model = BitmapTexture{.image = std::move(image)}});
  scene.bsdfs = chain(std::move(models)...);
  return make_bsdfs(scene, make_textures(scene)).back();
}

std::shared_ptr<const Image> one_texel(Color value) {
  auto image = std::make_shared<Image>(1, 1, 3);
  for (int c = 0; c < 3; ++c) image->data()[c] = value[c];
  return image;
}

/// Grey ramp that rises by 1 over the unit interval of u.
std::shared_ptr<const Image> ramp() {
  constexpr int kWidth = 64;
  auto image = std::make_shared<Image>(kWidth, 1, 1);
  for (int x = 0; x < kWidth; ++x) image->data()[x] = (x + 0.5f) / kWidth;
  return image;
}

SurfacePoint tilted_point(const Bsdf& bsdf) {
  SurfacePoint point = flat_point(bsdf);
  point.frame = Frame::from_normal_and_tangent(direction(50, 70), Vec3(1, 0, 0));
  point.geometric_normal = point.frame.n;
  point.dpdu = 3.0f * point.frame.s;
  point.dpdv = 2.0f * point.frame.t;
  point.uv = Vec2(0.5f);
  return point;
}

void expect_orthonormal(const Frame& frame) {
  EXPECT_NEAR(glm::length(frame.n), 1, 1e-5f);
  EXPECT_NEAR(glm::length(frame.s), 1, 1e-5f);
  EXPECT_LT(glm::length(glm::cross(frame.s, frame.t) - frame.n), 1e-5f);
}

TEST(NormalMap, FlatColourLeavesTheNormal) {
  const auto bsdf = build_with_texture(one_texel(Color(0.5f, 0.5f, 1)), DiffuseBsdf{},
                                       NormalMapBsdf{.texture = 0, .nested = 0});
  const SurfacePoint point = tilted_point(*bsdf);
  EXPECT_LT(glm::length(bsdf->shading_frame(point).n - point.frame.n), 1e-6f);
}

TEST(NormalMap, ColourTiltsTheNormalInTheTangentFrame) {
  const Vec3 tilt = direction(30, 40);
  const auto bsdf = build_with_texture(one_texel(0.5f * tilt + 0.5f), DiffuseBsdf{},
                                       NormalMapBsdf{.texture = 0, .nested = 0});
  const SurfacePoint point = tilted_point(*bsdf);
  const Frame frame = bsdf->shading_frame(point);
  EXPECT_LT(glm::length(frame.n - point.frame.to_world(tilt)), 1e-5f);
  expect_orthonormal(frame);
}

TEST(NormalMap, MirroredTextureKeepsItsYOnlyInMitsuba) {
  const Vec3 tilt = direction(30, 40);
  const Vec3 mirrored(tilt.x, -tilt.y, tilt.z);
  for (const bool y_is_against_v : {false, true}) {
    const auto bsdf = build_with_texture(
        one_texel(0.5f * tilt + 0.5f), DiffuseBsdf{},
        NormalMapBsdf{.texture = 0, .nested = 0, .y_is_against_v = y_is_against_v});
    SurfacePoint point = tilted_point(*bsdf);  // v grows along t: mirrored in the eyes of glTF
    const Vec3 expected = y_is_against_v ? mirrored : tilt;
    const Frame frame = bsdf->shading_frame(point);
    EXPECT_LT(glm::length(frame.n - point.frame.to_world(expected)), 1e-5f);
    expect_orthonormal(frame);
    point.dpdv = -point.dpdv;
    EXPECT_LT(glm::length(bsdf->shading_frame(point).n - point.frame.to_world(tilt)), 1e-5f);
  }
}

TEST(BumpMap, SlopeIsThatOfTheDisplacedSurface) {
  // Height rises by scale per unit of u, and a unit of u is 3 long: slope 0.6/3.
  const auto bsdf = build_with_texture(ramp(), DiffuseBsdf{},
                                       BumpMapBsdf{.texture = 0, .scale = 0.6f, .nested = 0});
  SurfacePoint point = tilted_point(*bsdf);
  const Vec3 expected = glm::normalize(point.frame.n - 0.2f * point.frame.s);
  const Frame frame = bsdf->shading_frame(point);
  EXPECT_LT(glm::length(frame.n - expected), 1e-3f);
  expect_orthonormal(frame);
  // A flipped normal is displaced to the other side.
  point.frame = Frame(point.frame.s, -point.frame.t, -point.frame.n);
  EXPECT_LT(glm::length(bsdf->shading_frame(point).n -
                        glm::normalize(point.frame.n - 0.2f * point.frame.s)),
            1e-3f);
}

TEST(BumpMap, WithoutParametrisationChangesNothing) {
  const auto bsdf =
      build_with_texture(ramp(), DiffuseBsdf{}, BumpMapBsdf{.texture = 0, .nested = 0});
  SurfacePoint point = tilted_point(*bsdf);
  point.dpdu = point.dpdv = Vec3(0);
  EXPECT_LT(glm::length(bsdf->shading_frame(point).n - point.frame.n), 1e-6f);
}

TEST(PerturbedNormal, ReachesThroughOtherBsdfs) {
  const Vec3 tilt = direction(30, 40);
  const auto image = one_texel(0.5f * tilt + 0.5f);
  const NormalMapBsdf map{.texture = 0, .nested = 0};
  for (const auto& bsdf :
       {build_with_texture(image, DiffuseBsdf{}, map, TwoSidedBsdf{.front = 1, .back = 1}),
        build_with_texture(image, DiffuseBsdf{}, map, MaskBsdf{.nested = 1}),
        build_with_texture(image, DiffuseBsdf{}, map, CoatingBsdf{.nested = 1}),
        build_with_texture(image, DiffuseBsdf{}, map, BlendBsdf{.first = 0, .second = 1}),
        build_with_texture(image, DiffuseBsdf{}, map, BlendBsdf{.first = 1, .second = 0})}) {
    const SurfacePoint point = tilted_point(*bsdf);
    EXPECT_LT(glm::length(bsdf->shading_frame(point).n - point.frame.to_world(tilt)), 1e-5f);
  }
}

TEST(PerturbedNormal, MapsOfMapsAddUp) {
  const auto image = one_texel(0.5f * direction(20, 0) + 0.5f);
  const auto bsdf =
      build_with_texture(image, DiffuseBsdf{}, NormalMapBsdf{.texture = 0, .nested = 0},
                         NormalMapBsdf{.texture = 0, .nested = 1});
  const SurfacePoint point = tilted_point(*bsdf);
  EXPECT_LT(glm::length(bsdf->shading_frame(point).n - point.frame.to_world(direction(40, 0))),
            1e-5f);
}

}  // namespace
}  // namespace guidelight::bsdf_test
