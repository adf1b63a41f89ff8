#include "ui/picture_developer.h"

#include <gtest/gtest.h>

#include <thread>

namespace guidelight {
namespace {

std::shared_ptr<const Snapshot> grey_snapshot(float value) {
  auto layers = std::make_shared<Snapshot::Layers>();
  for (const Layer layer : kAllLayers) {
    Image image(4, 3, layer_channels(layer));
    for (float& v : image.data()) v = value;
    (*layers)[static_cast<size_t>(layer)] = std::move(image);
  }
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->layers = std::move(layers);
  return snapshot;
}

TEST(PictureDeveloper, ShowsExactlyWhatDisplayImageMakes) {
  UiQueue queue([] {});
  std::vector<std::shared_ptr<const Picture>> pictures;
  PictureDeveloper developer(queue, [&](auto picture) { pictures.push_back(picture); }, {});
  DisplaySettings display;
  display.exposure = 1;
  const auto snapshot = grey_snapshot(0.2f);
  developer.request(snapshot, nullptr, Layer::Beauty, display);
  while (pictures.empty()) queue.run();
  DisplayImage expected;
  display_image(snapshot->layer(Layer::Beauty), display, expected);
  EXPECT_EQ(pictures[0]->image.rgba, expected.rgba);
  EXPECT_EQ(pictures[0]->snapshot, snapshot);

  developer.request(snapshot, nullptr, Layer::Beauty, display);  // the same again: nothing to do
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  queue.run();
  EXPECT_EQ(pictures.size(), 1u);
}

TEST(PictureDeveloper, TheNewestRequestIsAlwaysAnswered) {
  UiQueue queue([] {});
  std::shared_ptr<const Picture> latest;
  PictureDeveloper developer(queue, [&](auto picture) { latest = picture; }, {});
  const auto snapshot = grey_snapshot(0.5f);
  DisplaySettings display;
  for (int i = 0; i <= 50; ++i) {
    display.exposure = 0.1f * static_cast<float>(i);
    developer.request(snapshot, nullptr, Layer::Beauty, display);
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5) * GUIDELIGHT_SLOWDOWN;
  while ((!latest || latest->display.exposure < 4.99f) && std::chrono::steady_clock::now() < end) {
    queue.run();
  }
  ASSERT_TRUE(latest);
  EXPECT_FLOAT_EQ(latest->display.exposure, 5);
}

TEST(PictureDeveloper, NormalsAreShownAroundMiddleGrey) {
  const auto snapshot = grey_snapshot(0);
  DisplaySettings display;
  display.curve = ToneCurve::Gamma;
  display.gamma = 1;
  DisplayImage image;
  develop_picture(*snapshot, Layer::Normal, display, image);
  EXPECT_NEAR(image.rgba[0], 128, 1);
}

}  // namespace
}  // namespace guidelight
