#include "ui/document.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "renderer/session/picture_export.h"
#include "tests/renderer/test_scenes.h"
#include "ui/checkpoint_saver.h"
#include "ui/pixel_probe.h"
#include "ui/session_metadata.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

class DocumentTest : public ::testing::Test {
 protected:
  void open_room(int width = 24, int height = 16) {
    SceneDescription room = testing::room(width, height);
    room.path = "/scenes/room/scene.xml";
    document_.open({room.path, {}, testing::build(std::move(room)), {}, {}});
  }

  /// Frames of the window until the condition holds; false if it does not within ten seconds.
  bool update_until(const std::function<bool()>& condition) {
    const auto end = Document::Clock::now() + 10s * GUIDELIGHT_SLOWDOWN;
    while (Document::Clock::now() < end) {
      document_.update(Document::Clock::now());
      if (condition()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }

  bool wait_for_full_picture() {
    return update_until([&] { return document_.picture() && !document_.picture()->coarse; });
  }

  /// The job of the picture after pending restarts have been carried out and answered.
  uint64_t settled_job() {
    std::this_thread::sleep_for(20ms);
    uint64_t job = 0;
    update_until([&] {
      const bool same = document_.picture() && document_.picture()->job == job;
      job = document_.picture() ? document_.picture()->job : 0;
      return same;
    });
    return job;
  }

  Document document_{[] {}};
};

TEST_F(DocumentTest, IsEmptyAndHarmlessWithoutAScene) {
  document_.update(Document::Clock::now());
  document_.move_camera([](CameraController& camera) { camera.orbit({1, 1}); });
  document_.reset_camera();
  document_.restart();
  document_.normalise();
  document_.step_layer(1);
  document_.update(Document::Clock::now());
  EXPECT_FALSE(document_.has_scene());
  EXPECT_EQ(document_.current_scene(), nullptr);
  EXPECT_EQ(document_.picture(), nullptr);
}

TEST_F(DocumentTest, RendersWhatIsOpenedAtItsOwnSize) {
  open_room(24, 16);
  EXPECT_EQ(document_.title(), "room");
  ASSERT_TRUE(wait_for_full_picture());
  EXPECT_EQ(document_.picture()->layer(Layer::Beauty).width(), 24);
  EXPECT_EQ(document_.picture()->layer(Layer::Beauty).height(), 16);
  EXPECT_GT(document_.picture()->passes, 0u);
}

TEST_F(DocumentTest, CameraEditsRestartAndShowAnotherPicture) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  const uint64_t before = settled_job();
  const Mat4 old_camera = document_.picture_job().scene->camera().description().to_world;
  document_.move_camera([](CameraController& camera) { camera.orbit({0.3f, 0.1f}); });
  ASSERT_TRUE(update_until([&] { return document_.picture()->job > before; }));
  EXPECT_NE(document_.picture_job().scene->camera().description().to_world, old_camera);
}

TEST_F(DocumentTest, LooksNeverRestart) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  const uint64_t before = settled_job();
  document_.view().current().exposure = 2;
  document_.normalise();
  for (int i = 0; i < kLayerCount; ++i) document_.step_layer(1);
  document_.view().inspected_pixel = {3, 4};
  EXPECT_EQ(settled_job(), before);
}

TEST_F(DocumentTest, PauseFreezesThePassesAndAMoveWhilePausedShowsOnePicture) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  document_.set_paused(true);
  std::this_thread::sleep_for(100ms);
  document_.update(Document::Clock::now());
  const uint32_t passes = document_.status().passes;
  std::this_thread::sleep_for(200ms);
  document_.update(Document::Clock::now());
  EXPECT_EQ(document_.status().passes, passes);
  EXPECT_EQ(document_.status().state, SessionState::Paused);

  const uint64_t job = document_.picture()->job;
  document_.move_camera([](CameraController& camera) { camera.pan({0.1f, 0}); });
  EXPECT_TRUE(
      update_until([&] { return document_.picture()->job > job && !document_.picture()->coarse; }));
  document_.set_paused(false);
  EXPECT_TRUE(update_until([&] { return document_.status().passes > 2; }));
}

TEST_F(DocumentTest, ANewSizeForgetsPixelsAndRegions) {
  open_room();
  RenderSettings settings = document_.settings();
  settings.region = PixelRegion{0, 0, 4, 4};
  document_.set_settings(settings);
  document_.view().inspected_pixel = {20, 10};
  settings.width = 12;
  settings.height = 8;
  document_.set_settings(settings);
  EXPECT_FALSE(document_.settings().region);
  EXPECT_FALSE(document_.view().inspected_pixel);
  ASSERT_TRUE(
      update_until([&] { return document_.picture() && document_.picture()->full_width == 12; }));
}

TEST_F(DocumentTest, TheCommandLineOverridesEverySceneOpened) {
  RenderSettings overrides;
  overrides.width = 10;
  overrides.height = 6;
  overrides.seed = 7;
  overrides.threads = 1;
  document_.override_settings(overrides);
  open_room();
  EXPECT_EQ(document_.settings().width, 10);
  EXPECT_EQ(document_.settings().height, 6);
  EXPECT_EQ(document_.settings().seed, 7u);
  EXPECT_EQ(document_.settings().threads, 1);
  EXPECT_FALSE(document_.settings().integrator.empty());
}

TEST_F(DocumentTest, AnotherSceneReplacesThePictureOfTheOld) {
  open_room(24, 16);
  ASSERT_TRUE(wait_for_full_picture());
  open_room(30, 20);
  EXPECT_EQ(document_.picture(), nullptr) << "the old picture does not belong to the new scene";
  ASSERT_TRUE(wait_for_full_picture());
  EXPECT_EQ(document_.picture()->full_width, 30);
}

TEST_F(DocumentTest, ThePivotIsWhatTheCameraLooksAt) {
  open_room();
  const auto scene = document_.current_scene();
  const Ray ray{document_.camera().position(), document_.camera().forward(), kInfinity};
  const Hit hit = scene->intersect(ray);
  ASSERT_TRUE(hit.valid());
  EXPECT_NEAR(document_.camera().pivot_distance(), hit.t, 0.05f * hit.t);
}

TEST_F(DocumentTest, DataLayersAreShownWithARangeThatSuitsThem) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  document_.show_layer(Layer::Depth);
  const DisplaySettings& display = document_.view().current();
  EXPECT_EQ(display.curve, ToneCurve::FalseColor);
  const Image& depth = document_.picture()->layer(Layer::Depth);
  const float middle = depth.pixel(12, 8)[0];
  EXPECT_LT(display.false_color_min, middle);
  EXPECT_GT(display.false_color_max, middle * 0.9f);
}

TEST_F(DocumentTest, RadianceLayersShareTheirExposure) {
  document_.view().current().exposure = 1.5f;
  document_.show_layer(Layer::Indirect);
  EXPECT_EQ(document_.view().current().exposure, 1.5f);
  document_.show_layer(Layer::Albedo);
  EXPECT_EQ(document_.view().current().exposure, 0);
}

TEST_F(DocumentTest, TheExposureHasLimits) {
  document_.step_exposure(0.25f);
  EXPECT_EQ(document_.view().current().exposure, 0.25f);
  for (int i = 0; i < 1000; ++i) document_.step_exposure(0.25f);
  EXPECT_EQ(document_.view().current().exposure, kLargestExposure);
  for (int i = 0; i < 1000; ++i) document_.step_exposure(-0.25f);
  EXPECT_EQ(document_.view().current().exposure, -kLargestExposure);
}

TEST_F(DocumentTest, TheProbeReadsPicturesOfAnySize) {
  open_room(1, 1);
  constexpr int kWidth = 60'000;
  auto layers = std::make_shared<Snapshot::Layers>();
  for (const Layer layer : kAllLayers) {
    (*layers)[static_cast<size_t>(layer)] = Image(kWidth, 1, layer_channels(layer));
  }
  (*layers)[static_cast<size_t>(Layer::Beauty)].pixel(kWidth - 1, 0)[0] = 5;
  Snapshot snapshot;
  snapshot.layers = layers;
  snapshot.full_width = kWidth;
  snapshot.full_height = 1;
  const auto report = probe_pixel(document_.scene(), snapshot, kWidth - 1, 0);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->radiance.r, 5);
}

TEST_F(DocumentTest, TheProbeSeesWhatTheRayHits) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  const auto scene = document_.current_scene();
  const auto report = probe_pixel(*scene, *document_.picture(), 12, 8);
  ASSERT_TRUE(report && report->seen);
  EXPECT_GT(report->samples, 0);
  EXPECT_NEAR(report->depth, report->seen->distance, 0.2f * report->seen->distance);
  EXPECT_EQ(report->radiance, document_.picture()->layer(Layer::Beauty).color(12, 8));
  EXPECT_FALSE(probe_pixel(*scene, *document_.picture(), -1, 0));
  EXPECT_FALSE(probe_pixel(*scene, *document_.picture(), 24, 0));
}

TEST_F(DocumentTest, ASessionIsRestoredFromTheMetadataOfItsPicture) {
  open_room();
  RenderSettings settings = document_.settings();
  std::shared_ptr<IntegratorSettings> parameters = settings.parameters->clone();
  set_parameter(*parameters, "max_depth", "5");
  settings.parameters = parameters;
  settings.seed = 42;
  settings.width = 12;
  settings.height = 8;
  document_.set_settings(settings);
  settings.region = PixelRegion{1, 2, 10, 7};
  document_.set_settings(settings);
  document_.move_camera([](CameraController& camera) { camera.orbit({0.3f, -0.1f}); });
  ASSERT_TRUE(update_until([&] {
    return document_.picture() && document_.picture()->full_width == 12 &&
           !document_.picture()->coarse;
  }));
  settled_job();
  const Mat4 camera = document_.camera().to_world();
  const auto session = session_of(describe_render(document_.picture_job(), *document_.picture()));
  ASSERT_TRUE(session);

  open_room();
  restore_session(*session, document_);
  EXPECT_EQ(document_.camera().to_world(), camera);
  EXPECT_EQ(document_.settings().seed, 42u);
  EXPECT_EQ(document_.settings().width, 12);
  EXPECT_EQ(document_.settings().height, 8);
  EXPECT_EQ(document_.settings().region, (PixelRegion{1, 2, 10, 7}));
  EXPECT_EQ(session->parameters.at("max_depth"), "5");
  EXPECT_EQ(parameter_text(document_.settings().parameters->clone()->parameters().front()), "5");
}

GuidePath guide_between(const std::string& name, Vec3 a, Vec3 b) {
  GuidePath guide;
  guide.name = name;
  guide.vertices.resize(2);
  guide.vertices[0].position = a;
  guide.vertices[1].position = b;
  return guide;
}

TEST_F(DocumentTest, WhatIsFramedIsTheSelectedGuideOrLightPathOrTheScene) {
  open_room();
  const Bounds scene = document_.scene().bounds();
  EXPECT_EQ(document_.bounds_of_selection().upper, scene.upper);
  document_.edit_guides({guide_between("a", {1, 2, 3}, {2, 2, 3})}, "test");
  EXPECT_EQ(document_.bounds_of_selection().upper, scene.upper);
  document_.guide_view().selected = 0;
  EXPECT_NEAR(document_.bounds_of_selection().lower.x, 0.95f, 1e-5f);
  EXPECT_NEAR(document_.bounds_of_selection().upper.x, 2.05f, 1e-5f);
  EXPECT_NEAR(document_.bounds_of_selection().upper.y, 2.05f, 1e-5f);
  document_.guide_view().selected.reset();
  document_.harvest().paths.emplace_back().guide = guide_between("", {0, 0, 0}, {0, 4, 0});
  document_.harvest().selected = 0;
  EXPECT_NEAR(document_.bounds_of_selection().upper.y, 4.2f, 1e-5f);
}

TEST_F(DocumentTest, UndoKeepsTheSameGuideSelectedAndAlone) {
  open_room();
  const GuidePath a = guide_between("a", {0, 0, 0}, {0, 0, 1});
  const GuidePath b = guide_between("b", {0, 0, 0}, {0, 1, 0});
  const auto selected = [&] {
    const auto& index = document_.guide_view().selected;
    return index ? (*document_.guides())[*index].name : "none";
  };
  const auto alone = [&] {
    const auto& index = document_.guide_view().solo;
    return index ? (*document_.guides())[*index].name : "none";
  };
  document_.edit_guides({a, b}, "two");
  document_.edit_guides({b}, "delete guide");
  document_.guide_view().selected = 0;
  document_.set_solo(0);
  document_.undo();
  EXPECT_EQ(selected(), "b");
  EXPECT_EQ(alone(), "b");
  document_.guide_view().selected = 0;
  document_.redo();
  EXPECT_EQ(selected(), "none") << "it is gone";
  EXPECT_EQ(alone(), "b");

  document_.edit_guides({guide_between("c", {1, 0, 0}, {0, 1, 0})}, "changed");
  document_.guide_view().selected = 0;
  document_.undo();
  EXPECT_EQ(selected(), "b") << "a change of a guide is still of that guide";
}

TEST_F(DocumentTest, TargetsDoNotRestart) {
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  const uint64_t job = settled_job();
  RenderSettings settings = document_.settings();
  settings.targets.passes = 1;
  document_.set_settings(settings);
  ASSERT_TRUE(update_until([&] { return document_.status().state == SessionState::Finished; }));
  settings.targets.passes = document_.status().passes + 2;
  document_.set_settings(settings);
  ASSERT_TRUE(update_until([&] { return document_.status().passes == settings.targets.passes; }));
  EXPECT_EQ(document_.picture()->job, job);
}

TEST_F(DocumentTest, ACheckpointIsSavedAndResumed) {
  const std::string path = ::testing::TempDir() + "guidelight_document_test.checkpoint";
  EXPECT_FALSE(document_.save_checkpoint(path, {})) << "there is nothing to save";
  open_room();
  ASSERT_TRUE(update_until([&] { return document_.status().passes >= 3; }));
  std::atomic<bool> done = false;
  std::string problem;
  ASSERT_TRUE(document_.save_checkpoint(path, [&](const std::string& reason) {
    problem = reason;
    done = true;
  }));
  ASSERT_TRUE(update_until([&] { return done.load(); }));
  EXPECT_EQ(problem, "");
  const Checkpoint checkpoint = read_checkpoint(path);
  EXPECT_GE(checkpoint.next_pass, 3u);

  open_room();
  document_.resume(checkpoint, path);
  ASSERT_TRUE(wait_for_full_picture());
  EXPECT_GT(document_.picture()->passes, checkpoint.next_pass);
  EXPECT_GT(document_.picture()->seconds, checkpoint.seconds);

  // Another camera is another render: it says so, and begins anew.
  document_.move_camera([](CameraController& camera) { camera.pan({0.1f, 0}); });
  document_.resume(checkpoint, path);
  const uint64_t job = document_.picture()->job;
  ASSERT_TRUE(update_until([&] { return document_.picture()->job > job; }));
  EXPECT_NE(document_.messages().shown().back().text.find("another render"), std::string::npos);
  std::filesystem::remove(path);
}

TEST_F(DocumentTest, CheckpointsAreSavedAutomaticallyWhenItIsTime) {
  const std::string folder = ::testing::TempDir() + "guidelight_autosave";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto queue = std::make_shared<UiQueue>([] {});
  CheckpointSaver saver(document_, queue, folder);
  open_room();
  ASSERT_TRUE(wait_for_full_picture());
  const auto now = Document::Clock::now();
  saver.update(now);
  saver.update(now + 60min);
  EXPECT_TRUE(std::filesystem::is_empty(folder)) << "nobody asked for it";

  saver.autosave_minutes() = 10;
  saver.update(now + 9min);
  const std::string path = folder + "/room.checkpoint";
  const auto saved_passes = [&] {
    EXPECT_TRUE(update_until([&] {
      queue->run();
      return document_.messages().shown().size() == 1;
    }));
    EXPECT_EQ(document_.messages().shown().back().text, "Saved the progress to " + path);
    document_.messages().dismiss(document_.messages().shown().back().id);
    return read_checkpoint(path).next_pass;
  };
  ASSERT_FALSE(std::filesystem::exists(path));
  saver.update(now + 10min);
  const uint32_t first = saved_passes();
  ASSERT_TRUE(update_until([&] { return document_.status().passes > first + 1; }));
  saver.update(now + 21min);
  EXPECT_GT(saved_passes(), first) << "a render writes over its own checkpoint";

  document_.restart();
  const uint64_t job = document_.status().job;
  ASSERT_TRUE(update_until([&] { return document_.status().job > job; }));
  saver.update(now + 22min);
  ASSERT_TRUE(wait_for_full_picture());
  saver.update(now + 40min);
  EXPECT_TRUE(update_until([&] { return std::filesystem::exists(folder + "/room-2.checkpoint"); }))
      << "and over no other";
  std::filesystem::remove_all(folder);
}

TEST(SessionMetadata, OtherPicturesCarryNoSession) {
  EXPECT_FALSE(session_of({}));
  EXPECT_FALSE(session_of({{"software", "something else"}, {"scene", "/a.xml"}}));
}

TEST(SceneTitle, IsTheNameThatPeopleKnow) {
  EXPECT_EQ(scene_title("/scenes/coffee/scene_v3.xml"), "coffee");
  EXPECT_EQ(scene_title("/scenes/box.xml"), "box");
  EXPECT_EQ(scene_title("/scenes/My Model.glb"), "My Model");
}

TEST(Messages, AreShownOnceAndForgottenLater) {
  Messages messages;
  messages.note("a");
  messages.error("b");
  messages.note("a");
  ASSERT_EQ(messages.shown().size(), 2u);
  EXPECT_EQ(messages.shown().back().text, "a");
  messages.expire(Messages::Clock::now() + 10s);
  ASSERT_EQ(messages.shown().size(), 1u) << "errors stay longer";
  messages.dismiss(messages.shown().front().id);
  EXPECT_TRUE(messages.shown().empty());
}

}  // namespace
}  // namespace guidelight
