#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "renderer/error.h"
#include "renderer/integrators/integrator.h"

namespace guidelight {
namespace {

std::string document(const std::string& name) {
  std::ifstream file(std::string(GUIDELIGHT_SOURCE_DIR "/docs/") + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Registry, lists_every_integrator_once_and_finds_it_by_name) {
  std::set<std::string> names;
  for (const IntegratorInfo& info : integrators()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(&find_integrator(info.name), &info);
    EXPECT_FALSE(info.label.empty());
    EXPECT_FALSE(info.summary.empty());
  }
  EXPECT_THAT(names,
              ::testing::IsSupersetOf({"path", "light", "bdpt", "pppm", "bpm", "bdpm", "vcm", "ppm",
                                       "sppm", "photon_map", "mlt", "pssmlt", "mps"}));
  EXPECT_THROW(find_integrator("radiosity"), Error);
}

TEST(Registry, parameters_are_described_and_documented) {
  const std::string text =
      document("integrators.md") + document("photon-mapping.md") + document("metropolis.md");
  for (const IntegratorInfo& info : integrators()) {
    EXPECT_THAT(text, ::testing::HasSubstr("`" + info.name + "`"));
    const auto settings = info.make_settings({});
    std::set<std::string> keys;
    for (const Parameter& parameter : settings->parameters()) {
      EXPECT_TRUE(keys.insert(parameter.key).second) << info.name << "." << parameter.key;
      EXPECT_FALSE(parameter.label.empty()) << parameter.key;
      EXPECT_FALSE(parameter.help.empty()) << parameter.key;
      EXPECT_THAT(text, ::testing::HasSubstr("`" + parameter.key + "`")) << info.name;
      // What is shown can be typed back.
      EXPECT_NO_THROW(set_parameter(*settings, parameter.key, parameter_text(parameter)))
          << info.name << "." << parameter.key;
    }
  }
}

}  // namespace
}  // namespace guidelight
