#include <gmock/gmock.h>

#include "tests/renderer/io/io_test_files.h"

namespace guidelight::test {
namespace {

using ::testing::HasSubstr;

Mat4 camera_transform(const std::string& parts, const std::string& name = "to_world") {
  return read_mitsuba("<sensor type=\"perspective\"><transform name=\"" + name + "\">" + parts +
                      "</transform></sensor>")
      .camera.to_world;
}

void expect_close(Vec3 actual, Vec3 expected) {
  EXPECT_NEAR(glm::length(actual - expected), 0, 1e-5f)
      << actual.x << ' ' << actual.y << ' ' << actual.z;
}

TEST(MitsubaTransform, PartsApplyInTheOrderTheyAreWritten) {
  const Mat4 m = camera_transform(R"(<scale value="2"/><rotate z="1" angle="90"/>
                                     <translate x="5" y="6"/>)");
  expect_close(transform_point(m, Vec3(1, 0, 0)), Vec3(5, 8, 0));
}

TEST(MitsubaTransform, VectorsInAllSpellings) {
  expect_close(transform_point(camera_transform(R"(<translate value="1, 2 3"/>)"), Vec3(0)),
               Vec3(1, 2, 3));
  expect_close(transform_vector(camera_transform(R"(<scale x="2" z="3"/>)"), Vec3(1)),
               Vec3(2, 1, 3));
  expect_close(
      transform_vector(camera_transform(R"(<rotate value="0,1,0" angle="90"/>)"), Vec3(0, 0, 1)),
      Vec3(1, 0, 0));
}

TEST(MitsubaTransform, MatricesAreRowsOfFourOrThree) {
  expect_close(
      transform_point(camera_transform(R"(<matrix value="1 0 0 7  0 0 -1 8  0 1 0 9  0 0 0 1"/>)"),
                      Vec3(1, 2, 3)),
      Vec3(8, 5, 11));
  expect_close(
      transform_vector(camera_transform(R"(<matrix value="0,1,0, 1,0,0, 0,0,2"/>)"), Vec3(1, 2, 3)),
      Vec3(2, 1, 6));
}

TEST(MitsubaTransform, LookAtHasXToTheLeftInBothSpellings) {
  for (const std::string tag : {"lookat", "lookAt"}) {
    const Mat4 m =
        camera_transform("<" + tag + R"( origin="0,0,5" target="0 0 0" up="0, 1, 0"/>)", "toWorld");
    expect_close(transform_vector(m, Vec3(0, 0, 1)), Vec3(0, 0, -1));
    expect_close(transform_vector(m, Vec3(0, 1, 0)), Vec3(0, 1, 0));
    expect_close(transform_vector(m, Vec3(1, 0, 0)), Vec3(-1, 0, 0));  // left, looking along -z
  }
}

TEST(MitsubaTransform, DamagedPartsAreErrors) {
  const auto error = [](const std::string& part) {
    return mitsuba_error("<sensor type=\"perspective\"><transform name=\"to_world\">" + part +
                         "</transform></sensor>");
  };
  EXPECT_THAT(error(R"(<lookat origin="1,1,1" target="1,1,1"/>)"), HasSubstr("coincide"));
  EXPECT_THAT(error(R"(<matrix value="1 2 3"/>)"), HasSubstr("3 numbers"));
  EXPECT_THAT(error(R"(<rotate angle="3"/>)"), HasSubstr("no axis"));
  EXPECT_THAT(error(R"(<translate x="nan"/>)"), HasSubstr("finite"));
  EXPECT_THAT(error(R"(<shear x="1"/>)"), HasSubstr("not part of a transform"));
  EXPECT_THAT(error(R"(<scale value="0"/>)"), HasSubstr("singular"));
}

TEST(MitsubaSensor, EveryFovAxisInBothDialects) {
  const std::map<std::string, FovAxis> axes = {{"x", FovAxis::X},
                                               {"y", FovAxis::Y},
                                               {"diagonal", FovAxis::Diagonal},
                                               {"smaller", FovAxis::Smaller},
                                               {"larger", FovAxis::Larger}};
  for (const auto& [name, axis] : axes) {
    for (const std::string parameter : {"fovAxis", "fov_axis"}) {
      const SceneDescription scene = read_mitsuba(
          "<sensor type=\"perspective\"><float name=\"fov\" value=\"33\"/><string name=\"" +
          parameter + "\" value=\"" + name + "\"/></sensor>");
      EXPECT_EQ(scene.camera.fov_axis, axis);
      EXPECT_EQ(scene.camera.fov, 33);
      EXPECT_THAT(scene.warnings, ::testing::IsEmpty());
    }
  }
}

TEST(MitsubaSensor, FocalLengthIsOfTheDiagonal) {
  const SceneDescription scene = read_mitsuba(
      R"(<sensor type="perspective"><string name="focalLength" value="35mm"/></sensor>)");
  EXPECT_EQ(scene.camera.fov_axis, FovAxis::Diagonal);
  EXPECT_NEAR(scene.camera.fov, 63.44f, 0.01f);  // a 35 mm lens on 36 × 24 mm
}

TEST(MitsubaSensor, ThinLensAndOrthographic) {
  const SceneDescription lens =
      read_mitsuba(R"(<sensor type="thinlens"><float name="fov" value="30"/>
    <float name="apertureRadius" value="0.2"/><float name="focusDistance" value="7"/>
    <float name="nearClip" value="0.5"/><float name="farClip" value="50"/></sensor>)",
                   "0.6.0");
  EXPECT_EQ(lens.camera.model, CameraModel::ThinLens);
  EXPECT_FLOAT_EQ(lens.camera.aperture_radius, 0.2f);
  EXPECT_FLOAT_EQ(lens.camera.focus_distance, 7);
  EXPECT_FLOAT_EQ(lens.camera.near_clip, 0.5f);
  EXPECT_EQ(read_mitsuba(R"(<sensor type="orthographic"/>)").camera.model,
            CameraModel::Orthographic);
}

TEST(MitsubaSensor, FilmCropFilterAndSamples) {
  const SceneDescription scene = read_mitsuba(R"(<sensor type="perspective">
    <sampler type="independent"><integer name="sample_count" value="64"/></sampler>
    <film type="hdrfilm"><integer name="width" value="100"/><integer name="height" value="50"/>
      <integer name="crop_offset_x" value="10"/><integer name="crop_offset_y" value="5"/>
      <integer name="crop_width" value="20"/><integer name="crop_height" value="30"/>
      <string name="pixel_format" value="rgb"/>
      <rfilter type="mitchell"><float name="B" value="0.1"/><float name="C" value="0.45"/></rfilter>
    </film></sensor>)");
  EXPECT_EQ(scene.hints.samples_per_pixel, 64);
  EXPECT_EQ(scene.film.crop_x, 10);
  EXPECT_EQ(scene.film.crop_height, 30);
  EXPECT_EQ(scene.film.filter.kind, FilterKind::Mitchell);
  EXPECT_FLOAT_EQ(scene.film.filter.b, 0.1f);
  EXPECT_FLOAT_EQ(scene.film.filter.c, 0.45f);
  EXPECT_THAT(scene.warnings, ::testing::IsEmpty());
}

TEST(MitsubaSensor, CropWindowsDefaultToTheFilmAndMustBeInside) {
  const auto film = [](const std::string& crop) {
    return "<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" "
           "value=\"100\"/>\n<integer name=\"height\" value=\"50\"/>" +
           crop + "</film></sensor>";
  };
  const SceneDescription columns = read_mitsuba(film(R"(<integer name="crop_offset_x" value="10"/>
                           <integer name="crop_width" value="20"/>)"));
  EXPECT_EQ(columns.film.crop_width, 20);
  EXPECT_EQ(columns.film.crop_height, 50);
  const SceneDescription rows = read_mitsuba(film(R"(<integer name="crop_height" value="20"/>)"));
  EXPECT_EQ(rows.film.crop_width, 100);
  EXPECT_EQ(rows.film.crop_height, 20);
  EXPECT_EQ(read_mitsuba(film("")).film.crop_width, 0) << "no window";
  for (const std::string crop :
       {R"(<integer name="crop_offset_y" value="1"/>)", R"(<integer name="crop_width" value="0"/>)",
        R"(<integer name="crop_width" value="101"/>)",
        R"(<integer name="crop_offset_x" value="-1"/><integer name="crop_width" value="9"/>)"}) {
    EXPECT_THAT(mitsuba_error(film(crop)), ::testing::ContainsRegex("scene.xml:2: the crop window"))
        << crop;
  }
}

TEST(MitsubaSensor, EveryReconstructionFilter) {
  const std::map<std::string, FilterKind> kinds = {{"box", FilterKind::Box},
                                                   {"tent", FilterKind::Tent},
                                                   {"gaussian", FilterKind::Gaussian},
                                                   {"mitchell", FilterKind::Mitchell},
                                                   {"catmullrom", FilterKind::Mitchell}};
  for (const auto& [name, kind] : kinds) {
    const SceneDescription scene =
        read_mitsuba("<sensor type=\"perspective\"><film type=\"ldrfilm\"><rfilter type=\"" + name +
                     "\"/></film></sensor>");
    EXPECT_EQ(scene.film.filter.kind, kind) << name;
  }
}

TEST(MitsubaSensor, ImpossibleFilmsAndViewsAreErrors) {
  const auto film = [](const std::string& w, const std::string& h) {
    return mitsuba_error(
        "<sensor type=\"perspective\"><film type=\"hdrfilm\"><integer name=\"width\" value=\"" + w +
        "\"/><integer name=\"height\" value=\"" + h + "\"/></film></sensor>");
  };
  for (const auto& [w, h] : std::vector<std::pair<std::string, std::string>>{
           {"0", "5"}, {"5", "-3"}, {"65537", "65537"}, {"99999999999", "1"}, {"60000", "60000"}}) {
    EXPECT_THAT(film(w, h), HasSubstr("cannot be rendered")) << w;
  }
  EXPECT_THAT(
      mitsuba_error(R"(<sensor type="perspective"><float name="fov" value="180"/></sensor>)"),
      HasSubstr("field of view"));
  EXPECT_THAT(mitsuba_error(R"(<sensor type="perspective"><float name="near_clip" value="5"/>
                               <float name="far_clip" value="1"/></sensor>)"),
              HasSubstr("clip distances"));
}

TEST(MitsubaSensor, WithoutOneTheWholeSceneIsSeen) {
  const SceneDescription scene = read_mitsuba(R"(<shape type="sphere">
    <point name="center" x="10" y="20" z="30"/><float name="radius" value="2"/></shape>)");
  EXPECT_THAT(scene.warnings, ::testing::ElementsAre(HasSubstr("no sensor")));
  const Vec3 eye(scene.camera.to_world[3]);
  const Vec3 forward(scene.camera.to_world[2]);
  expect_close(glm::normalize(Vec3(10, 20, 30) - eye), forward);
}

TEST(MitsubaIntegrator, HintsOfBothDialects) {
  const SceneDescription old = read_mitsuba(R"(<integrator type="sppm">
    <integer name="maxDepth" value="6"/><integer name="rrDepth" value="9"/></integrator>)",
                                            "0.6.0");
  EXPECT_EQ(old.hints.integrator, "sppm");
  EXPECT_EQ(old.hints.max_depth, 6);
  EXPECT_EQ(old.hints.russian_roulette_depth, 9);
  const SceneDescription nested = read_mitsuba(R"(<integrator type="aov">
    <integrator type="path"><integer name="max_depth" value="-1"/></integrator></integrator>)");
  EXPECT_EQ(nested.hints.integrator, "path");
  EXPECT_EQ(nested.hints.max_depth, -1);
  EXPECT_FALSE(read_mitsuba(R"(<integrator type="path"/>)").hints.max_depth.has_value());
}

}  // namespace
}  // namespace guidelight::test
