#include "renderer/scene/texture.h"

#include <gtest/gtest.h>

#include <limits>

#include "renderer/error.h"
#include "renderer/scene/surface_point.h"

namespace guidelight {
namespace {

/// 4 × 2 grey image: top row 0 1 2 3, bottom row 4 5 6 7.
std::shared_ptr<const Image> numbered_image() {
  auto image = std::make_shared<Image>(4, 2, 1);
  for (int i = 0; i < 8; ++i) image->data()[i] = static_cast<float>(i);
  return image;
}

template <typename Model>
std::shared_ptr<const Texture> build(Model model) {
  SceneDescription scene;
  scene.path = "test.xml";
  scene.textures.push_back({.name = "picture", .line = 7, .model = std::move(model)});
  return make_textures(scene).back();
}

BitmapTexture bitmap(WrapMode wrap, TextureFilter filter) {
  BitmapTexture texture;
  texture.image = numbered_image();
  texture.wrap_u = texture.wrap_v = wrap;
  texture.filter = filter;
  return texture;
}

float value_at(const Texture& texture, float u, float v) {
  SurfacePoint point;
  point.uv = {u, v};
  return texture.eval(point).x;
}

TEST(BitmapTexture, VIsZeroAtTheBottomRow) {
  for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear}) {
    const auto texture = build(bitmap(WrapMode::Clamp, filter));
    EXPECT_EQ(value_at(*texture, 0.125f, 0.25f), 4);
    EXPECT_EQ(value_at(*texture, 0.875f, 0.25f), 7);
    EXPECT_EQ(value_at(*texture, 0.125f, 0.75f), 0);
    EXPECT_EQ(value_at(*texture, 0.0f, 0.0f), 4);
    EXPECT_EQ(value_at(*texture, 1.0f, 1.0f), 3);
  }
}

TEST(BitmapTexture, NearestKeepsTexelsWholeAndBilinearMixesThem) {
  const auto nearest = build(bitmap(WrapMode::Clamp, TextureFilter::Nearest));
  EXPECT_EQ(value_at(*nearest, 0.249f, 0.3f), 4);
  EXPECT_EQ(value_at(*nearest, 0.251f, 0.3f), 5);
  const auto bilinear = build(bitmap(WrapMode::Clamp, TextureFilter::Bilinear));
  EXPECT_NEAR(value_at(*bilinear, 0.25f, 0.25f), 4.5f, 1e-6f);
  EXPECT_NEAR(value_at(*bilinear, 0.25f, 0.5f), 2.5f, 1e-6f);
  EXPECT_NEAR(value_at(*bilinear, 0.1875f, 0.25f), 4.25f, 1e-6f);
}

TEST(BitmapTexture, WrapModesOfWholeTexels) {
  const auto at = [](WrapMode wrap, float u) {
    return value_at(*build(bitmap(wrap, TextureFilter::Nearest)), u, 0.25f);
  };
  EXPECT_EQ(at(WrapMode::Repeat, 1.125f), 4);
  EXPECT_EQ(at(WrapMode::Repeat, -0.125f), 7);
  EXPECT_EQ(at(WrapMode::Repeat, -7.625f), 5);
  EXPECT_EQ(at(WrapMode::Mirror, 1.125f), 7);
  EXPECT_EQ(at(WrapMode::Mirror, -0.375f), 5);
  EXPECT_EQ(at(WrapMode::Mirror, 2.125f), 4);
  EXPECT_EQ(at(WrapMode::Clamp, 3.0f), 7);
  EXPECT_EQ(at(WrapMode::Clamp, -3.0f), 4);
  EXPECT_EQ(at(WrapMode::Zero, 1.125f), 0);
  EXPECT_EQ(at(WrapMode::Zero, -50.0f), 0);
  EXPECT_EQ(at(WrapMode::One, 1.125f), 1);
  EXPECT_EQ(at(WrapMode::One, 0.125f), 4);
}

TEST(BitmapTexture, WrapModesOfTheBilinearBorder) {
  const auto at = [](WrapMode wrap, float u) {
    return value_at(*build(bitmap(wrap, TextureFilter::Bilinear)), u, 0.25f);
  };
  EXPECT_NEAR(at(WrapMode::Repeat, 0.0f), 5.5f, 1e-5f);  // half of 7, half of 4
  EXPECT_NEAR(at(WrapMode::Repeat, 1.0f), 5.5f, 1e-5f);
  EXPECT_NEAR(at(WrapMode::Mirror, 1.0f), 7, 1e-5f);
  EXPECT_NEAR(at(WrapMode::Clamp, 1.0f), 7, 1e-5f);
  EXPECT_NEAR(at(WrapMode::Zero, 1.0f), 3.5f, 1e-5f);
  EXPECT_NEAR(at(WrapMode::One, 0.0f), 2.5f, 1e-5f);
}

TEST(BitmapTexture, AxesWrapEachByItsOwnMode) {
  BitmapTexture model = bitmap(WrapMode::Repeat, TextureFilter::Nearest);
  model.wrap_v = WrapMode::Clamp;
  const auto texture = build(model);
  EXPECT_EQ(value_at(*texture, 1.125f, 5), 0);
  EXPECT_EQ(value_at(*texture, 1.125f, -5), 4);
}

TEST(BitmapTexture, TransformIsAppliedToTheCoordinates) {
  BitmapTexture model = bitmap(WrapMode::Repeat, TextureFilter::Nearest);
  model.uv_transform = Mat3(2, 0, 0, 0, 1, 0, 0.25f, 0.5f, 1);  // columns: u·2 + 0.25, v + 0.5
  const auto texture = build(model);
  EXPECT_EQ(value_at(*texture, 0.1f, 0.25f), 1);
  EXPECT_EQ(value_at(*texture, 0.4f, 0.75f), 4);
}

TEST(BitmapTexture, OddCoordinatesAreHarmless) {
  for (const WrapMode wrap :
       {WrapMode::Repeat, WrapMode::Mirror, WrapMode::Clamp, WrapMode::Zero, WrapMode::One}) {
    for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear}) {
      const auto texture = build(bitmap(wrap, filter));
      for (const float t : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 1e30f,
                            -1e30f, -1e-10f, 1.0f, 0.0f, kOneMinusEpsilon, 2.0f}) {
        const float value = value_at(*texture, t, t);
        EXPECT_TRUE(value >= 0 && value <= 7) << t;
      }
    }
  }
}

TEST(BitmapTexture, ChannelsOfEveryLayout) {
  SurfacePoint point;
  const auto channels = [&](int count) {
    auto image = std::make_shared<Image>(1, 1, count);
    for (int c = 0; c < count; ++c) image->data()[c] = 0.1f * static_cast<float>(c + 1);
    const auto texture = build(BitmapTexture{.image = image});
    std::vector<float> values;
    for (int c = 0; c < 4; ++c) values.push_back(texture->eval_channel(point, c));
    return values;
  };
  EXPECT_EQ(channels(1), (std::vector<float>{0.1f, 0.1f, 0.1f, 1}));
  EXPECT_EQ(channels(2), (std::vector<float>{0.1f, 0.1f, 0.1f, 0.2f}));
  EXPECT_EQ(channels(3), (std::vector<float>{0.1f, 0.2f, 0.1f * 3, 1}));
  EXPECT_EQ(channels(4), (std::vector<float>{0.1f, 0.2f, 0.1f * 3, 0.4f}));
}

TEST(BitmapTexture, MeanIsOverAllTexels) {
  EXPECT_FLOAT_EQ(build(bitmap(WrapMode::Repeat, TextureFilter::Bilinear))->mean().x, 3.5f);
}

TEST(BitmapTexture, TexelsThatAreNotFiniteBecomeFinite) {
  auto image = std::make_shared<Image>(2, 1, 1);
  image->data()[0] = kInfinity;
  image->data()[1] = std::numeric_limits<float>::quiet_NaN();
  const auto texture = build(BitmapTexture{.image = image});
  EXPECT_EQ(value_at(*texture, 0.25f, 0.5f), 65504);
  EXPECT_EQ(value_at(*texture, 0.75f, 0.5f), 0);
  EXPECT_TRUE(is_finite(texture->mean()));
}

TEST(BitmapTexture, MissingImageIsAnErrorThatNamesTheTexture) {
  try {
    build(BitmapTexture{});
    FAIL();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("test.xml:7"), std::string::npos) << message;
    EXPECT_NE(message.find("picture"), std::string::npos) << message;
  }
}

TEST(Checkerboard, FirstColourWhereBothHalvesAgree) {
  const auto board = build(CheckerboardTexture{.color0 = {Color(0.9f)}, .color1 = {Color(0.1f)}});
  EXPECT_EQ(value_at(*board, 0.2f, 0.2f), 0.9f);
  EXPECT_EQ(value_at(*board, 0.7f, 0.7f), 0.9f);
  EXPECT_EQ(value_at(*board, 0.7f, 0.2f), 0.1f);
  EXPECT_EQ(value_at(*board, -0.3f, 0.2f), 0.1f);
  EXPECT_EQ(value_at(*board, 5.2f, -7.8f), 0.9f);
  EXPECT_FLOAT_EQ(board->mean().x, 0.5f);
}

TEST(Checkerboard, TransformMakesMoreSquares) {
  CheckerboardTexture model{.color0 = {Color(0.9f)}, .color1 = {Color(0.1f)}};
  model.uv_transform = Mat3(10, 0, 0, 0, 10, 0, 0, 0, 1);
  const auto board = build(model);
  EXPECT_EQ(value_at(*board, 0.02f, 0.02f), 0.9f);
  EXPECT_EQ(value_at(*board, 0.07f, 0.02f), 0.1f);
  EXPECT_EQ(value_at(*board, 0.12f, 0.02f), 0.9f);
}

TEST(Checkerboard, SquaresMayBeTextures) {
  SceneDescription scene;
  scene.textures.push_back(
      {.name = "", .line = 0, .model = bitmap(WrapMode::Clamp, TextureFilter::Nearest)});
  scene.textures.push_back(
      {.name = "",
       .line = 0,
       .model = CheckerboardTexture{.color0 = {Color(2.0f), 0}, .color1 = {Color(0.1f)}}});
  EXPECT_EQ(value_at(*make_textures(scene)[1], 0.875f, 0.75f), 6);
  std::swap(scene.textures[0], scene.textures[1]);
  EXPECT_THROW(make_textures(scene), Error);
}

TEST(VertexColors, AreThoseOfThePoint) {
  SurfacePoint point;
  point.vertex_color = Color(0.1f, 0.2f, 0.3f);
  const auto texture = build(VertexColorTexture{});
  EXPECT_EQ(texture->eval(point), Color(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(texture->eval_channel(point, 1), 0.2f);
  EXPECT_EQ(texture->eval_channel(point, 3), 1);
}

TEST(TextureInputs, MultiplyTheirValue) {
  SceneDescription scene;
  scene.textures.push_back({.name = "", .line = 0, .model = VertexColorTexture{}});
  const TextureList textures = make_textures(scene);
  SurfacePoint point;
  point.vertex_color = Color(0.5f, 0.25f, 1.0f);
  EXPECT_EQ(ColorTexture(ColorInput{Color(2.0f), 0}, textures).eval(point), Color(1, 0.5f, 2));
  EXPECT_EQ(FloatTexture(FloatInput{3, 0, 1}, textures).eval(point), 0.75f);
  EXPECT_FLOAT_EQ(FloatTexture(FloatInput{1, 0, kNone}, textures).eval(point),
                  luminance(point.vertex_color));
}

}  // namespace
}  // namespace guidelight
