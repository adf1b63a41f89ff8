#include <gmock/gmock.h>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

/// Shapes, textures, emitters and media.
namespace guidelight::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MitsubaScene : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("mesh.obj", sample_obj());
    folder_.write("mesh.ply", sample_ply_text());
    folder_.write("mesh.serialized", sample_serialized());
    folder_.write("map.png", sample_png());
  }

  SceneDescription read(const std::string& body, const std::string& version = "3.0.0") {
    return read_mitsuba(folder_, "<sensor type=\"perspective\"/>" + body, version);
  }
  /// The only shape of a scene that must not warn.
  ShapeDescription shape(const std::string& body, const std::string& version = "3.0.0") {
    const SceneDescription scene = read(body, version);
    EXPECT_THAT(scene.warnings, IsEmpty());
    return scene.shapes.at(0);
  }
  template <typename Model>
  Model emitter(const std::string& body, const std::string& version = "3.0.0") {
    const SceneDescription scene = read(body, version);
    EXPECT_THAT(scene.warnings, IsEmpty());
    return std::get<Model>(scene.emitters.at(0).model);
  }
  BitmapTexture bitmap(const std::string& parameters) {
    const SceneDescription scene =
        read("<texture type=\"bitmap\" id=\"t\"><string name=\"filename\" value=\"map.png\"/>" +
             parameters + "</texture>");
    EXPECT_THAT(scene.warnings, IsEmpty());
    return std::get<BitmapTexture>(scene.textures.at(0).model);
  }
  static const Mesh& mesh(const ShapeDescription& shape) {
    return *std::get<MeshShape>(shape.geometry).mesh;
  }

  TemporaryFolder folder_;
};

void expect_near(Vec3 actual, Vec3 expected) {
  EXPECT_NEAR(glm::length(actual - expected), 0, 1e-5f)
      << actual.x << ' ' << actual.y << ' ' << actual.z;
}

// -- Shapes

TEST_F(MitsubaScene, ObjFlipsVUnlessToldNot) {
  const std::string obj = R"(<shape type="obj"><string name="filename" value="mesh.obj"/>)";
  EXPECT_EQ(mesh(shape(obj + "</shape>")).uvs[2], Vec2(1, 0.25f));
  for (const std::string name : {"flip_tex_coords", "flipTexCoords"}) {
    EXPECT_EQ(mesh(shape(obj + "<boolean name=\"" + name + "\" value=\"false\"/></shape>")).uvs[2],
              Vec2(1, 0.75f));
  }
}

TEST_F(MitsubaScene, PlyDoesNotFlipVUnlessTold) {
  const std::string ply = R"(<shape type="ply"><string name="filename" value="mesh.ply"/>)";
  EXPECT_EQ(mesh(shape(ply + "</shape>")).uvs[2], Vec2(1, 0.25f));
  EXPECT_EQ(mesh(shape(ply + R"(<boolean name="flip_tex_coords" value="true"/></shape>)")).uvs[2],
            Vec2(1, 0.75f));
}

TEST_F(MitsubaScene, ColoursOfAPlyAreEncodedInTheOldFormat) {
  folder_.write("coloured.ply", sample_ply_binary());
  const auto green = [&](const std::string& version, const std::string& srgb) {
    const std::string xml =
        R"(<shape type="ply"><string name="filename" value="coloured.ply"/>)" + srgb + "</shape>";
    return mesh(shape(xml, version)).colors[2].g;
  };
  EXPECT_NEAR(green("0.6.0", ""), 0.132868f, 1e-5f);  // 102 of 255
  EXPECT_FLOAT_EQ(green("0.6.0", R"(<boolean name="srgb" value="false"/>)"), 0.4f);
  EXPECT_FLOAT_EQ(green("3.0.0", ""), 0.4f);
}

TEST_F(MitsubaScene, NormalsAreSmoothUnlessFacesAreAskedFor) {
  const std::string start =
      R"(<shape type="serialized"><string name="filename" value="mesh.serialized"/>)";
  EXPECT_EQ(mesh(shape(start + "</shape>")).normals.size(), 3u) << "computed";
  EXPECT_EQ(mesh(shape(start + R"(<integer name="shapeIndex" value="1"/></shape>)")).normals.size(),
            3u);
  for (const std::string name : {"face_normals", "faceNormals"}) {
    EXPECT_TRUE(mesh(shape(start + "<boolean name=\"" + name + "\" value=\"true\"/></shape>"))
                    .normals.empty());
  }
}

TEST_F(MitsubaScene, EqualMeshesAreReadOnce) {
  const std::string obj = R"(<shape type="obj"><string name="filename" value="mesh.obj"/></shape>)";
  const SceneDescription scene = read(obj + obj);
  EXPECT_EQ(&mesh(scene.shapes[0]), &mesh(scene.shapes[1]));
}

TEST_F(MitsubaScene, AnalyticShapes) {
  const ShapeDescription sphere =
      shape(R"(<shape type="sphere"><point name="center" x="1" y="2" z="3"/>
    <float name="radius" value="2"/><transform name="to_world"><scale value="10"/></transform>
    <boolean name="flip_normals" value="true"/></shape>)");
  EXPECT_TRUE(std::holds_alternative<SphereShape>(sphere.geometry));
  EXPECT_TRUE(sphere.flip_normals);
  expect_near(transform_point(sphere.to_world, Vec3(1, 0, 0)), Vec3(30, 20, 30));
  EXPECT_TRUE(std::holds_alternative<DiskShape>(shape(R"(<shape type="disk"/>)").geometry));

  const ShapeDescription cylinder = shape(R"(<shape type="cylinder"><point name="p0" value="1 0 0"/>
    <point name="p1" value="4 0 0"/><float name="radius" value="0.5"/></shape>)");
  EXPECT_TRUE(std::holds_alternative<CylinderShape>(cylinder.geometry));
  expect_near(transform_point(cylinder.to_world, Vec3(0)), Vec3(1, 0, 0));
  expect_near(transform_point(cylinder.to_world, Vec3(0, 0, 1)), Vec3(4, 0, 0));
  EXPECT_NEAR(glm::length(transform_vector(cylinder.to_world, Vec3(1, 0, 0))), 0.5f, 1e-6f);
  EXPECT_GT(glm::determinant(Mat3(cylinder.to_world)), 0) << "not mirrored";
}

TEST_F(MitsubaScene, RectangleAndCube) {
  const Mesh rectangle = mesh(shape(R"(<shape type="rectangle"/>)"));
  EXPECT_EQ(rectangle.triangles.size(), 2u);
  EXPECT_EQ(rectangle.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(rectangle.uvs[2], Vec2(1, 1));
  EXPECT_EQ(mesh(shape(R"(<shape type="cube"/>)")).triangles.size(), 12u);
}

TEST_F(MitsubaScene, GroupsAndInstances) {
  const SceneDescription scene = read(R"(
    <shape type="shapegroup" id="g"><shape type="sphere"/><shape type="cube"/></shape>
    <shape type="instance"><ref id="g"/>
      <transform name="toWorld"><translate x="3"/></transform></shape>
    <shape type="instance"><ref id="g"/></shape>)",
                                      "0.6.0");
  EXPECT_THAT(scene.warnings, IsEmpty());
  ASSERT_EQ(scene.groups.size(), 1u);
  EXPECT_EQ(scene.groups[0].shapes.size(), 2u);
  ASSERT_EQ(scene.shapes.size(), 2u);
  EXPECT_EQ(std::get<InstanceShape>(scene.shapes[1].geometry).group, 0);
  expect_near(Vec3(scene.shapes[0].to_world[3]), Vec3(3, 0, 0));
}

TEST_F(MitsubaScene, MissingAndBrokenMeshesNameTheSceneLine) {
  EXPECT_THAT(
      mitsuba_error("\n<shape type=\"obj\"><string name=\"filename\" value=\"no.obj\"/></shape>"),
      ::testing::AllOf(HasSubstr("scene.xml:3:"), HasSubstr("no.obj")));
  folder_.write("bad.ply", "ply\nnonsense");
  EXPECT_THROW(read(R"(<shape type="ply"><string name="filename" value="bad.ply"/></shape>)"),
               Error);
  EXPECT_THAT(mitsuba_error(R"(<shape type="obj"/>)"), HasSubstr("names no file"));
}

TEST_F(MitsubaScene, ShapesScaledToNothingAreLeftOutUnlessFlat) {
  const auto scaled = [&](const std::string& type, const std::string& scale) {
    return read("<shape type=\"" + type + "\" id=\"it\"><transform name=\"to_world\"><scale " +
                scale +
                "/><rotate x=\"1\" angle=\"90\"/></transform></shape><shape type=\"cube\"/>");
  };
  for (const std::string type : {"rectangle", "disk"}) {
    const SceneDescription scene = scaled(type, R"(x="2" z="0")");
    EXPECT_THAT(scene.warnings, IsEmpty());
    ASSERT_EQ(scene.shapes.size(), 2u);
    const Mat4& to_world = scene.shapes[0].to_world;
    expect_near(transform_vector(to_world, Vec3(1, 0, 0)), Vec3(2, 0, 0));
    expect_near(transform_vector(to_world, Vec3(0, 0, 1)), Vec3(0, -1, 0));
  }
  for (const auto& [type, scale] : std::vector<std::pair<std::string, std::string>>{
           {"rectangle", R"(x="0")"}, {"sphere", R"(z="0")"}, {"cube", R"(value="0")"}}) {
    const SceneDescription scene = scaled(type, scale);
    EXPECT_THAT(scene.warnings, ::testing::ElementsAre(HasSubstr("'it' is scaled to nothing")));
    EXPECT_EQ(scene.shapes.size(), 1u) << type;
  }
}

TEST_F(MitsubaScene, UnsupportedShapesAreLeftOut) {
  const SceneDescription scene = read(R"(<shape type="heightfield"/><shape type="sphere"/>)");
  EXPECT_EQ(scene.shapes.size(), 1u);
  EXPECT_THAT(scene.warnings, ::testing::ElementsAre(HasSubstr("'heightfield'")));
}

// -- Media and area lights

TEST_F(MitsubaScene, AreaLightsAreBlackUnlessTheyHaveABsdf) {
  const std::string light =
      R"(<emitter type="area" id="l"><rgb name="radiance" value="1,2,3"/></emitter>)";
  SceneDescription scene = read("<shape type=\"sphere\">" + light + "</shape>");
  EXPECT_EQ(scene.shapes[0].radiance->value, Color(1, 2, 3));
  EXPECT_EQ(std::get<DiffuseBsdf>(scene.bsdfs[scene.shapes[0].bsdf].model).reflectance.value,
            Color(0));
  scene = read(R"(<shape type="sphere"><ref id="l"/><bsdf type="plastic"/></shape>)" + light);
  EXPECT_EQ(scene.shapes[0].radiance->value, Color(1, 2, 3));
  EXPECT_TRUE(std::holds_alternative<PlasticBsdf>(scene.bsdfs[scene.shapes[0].bsdf].model));
  EXPECT_THAT(scene.emitters, IsEmpty());
}

TEST_F(MitsubaScene, MediaAbsorb) {
  const auto sigma = [&](const std::string& parameters, const std::string& version) {
    const SceneDescription scene =
        read("<shape type=\"sphere\"><medium type=\"homogeneous\" name=\"interior\">" + parameters +
                 "</medium><bsdf type=\"dielectric\"/></shape>",
             version);
    EXPECT_TRUE(scene.shapes[0].is_medium_boundary);
    EXPECT_EQ(scene.shapes[0].exterior, kNone);
    return scene.media.at(static_cast<size_t>(scene.shapes[0].interior)).sigma_a;
  };
  EXPECT_EQ(sigma(R"(<rgb name="sigmaA" value="1,2,3"/><float name="scale" value="2"/>)", "0.6.0"),
            Color(2, 4, 6));
  EXPECT_EQ(sigma(R"(<rgb name="sigma_t" value="4"/><rgb name="albedo" value="0"/>)", "3.0.0"),
            Color(4));
  EXPECT_EQ(sigma(R"(<rgb name="sigma_t" value="4"/><rgb name="albedo" value="0.25"/>)", "3.0.0"),
            Color(3));
}

// -- Textures

TEST_F(MitsubaScene, BitmapsHaveTheirTopRowAtVZero) {
  // The mesh keeps Mitsuba's v, so (0,0) must reach the top row, which is v = 1 of a BitmapTexture.
  expect_near(bitmap("").uv_transform * Vec3(0, 0, 1), Vec3(0, 1, 1));
  expect_near(bitmap("").uv_transform * Vec3(0.25f, 1, 1), Vec3(0.25f, 0, 1));
}

TEST_F(MitsubaScene, UvTransformsOfBothDialects) {
  expect_near(bitmap(R"(<float name="uvscale" value="10"/>)").uv_transform * Vec3(0.1f, 0.2f, 1),
              Vec3(1, -1, 1));
  expect_near(bitmap(R"(<float name="uscale" value="2"/><float name="vscale" value="3"/>
                        <float name="uoffset" value="0.5"/><float name="voffset" value="1"/>)")
                      .uv_transform *
                  Vec3(1, 1, 1),
              Vec3(2.5f, -3, 1));
  expect_near(
      bitmap(R"(<transform name="to_uv"><scale x="2" y="4"/><translate x="1"/></transform>)")
              .uv_transform *
          Vec3(1, 0.5f, 1),
      Vec3(3, -1, 1));
  expect_near(
      bitmap(R"(<transform name="to_uv"><matrix value="0 1 0.5  1 0 0  0 0 1"/></transform>)")
              .uv_transform *
          Vec3(0.25f, 0.75f, 1),
      Vec3(1.25f, 0.75f, 1));
}

TEST_F(MitsubaScene, WrapModesAndFilters) {
  const BitmapTexture both = bitmap(R"(<string name="wrap_mode" value="mirror"/>
                                       <string name="filter_type" value="nearest"/>)");
  EXPECT_EQ(both.wrap_u, WrapMode::Mirror);
  EXPECT_EQ(both.wrap_v, WrapMode::Mirror);
  EXPECT_EQ(both.filter, TextureFilter::Nearest);
  const BitmapTexture each = bitmap(R"(<string name="wrapModeU" value="clamp"/>
    <string name="wrapModeV" value="zero"/><string name="filterType" value="trilinear"/>)");
  EXPECT_EQ(each.wrap_u, WrapMode::Clamp);
  EXPECT_EQ(each.wrap_v, WrapMode::Zero);
  EXPECT_EQ(each.filter, TextureFilter::Bilinear);
}

TEST_F(MitsubaScene, RawTexturesAndChannels) {
  const float encoded = bitmap("").image->pixel(1, 0)[0];
  const float raw = bitmap(R"(<boolean name="raw" value="true"/>)").image->pixel(1, 0)[0];
  EXPECT_FLOAT_EQ(raw, 37.0f / 255);
  EXPECT_LT(encoded, raw);
  EXPECT_FLOAT_EQ(bitmap(R"(<float name="gamma" value="1"/>)").image->pixel(1, 0)[0], raw);
  const BitmapTexture green = bitmap(R"(<string name="channel" value="g"/>
                                        <boolean name="raw" value="true"/>)");
  EXPECT_EQ(green.image->channels(), 1);
  EXPECT_FLOAT_EQ(green.image->pixel(1, 0)[0], 91.0f / 255);
}

TEST_F(MitsubaScene, Checkerboard) {
  const SceneDescription scene =
      read(R"(<bsdf type="diffuse"><texture type="checkerboard" name="reflectance">
    <rgb name="color0" value="0.1"/><transform name="to_uv"><scale value="8"/></transform></texture></bsdf>)");
  const auto board = std::get<CheckerboardTexture>(scene.textures.at(0).model);
  EXPECT_EQ(board.color0.value, Color(0.1f));
  EXPECT_EQ(board.color1.value, Color(0.2f));
  expect_near(board.uv_transform * Vec3(0.5f, 0.25f, 1), Vec3(4, 2, 1));
}

// -- Emitters

TEST_F(MitsubaScene, PointSpotAndDirectional) {
  const auto point =
      emitter<PointEmitter>(R"(<emitter type="point"><rgb name="intensity" value="3"/>
    <transform name="to_world"><translate y="2"/></transform></emitter>)");
  expect_near(point.position, Vec3(0, 2, 0));
  EXPECT_EQ(point.intensity, Color(3));
  expect_near(emitter<PointEmitter>(R"(<emitter type="point">
    <point name="position" x="1" y="2" z="3"/></emitter>)",
                                    "0.6.0")
                  .position,
              Vec3(1, 2, 3));

  const auto spot =
      emitter<SpotEmitter>(R"(<emitter type="spot"><float name="cutoffAngle" value="40"/>
    </emitter>)",
                           "0.6.0");
  EXPECT_NEAR(spot.cutoff_angle * 180 / kPi, 40, 1e-4f);
  EXPECT_NEAR(spot.beam_width * 180 / kPi, 30, 1e-4f) << "three quarters by default";

  const auto sun = emitter<DirectionalEmitter>(R"(<emitter type="directional">
    <vector name="direction" x="0" y="-2" z="0"/><spectrum name="irradiance" value="5"/></emitter>)");
  expect_near(sun.direction, Vec3(0, -1, 0));
  EXPECT_EQ(sun.irradiance, Color(5));
}

TEST_F(MitsubaScene, ConstantEnvironmentAndProjector) {
  EXPECT_EQ(emitter<ConstantEmitter>(R"(<emitter type="constant"/>)").radiance, Color(1));
  const auto environment = emitter<EnvironmentEmitter>(R"(<emitter type="envmap">
    <string name="filename" value="map.png"/><float name="scale" value="2"/></emitter>)");
  EXPECT_EQ(environment.image->width(), 4);
  EXPECT_EQ(environment.scale, 2);
  const auto projector =
      emitter<ProjectorEmitter>(R"(<emitter type="projector"><float name="fov" value="30"/>
    <texture type="bitmap" name="irradiance"><string name="filename" value="map.png"/></texture></emitter>)");
  EXPECT_EQ(projector.image->height(), 4);
  EXPECT_NEAR(projector.fov_x * 180 / kPi, 30, 1e-4f);
}

TEST_F(MitsubaScene, ProjectorsHaveTheFieldOfViewOfSensors) {
  folder_.write("wide.hdr", sample_hdr());  // twice as wide as high
  const auto half_width = [&](const std::string& view) {
    const auto projector = emitter<ProjectorEmitter>(
        "<emitter type=\"projector\"><texture type=\"bitmap\" name=\"irradiance\">"
        "<string name=\"filename\" value=\"wide.hdr\"/></texture>" +
        view + "</emitter>");
    return std::tan(projector.fov_x / 2);
  };
  const float half = std::tan(20 * kPi / 180);
  const std::string fov = R"(<float name="fov" value="40"/><string name="fov_axis" value=)";
  EXPECT_NEAR(half_width(fov + "\"x\"/>"), half, 1e-5f);
  EXPECT_NEAR(half_width(fov + "\"y\"/>"), 2 * half, 1e-5f);
  EXPECT_NEAR(half_width(fov + "\"diagonal\"/>"), 2 * half / std::sqrt(5.0f), 1e-5f);
  const float diagonal = std::sqrt(36.0f * 36 + 24 * 24) / (2 * 35);
  EXPECT_NEAR(half_width(R"(<string name="focal_length" value="35mm"/>)"),
              2 * diagonal / std::sqrt(5.0f), 1e-5f);
}

TEST_F(MitsubaScene, ProjectorsOfAColourThrowOnePixel) {
  const auto projector = emitter<ProjectorEmitter>(
      R"(<emitter type="projector"><rgb name="irradiance" value="1, 2, 3"/></emitter>)");
  EXPECT_EQ(projector.image->color(0, 0), Color(1, 2, 3));
  EXPECT_EQ(emitter<ProjectorEmitter>(R"(<emitter type="projector"/>)").image->color(0, 0),
            Color(1));
  EXPECT_THAT(read(R"(<emitter type="projector"><texture type="checkerboard" name="irradiance"/>
                      </emitter>)")
                  .warnings,
              ::testing::ElementsAre(HasSubstr("only bitmaps")));
}

TEST_F(MitsubaScene, SunAndSky) {
  const auto both = emitter<SunSkyEmitter>(R"(<emitter type="sunsky">
    <vector name="sunDirection" x="1" y="1" z="0"/><float name="turbidity" value="4"/>
    <float name="scale" value="2"/><float name="sunScale" value="3"/></emitter>)",
                                           "0.6.0");
  EXPECT_TRUE(both.sun && both.sky);
  EXPECT_EQ(both.sun_scale, 6);
  EXPECT_EQ(both.sky_scale, 2);
  expect_near(both.sun_direction, glm::normalize(Vec3(1, 1, 0)));
  EXPECT_FALSE(emitter<SunSkyEmitter>(R"(<emitter type="sky"/>)", "0.6.0").sun);
  EXPECT_FALSE(emitter<SunSkyEmitter>(R"(<emitter type="sun"/>)", "0.6.0").sky);

  // Turned by 90° about x: the direction is given in the world.
  const auto turned =
      emitter<SunSkyEmitter>(R"(<emitter type="sky"><vector name="sunDirection" z="1"/>
    <transform name="toWorld"><rotate x="1" angle="90"/></transform></emitter>)",
                             "0.6.0");
  expect_near(turned.sun_direction, Vec3(0, 1, 0));
  // In version 3 up is +z.
  const auto up = emitter<SunSkyEmitter>(R"(<emitter type="sunsky">
    <vector name="sun_direction" value="0 0 1"/></emitter>)");
  expect_near(up.sun_direction, Vec3(0, 1, 0));
  expect_near(transform_vector(up.to_world, Vec3(0, 1, 0)), Vec3(0, 0, 1));
}

TEST_F(MitsubaScene, UnsupportedEmittersAreLeftOut) {
  const SceneDescription scene = read(R"(<emitter type="collimated"/>)");
  EXPECT_THAT(scene.emitters, IsEmpty());
  EXPECT_THAT(scene.warnings, ::testing::ElementsAre(HasSubstr("'collimated'")));
}

}  // namespace
}  // namespace guidelight::test
