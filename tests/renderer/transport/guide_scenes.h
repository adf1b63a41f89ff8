#pragma once

#include <functional>
#include <vector>

#include "renderer/transport/guide_path.h"
#include "tests/renderer/test_scenes.h"

/// A floor and a wall with a glass ball, lit by one light of every kind, and guides for each.
namespace guidelight::guide_test {

struct LitScene {
  const char* name;
  std::function<void(SceneDescription&)> add_light;
  Vec3 start;  // a point on the light, or on the way from it to kTarget and kBall

  SceneDescription describe(int side = 16) const;
  std::shared_ptr<const Scene> build() const { return testing::build(describe()); }
};

const std::vector<LitScene>& lit_scenes();
inline const auto kSceneName = [](const auto& test) { return test.param.name; };

inline const Vec3 kTarget(-0.4f, -1, 0.3f);  // on the floor
inline const Vec3 kBall(0.3f, -0.45f, -0.3f);

/// To the floor; over the wall to the floor; through the ball; from the light's rim, so that half
/// of the disc is beside it.
std::vector<GuidePath> guides_for(const Scene& scene, const LitScene& lit);

/// Many guides from random places of the light (the same for points) in random directions.
std::vector<GuidePath> random_guides(const Scene& scene, const LitScene& lit, int count);

}  // namespace guidelight::guide_test
