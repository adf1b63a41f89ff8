#include "ui/export.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "renderer/io/image_file.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

TEST(Exporter, APictureCarriesWhatItIsOfAndNotWhatIsRenderedByNow) {
  const fs::path folder = fs::path(::testing::TempDir()) / "guidelight_export_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  UiQueue queue([] {});
  Document document([] {});
  SceneDescription room = testing::room(8, 6);
  room.path = "/scenes/room/scene.xml";
  document.open({room.path, {}, testing::build(std::move(room)), {}, {}});
  const auto update_until = [&](const std::function<bool()>& condition) {
    const auto end = Document::Clock::now() + 10s * GUIDELIGHT_SLOWDOWN;
    while (!condition() && Document::Clock::now() < end) {
      queue.run();
      document.update(Document::Clock::now());
      std::this_thread::sleep_for(1ms);
    }
    return condition();
  };
  ASSERT_TRUE(update_until([&] { return document.picture() && !document.picture()->coarse; }));
  const auto shown = std::make_shared<Picture>();
  shown->snapshot = document.picture();
  shown->job = document.shared_picture_job();
  shown->image = {8, 6, std::vector<uint8_t>(4 * 8 * 6, 255)};

  RenderSettings settings = document.settings();
  settings.seed = 77;
  document.set_settings(settings);
  ASSERT_TRUE(update_until([&] { return document.picture_job().seed == 77; }));
  {
    Exporter exporter(document, queue, folder.string());
    exporter.save_png(shown);
    exporter.save_drawing(shown->image, shown.get(), "-window");
  }
  EXPECT_EQ(read_metadata((folder / "room.png").string()).at("seed"), "0");
  EXPECT_EQ(read_metadata((folder / "room-window.png").string()).at("seed"), "0");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace guidelight
