#include "renderer/io/guide_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<GuidePath> sample_list() {
  GuidePath first;
  first.name = "through the door \"é\"";
  first.color = {0.1f, 0.25f, 1};
  first.weight = 0.3f;
  first.disc_radius = 1.0f / 3;
  first.vertices = {{{1e-7f, -2.5f, 1e20f}, PathEvent::Scatter, 0.01f},
                    {{1, 2, 3}, PathEvent::Reflect},
                    {{0.1f, 0.2f, 0.3f}, PathEvent::Refract},
                    {{-7, 8, 9.125f}, PathEvent::Scatter, 0.5f * kPi}};
  GuidePath second;
  second.enabled = false;
  second.vertices = {{{0, 0, 0}}, {{0, 1, 0}}};
  return {first, second};
}

TEST(GuideFile, IsReadBackToTheSameGuides) {
  const TemporaryFolder folder;
  const auto guides = sample_list();
  write_guides(folder / "a.guides.json", guides);
  const auto again = read_guides(folder / "a.guides.json");
  ASSERT_EQ(again.size(), guides.size());
  for (size_t i = 0; i < guides.size(); ++i) {
    EXPECT_EQ(again[i].name, guides[i].name);
    EXPECT_EQ(again[i].color, guides[i].color);
    EXPECT_EQ(again[i].enabled, guides[i].enabled);
    EXPECT_EQ(again[i].weight, guides[i].weight);
    EXPECT_EQ(again[i].disc_radius, guides[i].disc_radius);
    ASSERT_EQ(again[i].vertices.size(), guides[i].vertices.size());
    for (size_t k = 0; k < guides[i].vertices.size(); ++k) {
      EXPECT_EQ(again[i].vertices[k].position, guides[i].vertices[k].position);
      EXPECT_EQ(again[i].vertices[k].event, guides[i].vertices[k].event);
      EXPECT_EQ(again[i].vertices[k].cone, guides[i].vertices[k].cone);
    }
  }
}

TEST(GuideFile, LiesBesideTheScene) {
  EXPECT_EQ(guide_file_beside("/a/b.c/scene.xml"), "/a/b.c/scene.guides.json");
  EXPECT_EQ(guide_file_beside("ball.gltf"), "ball.guides.json");
}

TEST(GuideFile, WhatIsLeftOutHasADefault) {
  const auto guides = parse_guides(
      R"({"guidelight_guides":1,"guides":[{"vertices":[{"position":[1,2,3]},{"position":[1,2,4]}]}]})",
      "test");
  ASSERT_EQ(guides.size(), 1u);
  EXPECT_TRUE(guides[0].enabled);
  EXPECT_EQ(guides[0].weight, 1);
  ASSERT_EQ(guides[0].vertices.size(), 2u);
  EXPECT_EQ(guides[0].vertices[0].cone, kDefaultGuideCone);
  EXPECT_EQ(guides[0].vertices[0].event, PathEvent::Scatter);
}

/// The message of the Error for these members of the first vertex of the only guide.
std::string vertex_error(const std::string& vertex) {
  try {
    parse_guides(R"({"guidelight_guides":1,"guides":[{"vertices":[)" + vertex + "]}]}", "x.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string guides_error(const std::string& text) {
  try {
    parse_guides(text, "x.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(GuideFile, ErrorsSayWhereAndWhat) {
  EXPECT_THAT(vertex_error("{}"), HasSubstr("x.json: guide 0, vertex 0: 'position' is not there"));
  EXPECT_THAT(vertex_error("7"), HasSubstr("not an object"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2]})"), HasSubstr("three numbers"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,1e99]})"), HasSubstr("range of floats"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,null]})"), HasSubstr("range of floats"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,3],"cone":0})"), HasSubstr("above 0"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,3],"cone":91})"), HasSubstr("above 0"));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,3],"event":"bend"})"),
              AllOf(HasSubstr("'bend'"), HasSubstr("refract")));
  EXPECT_THAT(vertex_error(R"({"position":[1,2,3],"cones":5})"), HasSubstr("'cones'"));
  EXPECT_THAT(guides_error("{"), HasSubstr("x.json: this is not JSON"));
  EXPECT_THAT(guides_error("[]"), HasSubstr("not an object"));
  EXPECT_THAT(guides_error("{}"), HasSubstr("guidelight_guides"));
  EXPECT_THAT(guides_error(R"({"guidelight_guides":2,"guides":[]})"), HasSubstr("is not 1"));
  EXPECT_THAT(guides_error(R"({"guidelight_guides":1})"), HasSubstr("'guides'"));
  EXPECT_THAT(guides_error(R"({"guidelight_guides":1,"guides":[{"weight":-1,"vertices":[]}]})"),
              HasSubstr("negative"));
  EXPECT_THROW(read_guides("/nowhere/a.guides.json"), Error);
}

TEST(GuideFile, NamesMustBeText) {
  GuidePath guide;
  guide.name = "\xff";
  EXPECT_THROW(guides_text({guide}), Error);
}

}  // namespace
}  // namespace guidelight::test
