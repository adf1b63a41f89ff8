#include <gmock/gmock.h>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const char* const kFilm = R"(<sensor type="perspective"><film type="hdrfilm">
  <integer name="width" value="$w"/><integer name="height" value="$h"/></film></sensor>)";

TEST(MitsubaDocument, DefaultsMayStandAnywhereAndDefinesWin) {
  const TemporaryFolder folder;
  const std::string body = std::string(kFilm) +
                           R"(<default name="w" value="10"/><default name="h" value="20"/>
                              <default name="w" value="99"/>)";
  EXPECT_EQ(read_mitsuba(folder, body).film.width, 10) << "the first default counts";
  EXPECT_EQ(read_mitsuba(folder, body, "3.0.0", {{"h", "7"}}).film.height, 7);
}

TEST(MitsubaDocument, DefaultsCountInsideOtherElements) {
  const TemporaryFolder folder;
  folder.write("more.xml",
               "<scene version=\"3.0.0\"><bsdf type=\"diffuse\">"
               "<default name=\"h\" value=\"4\"/></bsdf></scene>");
  const std::string body = std::string(kFilm) +
                           R"(<shape type="sphere"><bsdf type="diffuse">
                                <default name="w" value="3"/></bsdf></shape>
                              <default name="w" value="99"/><include filename="more.xml"/>)";
  const SceneDescription scene = read_mitsuba(folder, body);
  EXPECT_EQ(scene.film.width, 3);
  EXPECT_EQ(scene.film.height, 4);
}

TEST(MitsubaDocument, VariablesDoNotGrowWithoutEnd) {
  std::string body = R"(<default name="a0" value="0123456789"/>)";
  for (int i = 1; i < 9; ++i) {
    body += fmt::format(R"(<default name="a{}" value=")", i);
    for (int copy = 0; copy < 10; ++copy) body += fmt::format("$a{} ", i - 1);
    body += R"("/>)";
  }
  EXPECT_THAT(mitsuba_error(body),
              HasSubstr("scene.xml:2: the variables grow to more than 16 MiB"));
}

TEST(MitsubaDocument, IncludesDoNotGrowWithoutEnd) {
  const TemporaryFolder folder;
  folder.write("more.xml",
               "<scene version=\"3.0.0\"><!--" + std::string(4 << 20, '.') + "--></scene>");
  std::string body;
  for (int i = 0; i < 40; ++i) body += "<include filename=\"more.xml\"/>\n";
  try {
    read_mitsuba(folder, body);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("includes have more than 128 MiB"));
  }
}

TEST(MitsubaDocument, ShapesAreNotRepeatedWithoutEnd) {
  std::string body = R"(<shape type="sphere" id="s0"/>)";
  for (int i = 1; i < 40; ++i) {
    body += fmt::format(R"(<shape type="merge" id="s{0}"><ref id="s{1}"/><ref id="s{1}"/></shape>)",
                        i, i - 1);
  }
  EXPECT_THAT(mitsuba_error(body), HasSubstr("repeat shapes more than 100000 times"));
}

TEST(MitsubaDocument, NumbersBeyondDoublesAreNoZero) {
  const auto with_radius = [](const std::string& text) {
    return R"(<shape type="sphere"><float name="radius" value=")" + text + R"("/></shape>)";
  };
  EXPECT_THAT(mitsuba_error(with_radius("1e400")), HasSubstr("'1e400'"));
  EXPECT_THAT(mitsuba_error(with_radius("-1e400")), HasSubstr("is not a finite number"));
  const SceneDescription scene = read_mitsuba(
      R"(<emitter type="point"><point name="position" x="1e-400" y="1" z="2"/></emitter>)");
  EXPECT_EQ(std::get<PointEmitter>(scene.emitters.at(0).model).position, Vec3(0, 1, 2));
}

TEST(MitsubaDocument, TheLongestVariableIsReplaced) {
  const SceneDescription scene = read_mitsuba(R"(
    <default name="r" value="1"/><default name="res" value="12"/><default name="w" value="$res0"/>
    <default name="h" value="$r$r"/>)" + std::string(kFilm));
  EXPECT_EQ(scene.film.width, 120);
  EXPECT_EQ(scene.film.height, 11);
}

TEST(MitsubaDocument, UndefinedVariablesAreErrorsWithARemedy) {
  EXPECT_THAT(mitsuba_error(kFilm), ::testing::AllOf(HasSubstr(":3:"), HasSubstr("-D w=VALUE")));
}

TEST(MitsubaDocument, IncludesAndPathsOfIncludedFiles) {
  const TemporaryFolder folder;
  folder.write("parts/inner.xml",
               R"(<scene version="3.0.0"><bsdf type="plastic" id="p"/>
                  <shape type="obj"><string name="filename" value="in parts.OBJ"/></shape>
                  <shape type="obj"><string name="filename" value="main.obj"/></shape></scene>)");
  folder.write("parts/in parts.OBJ", sample_obj());
  folder.write("main.obj", sample_obj());
  const SceneDescription scene = read_mitsuba(
      folder, R"(<shape type="sphere"><ref id="p"/></shape><include filename="parts/inner.xml"/>)");
  EXPECT_EQ(scene.shapes.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<PlasticBsdf>(scene.bsdfs[scene.shapes[0].bsdf].model));
}

TEST(MitsubaDocument, CyclicIncludesAndReferencesAreErrors) {
  const TemporaryFolder folder;
  folder.write("b.xml", R"(<scene version="3.0.0"><include filename="scene.xml"/></scene>)");
  try {
    read_mitsuba(folder, R"(<include filename="b.xml"/>)");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("includes itself"));
  }
  EXPECT_THAT(mitsuba_error(R"(<bsdf type="twosided" id="a"><ref id="b"/></bsdf>
                               <bsdf type="twosided" id="b"><ref id="a"/></bsdf>)"),
              HasSubstr("refers to itself"));
}

TEST(MitsubaDocument, ReferencesAndAliasesMayStandBeforeTheirTargets) {
  const SceneDescription scene = read_mitsuba(R"(
    <shape type="sphere"><ref id="other"/></shape>
    <alias id="late" as="other"/><bsdf type="plastic" id="late"/>)");
  EXPECT_EQ(scene.bsdfs[scene.shapes[0].bsdf].name, "late");
  EXPECT_THAT(mitsuba_error(R"(<shape type="sphere"><ref id="nothing"/></shape>)"),
              HasSubstr("nothing has the id 'nothing'"));
}

TEST(MitsubaDocument, MalformedXmlNamesTheLine) {
  EXPECT_THAT(mitsuba_error("<shape type=\"sphere\">\n\n<oops"), HasSubstr("scene.xml:"));
  EXPECT_THAT(mitsuba_error("<shape></bsdf>"), HasSubstr("malformed"));
  const TemporaryFolder folder;
  EXPECT_THROW(read_scene(folder.write("a.xml", "<html></html>")), Error);
  EXPECT_THROW(read_scene(folder.write("b.xml", "")), Error);
  EXPECT_THROW(read_scene(folder / "missing.xml"), Error);
}

TEST(MitsubaDocument, DeepNestingIsAnError) {
  std::string body;
  for (int i = 0; i < 100000; ++i) body += "<bsdf type=\"twosided\">";
  for (int i = 0; i < 100000; ++i) body += "</bsdf>";
  EXPECT_NE(mitsuba_error(body), "");
}

TEST(MitsubaDocument, EachUnsupportedThingWarnsOnceWithItsLine) {
  const SceneDescription scene = read_mitsuba(R"(<sensor type="perspective"/>
    <bsdf type="hair" id="a"/>
    <bsdf type="hair" id="b"/>
    <shape type="sphere"><float name="wobble" value="1"/><ref id="a"/></shape>
    <shape type="sphere"><float name="wobble" value="2"/><ref id="b"/></shape>
    <frobnicate/>)");
  EXPECT_THAT(scene.warnings, ::testing::UnorderedElementsAre(
                                  ::testing::AllOf(HasSubstr(":3:"), HasSubstr("'hair'"),
                                                   HasSubstr("grey diffuse")),
                                  ::testing::AllOf(HasSubstr(":5:"), HasSubstr("'wobble'")),
                                  ::testing::AllOf(HasSubstr(":7:"), HasSubstr("<frobnicate>"))));
  EXPECT_EQ(scene.shapes.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<DiffuseBsdf>(scene.bsdfs[0].model));
}

TEST(MitsubaDocument, WrongValuesAreErrorsWithTheirLine) {
  for (const std::string value : {"abc", "nan", "inf", "1e60", "", "1 2"}) {
    EXPECT_THAT(mitsuba_error("<shape type=\"sphere\">\n<float name=\"radius\" value=\"" + value +
                              "\"/></shape>"),
                HasSubstr("scene.xml:3:"))
        << value;
  }
}

}  // namespace
}  // namespace guidelight::test
