// Pictures of real scenes by other renderers, against ours. They are noisy and so are ours, so
// blocks of 16x16 pixels are compared, with room for our own noise as the variance layer tells it.
// More samples per pixel, by GUIDELIGHT_REFERENCE_SCALE=8 for instance, make the comparison
// sharper.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "renderer/integrators/integrator.h"
#include "renderer/io/image_file.h"
#include "renderer/io/scene_file.h"

namespace guidelight {
namespace {

constexpr int kBlock = 16;

struct ReferenceCase {
  const char* name;
  const char* scene;
  const char* picture;
  uint32_t passes;
  int max_depth;          // what the picture was rendered with
  double tolerance;       // relative, of a block's mean
  double mean_tolerance;  // relative, of the whole picture's mean
  PixelRegion left_out = {};
};

std::string shared_path(const std::string& name) {
  return std::string(GUIDELIGHT_SHARED_SCENES) + "/" + name;
}

uint32_t pass_scale() {
  const char* text = std::getenv("GUIDELIGHT_REFERENCE_SCALE");
  return text ? std::max(1, std::atoi(text)) : 1;
}

Film render(const std::shared_ptr<const Scene>& scene, uint32_t passes, int max_depth) {
  const Camera& camera = scene->camera();
  Film film(camera.width(), camera.height(), camera.film().filter);
  const IntegratorInfo& path = find_integrator("path");
  const auto settings = path.make_settings(scene->description().hints);
  set_parameter(*settings, "max_depth", std::to_string(max_depth));
  const auto integrator = path.create(scene, *settings);
  Parallel parallel;
  for (uint32_t pass = 0; pass < passes; ++pass) {
    integrator->render_pass(pass, film, {1, &parallel, {}});
    film.finish_pass();
  }
  return film;
}

/// Sums over one block.
struct Block {
  double ours = 0;
  double reference = 0;
  double variance = 0;
  bool skip = false;  // an emitter is seen here, or it is left out
};

class Blocks {
 public:
  Blocks(const Film& film, const Image& reference, const Image& emitters,
         const PixelRegion& left_out)
      : columns_(reference.width() / kBlock), rows_(reference.height() / kBlock) {
    const Image ours = film.develop(Layer::Beauty);
    const Image variance = film.develop(Layer::Variance);
    blocks_.resize(static_cast<size_t>(columns_) * rows_);
    for (int y = 0; y < rows_ * kBlock; ++y) {
      for (int x = 0; x < columns_ * kBlock; ++x) {
        Block& block = blocks_[static_cast<size_t>(y / kBlock) * columns_ + x / kBlock];
        block.ours += luminance(ours.color(x, y));
        block.reference += luminance(reference.color(x, y));
        block.variance += *variance.pixel(x, y);
        block.skip |= luminance(emitters.color(x, y)) > 0;
        block.skip |= x >= left_out.x0 && x < left_out.x1 && y >= left_out.y0 && y < left_out.y1;
      }
    }
  }

  /// Blocks that differ by more than `tolerance` and `sigmas` standard errors together; those with
  /// a lamp are left out, and so are those that are a thousand times darker than the picture.
  size_t count_beyond(double tolerance, double sigmas) const {
    const double dark = 1e-3 * mean(&Block::reference);
    size_t count = 0;
    for (const Block& block : blocks_) {
      if (block.skip || block.reference < dark) continue;
      const double allowed = tolerance * block.reference + sigmas * std::sqrt(block.variance);
      count += std::abs(block.ours - block.reference) > allowed;
    }
    return count;
  }

  double mean(double Block::*value) const {
    double sum = 0;
    size_t count = 0;
    for (const Block& block : blocks_) {
      if (block.skip) continue;
      sum += block.*value;
      ++count;
    }
    return sum / static_cast<double>(std::max<size_t>(count, 1));
  }
  size_t size() const { return blocks_.size(); }

 private:
  int columns_;
  int rows_;
  std::vector<Block> blocks_;
};

class Reference : public ::testing::TestWithParam<ReferenceCase> {};

TEST_P(Reference, is_reproduced) {
  const ReferenceCase& test = GetParam();
  if (!std::filesystem::exists(shared_path(test.scene))) {
    GTEST_SKIP() << "the reference scenes are not beside this checkout";
  }
  const auto scene =
      Scene::build(std::make_shared<SceneDescription>(read_scene(shared_path(test.scene))));
  const Image reference = read_image(shared_path(test.picture));
  ASSERT_EQ(reference.width(), scene->camera().width());
  ASSERT_EQ(reference.height(), scene->camera().height());
  const Film film = render(scene, test.passes * pass_scale(), test.max_depth);
  const Image emitters = render(scene, 4, 1).develop(Layer::Beauty);
  const Blocks blocks(film, reference, emitters, test.left_out);

  const double bias = blocks.mean(&Block::ours) / blocks.mean(&Block::reference) - 1;
  EXPECT_LT(std::abs(bias), test.mean_tolerance) << "of the whole picture outside the lamps";
  // Three standard errors leave 0.3 % of the blocks outside; the distributions have longer tails.
  const size_t beyond = blocks.count_beyond(test.tolerance, 3);
  EXPECT_LE(beyond, blocks.size() / 100) << "of " << blocks.size() << " blocks";
  EXPECT_LE(blocks.count_beyond(4 * test.tolerance, 6), blocks.size() / 500) << "far off";
  RecordProperty("bias", std::to_string(bias));
  RecordProperty("blocks_beyond", static_cast<int>(beyond));
}

// The reference of veach-mis shows direct light only; that of coffee stops its paths at 11 segments
// or so, not at the 17 of the file (its mean lies between ours at 10, -0.5 %, and at 12, +0.4 %;
// the bottom of the glass pot shows it). Not here: the one-pixel environment map, whose reference
// is 0.460 times as bright everywhere as radiance × solid angle × cosine; path_tracer_test holds us
// to the latter.
INSTANTIATE_TEST_SUITE_P(
    Scenes, Reference,
    ::testing::Values(
        ReferenceCase{"ignis_plane", "ignis-evaluation/xml/plane.xml",
                      "ignis-evaluation/references/ref-plane-d6-4096.exr", 64, 6, 0.005, 0.001},
        ReferenceCase{"ignis_emissive_plane", "ignis-evaluation/xml/emissive-plane.xml",
                      "ignis-evaluation/references/ref-emissive-plane-4096.exr", 64, 4, 0.005,
                      0.002},
        ReferenceCase{"ignis_point", "ignis-evaluation/xml/point.xml",
                      "ignis-evaluation/references/ref-point-4096.exr", 64, 4, 0.005, 0.001},
        ReferenceCase{"cornell_box", "bitterli/cornell-box/scene_v3.xml",
                      "bitterli/cornell-box/TungstenRender.exr", 8, 65, 0.03, 0.005},
        ReferenceCase{"cornell_box_v06", "bitterli/cornell-box/scene_v0.6.xml",
                      "bitterli/cornell-box/TungstenRender.exr", 2, 65, 0.03, 0.005},
        ReferenceCase{"veach_mis", "bitterli/veach-mis/scene_v3.xml",
                      "bitterli/veach-mis/TungstenRender.exr", 8, 2, 0.03, 0.01},
        ReferenceCase{"coffee",
                      "bitterli/coffee/scene_v3.xml",
                      "bitterli/coffee/TungstenRender.exr",
                      8,
                      11,
                      0.03,
                      0.01,
                      {240, 576, 560, 768}},
        ReferenceCase{"staircase2", "bitterli/staircase2/scene_v0.6.xml",
                      "bitterli/staircase2/TungstenRender.exr", 8, 65, 0.03, 0.01}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace guidelight
