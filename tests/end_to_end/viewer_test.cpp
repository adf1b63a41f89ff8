#include <cmath>
#include <fstream>
#include <thread>

#include "renderer/image/layer.h"
#include "renderer/io/checkpoint_file.h"
#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// A colour of the interface that nothing else has.
constexpr uint32_t kNoteStripe = 0x76aa82;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

TEST_F(ViewerTest, ShowsThePictureOfTheDefaultScene) {
  start({scene("default")});
  const auto opened = Clock::now();
  ASSERT_TRUE(wait_for_picture());
  const double seconds = seconds_since(opened);
  std::printf("first picture %.2f s after the window opened\n", seconds);
  RecordProperty("seconds_to_first_picture", std::to_string(seconds));
  EXPECT_EQ(driver_->title(), "default — Guidelight");
}

TEST_F(ViewerTest, ClosingWhileRenderingEndsTheProcessWithSuccess) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  const auto closed = Clock::now();
  driver_->close_window();
  const auto status = viewer_->wait(10s);
  std::printf("ended %.2f s after its window was closed\n", seconds_since(closed));
  ASSERT_TRUE(status) << "the process still runs";
  EXPECT_EQ(*status, 0);
}

TEST_F(ViewerTest, ControlQQuits) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  driver_->press_key("q", {"Control_L"});
  EXPECT_EQ(viewer_->wait(10s), 0);
}

TEST_F(ViewerTest, OpensWithoutASceneAndFailsKindlyOnAMissingOne) {
  start({"/nowhere/missing.xml"});
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kErrorStripe) > 40; }));
  EXPECT_EQ(driver_->title(), "Guidelight");
  driver_->close_window();
  EXPECT_EQ(viewer_->wait(10s), 0);
}

// -- Camera.

TEST_F(ViewerTest, OrbitChangesThePictureAndHomeBringsItBack) {
  start({scene("default"), "--size", "320x240"});
  ASSERT_TRUE(wait_for_picture());
  ScreenPicture before = capture();
  // The picture gets less noisy by itself until it hardly changes any more.
  ASSERT_TRUE(wait_until([&] {
    std::this_thread::sleep_for(500ms);
    const bool calm = view_difference(before) < kNoise / 2;
    before = capture();
    return calm;
  }));
  driver_->drag(kViewCenter, {kViewCenter.x + 120, kViewCenter.y}, Mouse::Left, {"Alt_L"});
  EXPECT_TRUE(wait_until([&] { return view_difference(before) > 2 * kNoise; }));
  driver_->press_key("Home");
  EXPECT_TRUE(wait_until([&] { return view_difference(before) < kNoise; }));
}

TEST_F(ViewerTest, EveryWayToMoveTheCameraChangesThePicture) {
  start({write_scene("ball.xml"), "--size", "320x240"});
  ASSERT_TRUE(wait_for_picture());
  std::this_thread::sleep_for(500ms);
  const ScreenPicture before = capture();
  const auto moved_and_reset = [&](const char* what) {
    EXPECT_TRUE(wait_until([&] { return view_difference(before) > kNoise; }, 5s)) << what;
    driver_->press_key("Home");
    EXPECT_TRUE(wait_until([&] { return view_difference(before) < 1.5; }, 5s)) << what;
  };
  driver_->drag(kViewCenter, {kViewCenter.x + 80, kViewCenter.y + 60}, Mouse::Middle, {"Alt_L"});
  moved_and_reset("pan");

  driver_->move_mouse(kViewCenter);
  for (int i = 0; i < 4; ++i) {
    driver_->hold_button(Mouse::WheelUp, true);
    driver_->hold_button(Mouse::WheelUp, false);
  }
  moved_and_reset("dolly");

  driver_->hold_button(Mouse::Right, true);
  driver_->hold_key("d", true);
  std::this_thread::sleep_for(700ms);
  driver_->hold_key("d", false);
  driver_->hold_button(Mouse::Right, false);
  moved_and_reset("fly");

  driver_->drag(kViewCenter, {kViewCenter.x + 100, kViewCenter.y + 30}, Mouse::Right);
  moved_and_reset("look");

  driver_->press_key("f");
  moved_and_reset("frame");
}

TEST_F(ViewerTest, TheWildestMotionsLeaveTheWindowOpen) {
  const std::string path = (folder() / "empty.xml").string();
  std::ofstream(path) << R"(<scene version="3.0.0"><emitter type="constant"/></scene>)";
  for (const std::string& file : {write_scene("ball.xml"), path}) {
    start({file, "--size", "64x48"});
    ASSERT_TRUE(wait_for_picture()) << file;
    driver_->set_pace(0ms);
    driver_->move_mouse(kViewCenter);
    const auto turn_wheel = [&](Mouse direction) {
      for (int i = 0; i < 2000; ++i) {
        driver_->hold_button(direction, true);
        driver_->hold_button(direction, false);
      }
    };
    turn_wheel(Mouse::WheelDown);
    driver_->set_pace(50ms);
    driver_->hold_button(Mouse::Right, true);
    driver_->move_mouse({kViewCenter.x + 40, kViewCenter.y});
    driver_->set_pace(0ms);
    turn_wheel(Mouse::WheelUp);  // flies faster
    driver_->set_pace(50ms);
    driver_->hold_key("w", true);
    std::this_thread::sleep_for(500ms);
    driver_->hold_key("w", false);
    driver_->hold_button(Mouse::Right, false);
    EXPECT_FALSE(viewer_->wait(1s)) << "the window has closed";
    driver_->close_window();
    EXPECT_EQ(viewer_->wait(10s), 0) << file;
  }
}

// -- Rendering.

TEST_F(ViewerTest, PauseFreezesThePassCounter) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_picture());
  const uint32_t first = saved_passes();
  EXPECT_TRUE(wait_until([&] { return saved_passes() > first; })) << "passes grow while rendering";

  driver_->press_key("space");
  std::this_thread::sleep_for(500ms);
  const uint32_t paused = saved_passes();
  std::this_thread::sleep_for(1500ms);
  EXPECT_EQ(saved_passes(), paused);

  driver_->press_key("space");
  EXPECT_TRUE(wait_until([&] { return saved_passes() > paused; })) << "and again when resumed";
}

TEST_F(ViewerTest, APausedViewerRests) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("space");
  std::this_thread::sleep_for(7s);  // the message of the saved picture has gone
  const double before = viewer_->cpu_seconds();
  std::this_thread::sleep_for(2s);
  const double share = (viewer_->cpu_seconds() - before) / 2;
  std::printf("%.1f %% of a processor while paused\n", 100 * share);
  EXPECT_LT(share, 0.2) << "rendering takes more than one whole processor";
}

TEST_F(ViewerTest, AnIntegratorParameterChangesTheRender) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_full_picture());
  ASSERT_EQ(read_metadata(save_png()).at("set.max_depth"), "12");
  const double before = view_brightness();
  // After the algorithm comes the longest path; Ctrl+click types into it.
  driver_->hold_key("Control_L", true);
  driver_->click(field_in_left_panel(1));
  driver_->hold_key("Control_L", false);
  std::this_thread::sleep_for(500ms);
  driver_->type("2\n");
  EXPECT_TRUE(wait_until([&] { return read_metadata(save_png()).at("set.max_depth") == "2"; }));
  EXPECT_TRUE(wait_until([&] { return view_brightness() < 0.9 * before; }))
      << "direct light alone is darker";
}

TEST_F(ViewerTest, ThePauseButtonIsInReachHoweverManyParametersThereAre) {
  start({write_scene("ball.xml"), "--integrator", "mps"});
  ASSERT_TRUE(wait_for_picture());
  constexpr int kInPause = 30;
  ASSERT_TRUE(wait_until([&] { return !fields_at(kInPause).empty(); }));
  const Point pause = fields_at(kInPause).front();
  driver_->click(pause);
  EXPECT_TRUE(wait_until([&] { return capture().at(pause) == kAccent; }));
}

TEST_F(ViewerTest, TheFirstHintIsClickedAwayForGood) {
  constexpr Point kStripe{321, 60};
  constexpr Point kCross{722, 51};  // in the upper right corner of the hint
  const auto shown = [&] { return capture().at(kStripe) == kAccent; };
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_until(shown));
  driver_->click(kCross);
  EXPECT_TRUE(wait_until([&] { return !shown(); }));
  driver_->close_window();
  ASSERT_TRUE(viewer_->wait(5s));
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_picture());
  std::this_thread::sleep_for(500ms);
  EXPECT_FALSE(shown());
}

TEST_F(ViewerTest, KeysTypedIntoAFieldDoNothingElse) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_picture());
  const auto before = read_metadata(save_png());
  ASSERT_TRUE(change_view([&] { driver_->press_key("o", {"Control_L"}); }));
  driver_->type("e]n ");
  driver_->press_key("Escape");
  std::this_thread::sleep_for(300ms);
  const auto after = read_metadata(save_png());
  EXPECT_EQ(after.at("exposure"), before.at("exposure"));
  EXPECT_EQ(after.at("layer"), before.at("layer"));
  const uint32_t passes = saved_passes();
  EXPECT_TRUE(wait_until([&] { return saved_passes() > passes; })) << "the space did not pause";
}

TEST_F(ViewerTest, ARegionIsRenderedAlone) {
  start({write_scene("ball.xml"), "--size", "320x240"});
  ASSERT_TRUE(wait_for_picture());
  driver_->press_key("r");
  driver_->drag({kViewCenter.x - 60, kViewCenter.y - 60}, {kViewCenter.x + 60, kViewCenter.y + 60},
                Mouse::Left);
  EXPECT_TRUE(wait_until([&] { return read_metadata(save_png()).contains("region"); }));
  driver_->press_key("r", {"Shift_L"});
  EXPECT_TRUE(wait_until([&] { return !read_metadata(save_png()).contains("region"); }));
}

// -- Image.

TEST_F(ViewerTest, ExposureChangesThePictureWithoutARestart) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("space");
  std::this_thread::sleep_for(500ms);
  const double before = view_brightness();
  const auto old = read_metadata(save_png());
  for (int i = 0; i < 4; ++i) driver_->press_key("e");
  EXPECT_TRUE(wait_until([&] { return view_brightness() > before + 10; }));
  const auto now = read_metadata(save_png());
  EXPECT_EQ(std::stof(now.at("exposure")), std::stof(old.at("exposure")) + 1);
  EXPECT_EQ(now.at("passes"), old.at("passes"));
  for (int i = 0; i < 4; ++i) driver_->press_key("e", {"Shift_L"});
  EXPECT_TRUE(wait_until([&] { return std::abs(view_brightness() - before) < 1; }));
}

TEST_F(ViewerTest, BracketsStepThroughTheLayers) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  ASSERT_EQ(read_metadata(save_png()).at("layer"), "beauty");
  driver_->press_key("bracketright");
  EXPECT_TRUE(wait_until([&] { return read_metadata(save_png()).at("layer") == "direct"; }));
  driver_->press_key("bracketleft");
  driver_->press_key("bracketleft");
  EXPECT_TRUE(wait_until([&] { return read_metadata(save_png()).at("layer") == "variance"; }));
}

/// Whether the picture, as saved, stands on the screen with its corner at `corner`.
bool stands_at(const ScreenPicture& screen, const Image& saved, Point corner, int step) {
  for (int y = 0; y < saved.height(); y += step) {
    for (int x = 0; x < saved.width(); x += step) {
      const Color color = saved.color(x, y) * 255.0f;
      const auto packed = static_cast<uint32_t>(std::lround(color.r)) << 16 |
                          static_cast<uint32_t>(std::lround(color.g)) << 8 |
                          static_cast<uint32_t>(std::lround(color.b));
      if (screen.at({corner.x + x, corner.y + y}) != packed) return false;
    }
  }
  return true;
}

TEST_F(ViewerTest, F12SavesExactlyWhatIsShown) {
  start({scene("default"), "--size", "400x300"});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("1");  // a picture pixel is a screen pixel
  driver_->press_key("space");
  driver_->move_mouse({5, 700});
  const ScreenPicture screen = driver_->capture_when_still();
  const Image saved = read_image(save_png(), ColorSpace::Linear);
  ASSERT_EQ(saved.width(), 400);
  ASSERT_EQ(saved.height(), 300);
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kNoteStripe) > 40; }))
      << "it says where it wrote";

  // Centred in the view, give or take how halves are rounded.
  std::optional<Point> found;
  for (int y = -3; y <= 3; ++y) {
    for (int x = -3; x <= 3; ++x) {
      const Point corner{kViewCenter.x - 200 + x, kViewCenter.y - 150 + y};
      if (stands_at(screen, saved, corner, 37)) found = corner;
    }
  }
  ASSERT_TRUE(found) << "the saved picture is not on the screen";
  EXPECT_TRUE(stands_at(screen, saved, *found, 1)) << "every pixel is the same";
}

TEST_F(ViewerTest, ExportsAllLayersAsExr) {
  start({scene("default"), "--size", "160x120"});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("e", {"Control_L"});
  const auto path = folder() / "default.exr";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(path); }));
  const ImageLayers picture = read_exr(path.string());
  EXPECT_EQ(picture.layers.size(), size_t{kLayerCount});
  EXPECT_EQ(picture.metadata.at("scene"), scene("default"));
}

TEST_F(ViewerTest, ShiftF12SavesTheWindow) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  driver_->press_key("F12", {"Shift_L"});
  const auto path = folder() / "default-window.png";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(path); }));
  const Image window = read_image(path.string());
  EXPECT_EQ(window.width(), 1280);
  EXPECT_EQ(window.height(), 720);
}

TEST_F(ViewerTest, AnExposureThatIsTypedStaysWithinLimits) {
  start({write_scene("ball.xml"), "--size", "64x48"});
  ASSERT_TRUE(wait_for_full_picture());
  constexpr int kInRightPanel = 1150;
  driver_->hold_key("Control_L", true);
  driver_->click(fields_at(kInRightPanel).at(1));  // after the layer
  driver_->hold_key("Control_L", false);
  std::this_thread::sleep_for(500ms);
  driver_->type("500\n");
  EXPECT_TRUE(wait_until([&] { return read_metadata(save_png()).at("exposure") == "20"; }));
}

// -- How it feels: figures to look at, not limits to pass, since machines differ.

TEST_F(ViewerTest, AnswersAtOnceWhileRendering) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  const Point corner{kViewCenter.x - 32, kViewCenter.y - 32};
  const auto seconds_until_changed = [&](const std::function<void()>& act) {
    const ScreenPicture before = driver_->capture_area(corner, {64, 64});
    act();
    const auto begin = Clock::now();
    while (seconds_since(begin) < 10 &&
           block_difference(before, driver_->capture_area(corner, {64, 64}), {0, 0}, {64, 64}) <
               1) {
    }
    return seconds_since(begin);
  };
  double key = 0;
  double move = 0;
  constexpr int kRepetitions = 5;
  for (int i = 0; i < kRepetitions; ++i) {
    key += seconds_until_changed([&] { driver_->hold_key("e", true); }) / kRepetitions;
    driver_->hold_key("e", false);
    driver_->move_mouse(kViewCenter);
    driver_->hold_key("Alt_L", true);
    driver_->hold_button(Mouse::Left, true);
    const Point to{kViewCenter.x + (i % 2 == 0 ? 40 : -40), kViewCenter.y};
    move += seconds_until_changed([&] { driver_->move_mouse(to); }) / kRepetitions;
    driver_->hold_button(Mouse::Left, false);
    driver_->hold_key("Alt_L", false);
  }
  std::printf("%.0f ms from an exposure key to the screen, %.0f ms from a camera move\n", 1e3 * key,
              1e3 * move);
  EXPECT_LT(key, 10);
  EXPECT_LT(move, 10);
}

// -- Files.

TEST_F(ViewerTest, ABrokenSceneThatIsDroppedLeavesThePictureAndSaysWhy) {
  start({scene("default"), "--size", "200x150"});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("space");
  const ScreenPicture before = driver_->capture_when_still();
  const std::string broken = (folder() / "broken.xml").string();
  std::ofstream(broken) << "<scene version=\"3.0.0\"><shape type=\"obj\">";
  ASSERT_TRUE(driver_->drop_file(broken, kViewCenter));
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kErrorStripe) > 40; }));
  EXPECT_EQ(driver_->title(), "default — Guidelight");
  // Messages cover the lower left of the view; the rest is as it was.
  EXPECT_LT(block_difference(before, capture(), kViewCorner, {kViewSize.x, 300}), kNoise);
  const uint32_t passes = saved_passes();
  driver_->press_key("space");
  EXPECT_TRUE(wait_until([&] { return saved_passes() > passes; })) << "the render goes on";
}

TEST_F(ViewerTest, ADroppedSceneIsOpened) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  const ScreenPicture before = capture();
  ASSERT_TRUE(driver_->drop_file(scene("cornell"), kViewCenter));
  EXPECT_TRUE(wait_until([&] { return driver_->title() == "cornell — Guidelight"; }));
  EXPECT_TRUE(wait_until([&] { return view_difference(before) > kNoise; }));
}

TEST_F(ViewerTest, AReloadKeepsTheCameraUnlessTheFileHasAnother) {
  const std::string path = write_scene("ball.xml");
  start({path, "--integrator", "bdpt"});
  ASSERT_TRUE(wait_for_picture());
  const auto at_first = read_metadata(save_png());
  driver_->drag(kViewCenter, {kViewCenter.x + 60, kViewCenter.y}, Mouse::Left, {"Alt_L"});
  std::this_thread::sleep_for(1s);
  const auto then = read_metadata(save_png());
  ASSERT_NE(then.at("camera_to_world"), at_first.at("camera_to_world"));

  const auto edit = [&](const std::string& from, const std::string& to) {
    std::ifstream in(path);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    text.replace(text.find(from), from.size(), to);
    std::ofstream(path) << text;
  };
  const auto reloaded = [&](const Metadata& before) {
    driver_->press_key("r", {"Control_L"});
    Metadata now;
    EXPECT_TRUE(wait_until([&] {
      now = read_metadata(save_png());
      return now.at("scene_hash") != before.at("scene_hash");
    }));
    return now;
  };
  edit("0.4, 0.5, 0.6", "0.6, 0.5, 0.4");
  const auto lit_otherwise = reloaded(then);
  EXPECT_EQ(lit_otherwise.at("camera_to_world"), then.at("camera_to_world"));
  EXPECT_EQ(lit_otherwise.at("integrator"), "bdpt");
  edit("0, 0, 5", "0, 0, 4");
  EXPECT_NE(reloaded(lit_otherwise).at("camera_to_world"), then.at("camera_to_world"));
}

TEST_F(ViewerTest, ADroppedPictureRestoresItsSession) {
  start({scene("default"), "--size", "160x120", "--seed", "5"});
  ASSERT_TRUE(wait_for_picture());
  driver_->drag(kViewCenter, {kViewCenter.x + 60, kViewCenter.y}, Mouse::Left, {"Alt_L"});
  std::this_thread::sleep_for(1s);
  const std::string saved = save_png();
  const auto then = read_metadata(saved);
  ASSERT_TRUE(driver_->drop_file(scene("cornell"), kViewCenter));
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "cornell — Guidelight"; }));
  ASSERT_TRUE(driver_->drop_file(saved, kViewCenter));
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "default — Guidelight"; }));
  std::this_thread::sleep_for(1s);
  const auto now = read_metadata(save_png());
  for (const char* key : {"scene", "seed", "size", "camera_to_world", "integrator"}) {
    EXPECT_EQ(now.at(key), then.at(key)) << key;
  }
}

TEST_F(ViewerTest, ACheckpointIsResumedByAnotherViewer) {
  start({scene("default"), "--size", "160x120", "--seed", "5"});
  ASSERT_TRUE(wait_for_picture());
  driver_->drag(kViewCenter, {kViewCenter.x + 60, kViewCenter.y}, Mouse::Left, {"Alt_L"});
  // Longer than it takes to look at what is resumed.
  std::this_thread::sleep_for(6s);
  ASSERT_TRUE(change_view([&] { driver_->press_key("s", {"Control_L"}); }));
  driver_->press_key("Return");  // the name that is suggested
  const std::string path = (folder() / "default.checkpoint").string();
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(path); }));
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kNoteStripe) > 40; }))
      << "it says where it wrote";
  const auto then = read_metadata(save_png());
  driver_->close_window();
  EXPECT_EQ(viewer_->wait(10s), 0);
  const Checkpoint checkpoint = read_checkpoint(path);
  EXPECT_GT(checkpoint.seconds, 5);

  const auto expect_resumed = [&] {
    // A render that began anew would need the time it took before.
    const auto now = read_metadata(save_png());
    EXPECT_GT(std::stoul(now.at("passes")), checkpoint.next_pass);
    EXPECT_GT(std::stod(now.at("seconds")), checkpoint.seconds);
    for (const char* key : {"scene", "seed", "size", "camera_to_world", "integrator"}) {
      EXPECT_EQ(now.at(key), then.at(key)) << key;
    }
  };
  start({scene("cornell")});
  ASSERT_TRUE(wait_for_picture());
  ASSERT_TRUE(change_view([&] { driver_->press_key("o", {"Control_L", "Shift_L"}); }));
  driver_->press_key("End");
  driver_->type("default.checkpoint\n");
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "default — Guidelight"; }));
  std::this_thread::sleep_for(1s);  // for the dialog to leave the screen
  expect_resumed();
  ASSERT_TRUE(driver_->drop_file(scene("cornell"), kViewCenter));
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "cornell — Guidelight"; }));
  ASSERT_TRUE(driver_->drop_file(path, kViewCenter));
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "default — Guidelight"; }));
  expect_resumed();
}

TEST_F(ViewerTest, TheOpenDialogWorksByKeyboard) {
  start({write_scene("first.xml")});
  write_scene("second.xml");
  ASSERT_TRUE(wait_for_picture());
  const auto open_dialog = [&] { driver_->press_key("o", {"Control_L"}); };
  ASSERT_TRUE(change_view(open_dialog));
  driver_->press_key("End");
  driver_->type("second.xml\n");
  ASSERT_TRUE(wait_until([&] { return driver_->title() == "second — Guidelight"; }));
  std::this_thread::sleep_for(1s);  // the title changes before the dialog has left the screen

  ASSERT_TRUE(change_view(open_dialog));
  // The folder "state" comes first, then the two scenes.
  for (const char* key : {"Down", "Down", "Return"}) {
    driver_->press_key(key);
    std::this_thread::sleep_for(500ms);  // a key pressed twice within a frame counts once
  }
  EXPECT_TRUE(wait_until([&] { return driver_->title() == "first — Guidelight"; }));
}

TEST_F(ViewerTest, TheOpenDialogWorksByMouse) {
  start({write_scene("first.xml")});
  write_scene("second.xml");
  ASSERT_TRUE(wait_for_picture());
  ASSERT_TRUE(change_view([&] {
    driver_->click({22, 13});  // the menu File …
    driver_->click({60, 46});  // … and its first entry
  }));
  EXPECT_TRUE(wait_until([&] {
    driver_->click({520, 196});  // after "../", "state/" and "first.xml"
    driver_->click({913, 581});  // the button Open
    return wait_until([&] { return driver_->title() == "second — Guidelight"; }, 2s);
  }));
}

// -- Window.

TEST_F(ViewerTest, F1ShowsTheKeysAndEscapeHidesThem) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_picture());
  driver_->press_key("space");
  driver_->move_mouse({5, 700});
  const ScreenPicture before = driver_->capture_when_still();
  driver_->press_key("F1");
  EXPECT_TRUE(wait_until([&] { return view_difference(before) > 2 * kNoise; }));
  driver_->press_key("Escape");
  EXPECT_TRUE(wait_until([&] { return view_difference(before) < 1; }));
}

TEST_F(ViewerTest, F2HidesThePanels) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  const Point corner{0, 0};
  const Point size{280, 720};
  const ScreenPicture before = capture();
  driver_->press_key("F2");
  EXPECT_TRUE(
      wait_until([&] { return block_difference(before, capture(), corner, size) > 2 * kNoise; }));
  driver_->press_key("F2");
  EXPECT_TRUE(
      wait_until([&] { return block_difference(before, capture(), corner, size) < kNoise; }));
}

TEST_F(ViewerTest, TheWindowCanBeResized) {
  start({scene("default")});
  ASSERT_TRUE(wait_for_picture());
  for (const Point size : {Point{900, 600}, Point{400, 300}, Point{1280, 720}}) {
    driver_->resize_window(size);
    std::this_thread::sleep_for(400ms);
  }
  EXPECT_TRUE(wait_for_picture());
  driver_->close_window();
  EXPECT_EQ(viewer_->wait(10s), 0);
}

}  // namespace
}  // namespace guidelight
