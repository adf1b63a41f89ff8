#include "tests/renderer/integrators/independent_runs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace guidelight::testing {
namespace {

using statistics::Moments;

std::unique_ptr<IntegratorSettings> settings_of(const Method& method, const Scene& scene) {
  auto settings = find_integrator(method.name).make_settings(scene.description().hints);
  for (size_t begin = 0; begin < method.parameters.size();) {
    const size_t equals = method.parameters.find('=', begin);
    const size_t end = std::min(method.parameters.find(',', equals), method.parameters.size());
    set_parameter(*settings, method.parameters.substr(begin, equals - begin),
                  method.parameters.substr(equals + 1, end - equals - 1));
    begin = end + 1;
  }
  return settings;
}

/// Means over blocks, and last over the picture.
std::vector<double> block_means(const Image& picture, int block) {
  const int columns = picture.width() / block;
  const int rows = picture.height() / block;
  std::vector<double> means(columns * rows + 1);
  for (int y = 0; y < rows * block; ++y) {
    for (int x = 0; x < columns * block; ++x) {
      means[y / block * columns + x / block] +=
          luminance(picture.color(x, y)) / static_cast<double>(block * block);
    }
  }
  for (int i = 0; i < columns * rows; ++i) means.back() += means[i] / (columns * rows);
  return means;
}

}  // namespace

std::vector<Moments> measure(std::shared_ptr<const Scene> scene, const Method& method,
                             const Runs& runs) {
  const auto settings = settings_of(method, *scene);
  const Camera& camera = scene->camera();
  std::vector<Moments> blocks;
  Parallel parallel(2);
  for (int run = 0; run < runs.count; ++run) {
    Film film(camera.width(), camera.height(), camera.film().filter);
    const auto integrator = find_integrator(method.name).create(scene, *settings);
    PassContext context{.seed = runs.first_seed + static_cast<uint64_t>(run),
                        .parallel = &parallel};
    for (uint32_t pass = 0; pass < method.passes; ++pass) {
      context.guides = runs.guides[pass % runs.guides.size()];
      integrator->render_pass(pass, film, context);
    }
    EXPECT_EQ(film.rejected(), 0u);
    const std::vector<double> means = block_means(film.develop(Layer::Beauty), runs.block);
    blocks.resize(means.size());
    for (size_t i = 0; i < means.size(); ++i) blocks[i].add(means[i]);
  }
  return blocks;
}

std::string describe(const Moments& found, const Moments& expected) {
  return fmt::format("{} +- {} against {} +- {}", found.mean(), found.standard_error(),
                     expected.mean(), expected.standard_error());
}

}  // namespace guidelight::testing
