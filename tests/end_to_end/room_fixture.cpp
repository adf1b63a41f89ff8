#include "tests/end_to_end/room_fixture.h"

#include <fstream>
#include <thread>

#include "renderer/session/open_scene.h"
#include "renderer/transport/guide_check.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

constexpr const char* kRoom = R"(<scene version="3.0.0">
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

/// Where a camera whose picture fills a view shows a point.
Vec2 seen_at(const Camera& camera, Vec3 point, Vec2 view_center, Vec2 view_size) {
  const Vec2 picture(camera.width(), camera.height());
  const Vec2 fit = view_size / picture;
  const auto seen = camera.connect(point, Vec2(0.5f));
  return view_center + std::min(fit.x, fit.y) * (seen->raster - 0.5f * picture);
}

}  // namespace

void RoomTest::open_room(const std::vector<std::string>& arguments) {
  path_ = (folder() / "room.xml").string();
  std::ofstream(path_) << kRoom;
  scene_ = Scene::build(open_scene(path_, {}));
  std::vector<std::string> all = {path_};
  all.insert(all.end(), arguments.begin(), arguments.end());
  start(all);
  ASSERT_TRUE(wait_for_picture());
  driver_->press_key("space");
}

Point RoomTest::in_picture(Vec3 point) const {
  const Vec2 screen = seen_at(scene_->camera(), point, Vec2(kViewCenter.x, kViewCenter.y),
                              Vec2(kViewSize.x, kViewSize.y));
  return {static_cast<int>(screen.x), static_cast<int>(screen.y)};
}

Point RoomTest::in_scout(Vec3 point) const {
  CameraDescription lens = scene_->camera().description();
  lens.fov = 60;
  lens.fov_axis = FovAxis::Smaller;
  FilmDescription film;
  film.width = kViewSize.x;
  film.height = kViewSize.y;
  const Vec2 screen = seen_at(Camera(lens, film), point, Vec2(kViewCenter.x, kViewCenter.y),
                              Vec2(kViewSize.x, kViewSize.y));
  return {static_cast<int>(screen.x), static_cast<int>(screen.y)};
}

std::vector<GuidePath> RoomTest::saved_guides() const {
  const std::string file = guide_file_beside(path_);
  return std::filesystem::exists(file) ? read_guides(file) : std::vector<GuidePath>();
}

bool RoomTest::wait_for_guides(size_t count) const {
  return wait_until([&] { return saved_guides().size() == count; });
}

void RoomTest::expect_usable(const GuidePath& guide) const {
  for (const GuideFault& fault : check_guide(*scene_, guide)) {
    ADD_FAILURE() << guide.name << ", vertex " << fault.vertex << ": " << fault.message;
  }
}

void RoomTest::place(std::initializer_list<Point> clicks) {
  driver_->press_key("g");
  for (const Point& point : clicks) {
    driver_->click(point);
    std::this_thread::sleep_for(450ms);  // two quick clicks are a double click
  }
}

}  // namespace guidelight
