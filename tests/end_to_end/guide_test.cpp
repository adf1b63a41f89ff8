#include <cmath>
#include <fstream>
#include <thread>

#include "renderer/io/guide_file.h"
#include "renderer/scene/scene.h"
#include "renderer/session/open_scene.h"
#include "renderer/transport/guide_check.h"
#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

constexpr Vec3 kLamp(0, 1.7f, 0);
constexpr Vec3 kFloor(-0.7f, 0, 0.4f);
constexpr Vec3 kWall(-0.9f, 1.2f, -2);
constexpr Vec3 kMirror(1.5f, 0.9f, 1);

/// A room with a round lamp, a floor, a wall behind and a mirror to the right.
class GuideTest : public ViewerTest {
 protected:
  void open_room() {
    path_ = (folder() / "room.xml").string();
    std::ofstream(path_) << R"(<scene version="3.0.0">
  <sensor type="perspective">
    <float name="fov" value="60"/>
    <transform name="to_world"><lookat origin="0, 1, 4" target="0, 1, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="320"/><integer name="height" value="240"/></film>
  </sensor>
  <bsdf type="diffuse" id="chalk"/>
  <bsdf type="conductor" id="mirror"><string name="material" value="none"/></bsdf>
  <shape type="sphere" id="lamp">
    <point name="center" x="0" y="1.7" z="0"/><float name="radius" value="0.25"/>
    <emitter type="area"><rgb name="radiance" value="4, 4, 4"/></emitter><ref id="chalk"/>
  </shape>
  <shape type="rectangle" id="floor"><ref id="chalk"/>
    <transform name="to_world"><rotate x="1" angle="-90"/><scale value="3"/></transform></shape>
  <shape type="rectangle" id="wall"><ref id="chalk"/>
    <transform name="to_world"><scale value="3"/><translate z="-2"/></transform></shape>
  <shape type="rectangle" id="glass"><ref id="mirror"/>
    <transform name="to_world"><rotate y="1" angle="-90"/><scale value="1.8"/><translate x="1.5" y="1"/></transform></shape>
</scene>
)";
    scene_ = Scene::build(open_scene(path_, {}));
    start({path_});
    ASSERT_TRUE(wait_for_picture());
    driver_->press_key("space");  // leave the machine to the window
  }

  /// Where a camera whose picture fills the view shows a point.
  static Point on_screen(const Camera& camera, Vec3 point) {
    const auto seen = camera.connect(point, Vec2(0.5f));
    const float scale = std::min(static_cast<float>(kViewSize.x) / camera.width(),
                                 static_cast<float>(kViewSize.y) / camera.height());
    const Vec2 middle = 0.5f * Vec2(camera.width(), camera.height());
    const Vec2 screen = Vec2(kViewCenter.x, kViewCenter.y) + scale * (seen->raster - middle);
    return {static_cast<int>(screen.x), static_cast<int>(screen.y)};
  }
  Point in_picture(Vec3 point) const { return on_screen(scene_->camera(), point); }
  /// The scout view stands where the render camera is and has a lens of its own.
  Point in_scout(Vec3 point) const {
    CameraDescription lens = scene_->camera().description();
    lens.fov = 60;
    lens.fov_axis = FovAxis::Smaller;
    FilmDescription film;
    film.width = kViewSize.x;
    film.height = kViewSize.y;
    return on_screen(Camera(lens, film), point);
  }
  /// On the lamp's near side, as the camera sees it.
  static Vec3 lamp_front() { return kLamp + 0.25f * glm::normalize(Vec3(0, 1, 4) - kLamp); }

  std::vector<GuidePath> saved_guides() const {
    const std::string file = guide_file_beside(path_);
    return std::filesystem::exists(file) ? read_guides(file) : std::vector<GuidePath>();
  }
  bool wait_for_guides(size_t count) const {
    return wait_until([&] { return saved_guides().size() == count; }, 5s);
  }
  void expect_usable(const GuidePath& guide) const {
    for (const GuideFault& fault : check_guide(*scene_, guide)) {
      ADD_FAILURE() << guide.name << ", vertex " << fault.vertex << ": " << fault.message;
    }
  }
  void place(std::initializer_list<Point> clicks) {
    driver_->press_key("g");
    for (const Point& point : clicks) {
      driver_->click(point);
      std::this_thread::sleep_for(450ms);  // two quick clicks are a double click
    }
  }

  std::string path_;
  std::shared_ptr<const Scene> scene_;
};

void expect_near(Vec3 a, Vec3 b, float tolerance) { EXPECT_LT(glm::distance(a, b), tolerance); }

TEST_F(GuideTest, APathIsPlacedInThePictureUndoneAndDoneAgain) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  ASSERT_EQ(guide.vertices.size(), 3u);
  expect_near(guide.vertices[0].position, lamp_front(), 0.05f);
  expect_near(guide.vertices[1].position, kFloor, 0.1f);
  expect_near(guide.vertices[2].position, kWall, 0.1f);
  expect_usable(guide);

  driver_->press_key("z", {"Control_L"});
  EXPECT_TRUE(wait_for_guides(0));
  driver_->press_key("z", {"Control_L", "Shift_L"});
  EXPECT_TRUE(wait_for_guides(1));
}

TEST_F(GuideTest, BackspaceTakesBackAndEscapeCancels) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("BackSpace");
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  EXPECT_EQ(saved_guides().front().vertices.size(), 2u);
  driver_->click(in_picture(lamp_front()));
  std::this_thread::sleep_for(450ms);
  driver_->press_key("Escape");  // the path
  driver_->press_key("Escape");  // the tool
  driver_->press_key("Return");
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(saved_guides().size(), 1u);
}

TEST_F(GuideTest, MirrorsAreFollowedInTheScoutView) {
  open_room();
  ASSERT_TRUE(change_view([&] { driver_->press_key("Tab"); }));
  place({in_scout(lamp_front()), in_scout(kMirror)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  ASSERT_EQ(guide.vertices.size(), 3u) << "the light, the mirror and what it shows";
  EXPECT_EQ(guide.vertices[1].event, PathEvent::Reflect);
  expect_near(guide.vertices[1].position, kMirror, 0.1f);
  expect_usable(guide);
}

TEST_F(GuideTest, ADraggedVertexTakesThePathAlongAndOneStepUndoesTheDrag) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  driver_->press_key("Escape");
  const Vec3 elsewhere(0.6f, 0, 0.3f);
  driver_->drag(in_picture(kFloor), in_picture(elsewhere), Mouse::Left);
  const auto moved = [&] {
    const auto guides = saved_guides();
    return !guides.empty() && glm::distance(guides[0].vertices.at(1).position, elsewhere) < 0.15f;
  };
  ASSERT_TRUE(wait_until(moved, 5s));
  expect_usable(saved_guides().front());
  expect_near(saved_guides().front().vertices[2].position, kWall, 0.1f);
  driver_->press_key("z", {"Control_L"});
  EXPECT_TRUE(wait_until([&] { return !moved(); }, 5s));
  expect_near(saved_guides().front().vertices[1].position, kFloor, 0.1f);
}

TEST_F(GuideTest, DraggingFromTheLightSwingsAWholePath) {
  open_room();
  driver_->press_key("g");
  const Vec3 before_the_mirror(0.9f, 0, 1.2f);
  driver_->drag(in_picture(lamp_front()), in_picture(before_the_mirror), Mouse::Left);
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  EXPECT_GE(guide.vertices.size(), 2u);
  expect_near(guide.vertices[1].position, before_the_mirror, 0.1f);
  expect_usable(guide);
}

TEST_F(GuideTest, ADroppedPictureBringsItsGuidesBack) {
  open_room();
  driver_->press_key("space");
  place({in_picture(lamp_front()), in_picture(kFloor)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const std::string picture = save_png();
  ASSERT_FALSE(picture.empty());
  driver_->press_key("Delete");
  ASSERT_TRUE(wait_for_guides(0));
  ASSERT_TRUE(driver_->drop_file(picture, kViewCenter));
  ASSERT_TRUE(wait_for_guides(1));
  expect_usable(saved_guides().front());
}

}  // namespace
}  // namespace guidelight
