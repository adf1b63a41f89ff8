#include "ui/opener.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "renderer/io/guide_file.h"
#include "renderer/session/picture_export.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class OpenerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / ("guidelight_opener_" + std::string(info->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_scene("ball.xml", 1);
  }
  void TearDown() override {
    opener_.reset();  // it finishes its files first
    fs::remove_all(folder_);
  }

  void write_scene(const std::string& name, float radius) const {
    std::ofstream(path(name)) << R"(<scene version="3.0.0">
      <sensor type="perspective">
        <transform name="to_world"><lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform>
        <film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="12"/></film>
      </sensor>
      <emitter type="constant"/>
      <shape type="sphere"><float name="radius" value=")"
                              << radius << R"("/><bsdf type="diffuse"/></shape></scene>)";
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  bool update_until(const std::function<bool()>& condition) {
    const auto end = Document::Clock::now() + 10s * GUIDELIGHT_SLOWDOWN;
    while (Document::Clock::now() < end) {
      queue_->run();
      document_.update(Document::Clock::now());
      if (condition()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }

  void open_scene(const std::string& name) {
    opener_->open(path(name));
    ASSERT_TRUE(update_until([&] {
      return document_.has_scene() && document_.opened().path == path(name) &&
             document_.picture() && document_.picture()->passes > 0;
    }));
  }

  /// The metadata of a picture of what is open now.
  Metadata metadata() const {
    return describe_render(document_.picture_job(), *document_.picture());
  }

  /// Saves a picture with these metadata and opens it; returns what was said.
  std::string open_picture(const Metadata& metadata) {
    write_png(path("picture.png"), DisplayImage{1, 1, {0, 0, 0, 255}}, metadata);
    Messages& messages = document_.messages();
    while (!messages.shown().empty()) messages.dismiss(messages.shown().front().id);
    opener_->open(path("picture.png"));
    update_until([&] { return opener_->loading().empty(); });
    return messages.shown().empty() ? "" : messages.shown().back().text;
  }

  static std::vector<GuidePath> guides(const std::string& name) {
    GuidePath guide;
    guide.name = name;
    guide.vertices.resize(2);
    guide.vertices[1].position = {0, 0, 1};
    return {guide};
  }

  fs::path folder_;
  std::shared_ptr<UiQueue> queue_ = std::make_shared<UiQueue>([] {});
  Document document_{[] {}};
  std::unique_ptr<Opener> opener_ = std::make_unique<Opener>(
      document_, queue_, Opener::Listener{[] {}, [] {}, [](const std::string&) {}});
};

TEST_F(OpenerTest, APictureWithoutAUsableCameraOrSizeChangesNothing) {
  open_scene("ball.xml");
  const Mat4 camera = document_.camera().to_world();
  const auto refused = [&](const std::string& key, const std::string& value) {
    Metadata changed = metadata();
    changed["seed"] = "9";
    changed[key] = value;
    EXPECT_NE(open_picture(changed), "") << key;
    EXPECT_EQ(document_.camera().to_world(), camera) << key;
    EXPECT_EQ(document_.settings().seed, 0u) << key;
    EXPECT_EQ(document_.settings().width, 16) << key;
    EXPECT_NO_THROW(document_.current_scene()) << key;
  };
  refused("camera_to_world", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
  refused("size", "65537x1");
  refused("size", "65536x65536");
  refused("integrator", "no_such_algorithm");
  refused("guides", "{");
}

TEST_F(OpenerTest, ASessionThatIsRefusedLeavesAnotherSceneOpen) {
  open_scene("ball.xml");
  Metadata other = metadata();
  write_scene("other.xml", 2);
  other["scene"] = path("other.xml");
  other["camera_to_world"] = "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0";
  EXPECT_NE(open_picture(other), "");
  EXPECT_EQ(document_.opened().path, path("ball.xml"));
}

TEST_F(OpenerTest, ACheckpointThatIsRefusedLeavesTheRenderAlone) {
  open_scene("ball.xml");
  std::atomic<bool> saved = false;
  ASSERT_TRUE(
      document_.save_checkpoint(path("a.checkpoint"), [&](const std::string&) { saved = true; }));
  ASSERT_TRUE(update_until([&] { return saved.load(); }));
  write_scene("ball.xml", 2);  // what was rendered is of another scene from now on
  opener_->reload();
  ASSERT_TRUE(update_until([&] { return document_.openings() == 2 && document_.picture(); }));
  RenderSettings settings = document_.settings();
  settings.seed = 7;
  document_.set_settings(settings);
  ASSERT_TRUE(update_until([&] { return document_.picture_job().seed == 7; }));
  const uint64_t job = document_.picture()->job;

  opener_->open(path("a.checkpoint"));
  ASSERT_TRUE(update_until([&] { return !document_.messages().shown().empty(); }));
  EXPECT_NE(document_.messages().shown().back().text.find("has changed"), std::string::npos);
  EXPECT_EQ(document_.settings().seed, 7u);
  EXPECT_FALSE(document_.restart_pending());
  EXPECT_EQ(document_.status().job, job);
}

TEST_F(OpenerTest, GuidesThatASessionReplacesAreKept) {
  open_scene("ball.xml");
  Metadata with_guides = metadata();
  with_guides["guides"] = guides_text(guides("of the picture"));
  document_.edit_guides(guides("mine"), "test");
  open_picture(with_guides);
  EXPECT_EQ(document_.guides()->front().name, "of the picture");
  const std::string aside = path("ball.guides.json.earlier");
  const auto is_said = [&] {
    return document_.messages().shown().back().text.find(aside) != std::string::npos;
  };
  EXPECT_TRUE(update_until(is_said));
  EXPECT_EQ(read_guides(aside).front().name, "mine");

  open_picture(with_guides);  // the same again: nothing is replaced
  EXPECT_FALSE(fs::exists(path("ball.guides.json-2.earlier")));
}

TEST_F(OpenerTest, APictureWithoutGuidesBringsNone) {
  open_scene("ball.xml");
  const Metadata without = metadata();
  document_.edit_guides(guides("mine"), "test");
  open_picture(without);
  EXPECT_TRUE(document_.guides()->empty());
  EXPECT_TRUE(update_until([&] { return fs::exists(path("ball.guides.json.earlier")); }));
  document_.undo();
  EXPECT_EQ(document_.guides()->size(), 1u);
}

}  // namespace
}  // namespace guidelight
