#include "renderer/session/checkpoints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "renderer/error.h"
#include "renderer/session/open_scene.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class CheckpointsTest : public ::testing::Test {
 protected:
  static RenderJob room_job(int width = 8, int height = 6) {
    RenderJob job;
    job.scene = testing::build(testing::room(width, height));
    job.seed = 3;
    return job;
  }

  /// Saves a job after some passes and reads it again.
  Checkpoint saved(const RenderJob& job, uint32_t passes = 4) {
    const Film film = testing::render(job.scene, passes);
    save_to(path_, job)({std::make_shared<Film>(film), passes, 1.5});
    return read_checkpoint(path_);
  }

  std::string refusal(const Checkpoint& checkpoint, const RenderJob& job) {
    try {
      resume_from(checkpoint, job, path_);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  ~CheckpointsTest() override { std::filesystem::remove(path_); }

  // Tests may run beside each other.
  const std::string path_ = ::testing::TempDir() + "guidelight_checkpoints_" +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                            ".checkpoint";
};

TEST_F(CheckpointsTest, hand_the_progress_on) {
  const RenderJob job = room_job();
  const RenderProgress progress = resume_from(saved(job), job, path_);
  EXPECT_EQ(progress.next_pass, 4u);
  EXPECT_EQ(progress.seconds, 1.5);
  EXPECT_EQ(progress.film->total_samples(), 4u * 8 * 6);
}

TEST_F(CheckpointsTest, of_another_render_are_refused_with_what_differs) {
  const Checkpoint checkpoint = saved(room_job());
  RenderJob job = room_job();
  job.seed = 4;
  EXPECT_THAT(refusal(checkpoint, job), AllOf(HasSubstr(path_), HasSubstr("seed 3 and not 4")));
  EXPECT_THAT(refusal(checkpoint, room_job(8, 5)), HasSubstr("size 8x6 and not 8x5"));

  job = room_job();
  std::shared_ptr<IntegratorSettings> settings =
      find_integrator("path").make_settings(job.scene->description().hints);
  set_parameter(*settings, "max_depth", "5");
  job.settings = settings;
  EXPECT_THAT(refusal(checkpoint, job), HasSubstr("with max_depth -1 and not 5"));

  job = room_job();
  job.region = PixelRegion{0, 0, 4, 4};
  EXPECT_THAT(refusal(checkpoint, job), HasSubstr("region nothing and not 0,0,4,4"));

  SceneDescription room = testing::room(8, 6);
  room.defines["detail"] = "2";
  job.scene = testing::build(std::move(room));
  EXPECT_THAT(refusal(checkpoint, job), HasSubstr("define.detail nothing and not 2"));
}

/// What counts is the version that was rendered, not what the file has become since.
TEST_F(CheckpointsTest, of_a_scene_that_has_changed_are_refused) {
  const std::string scene_path = ::testing::TempDir() + "guidelight_checkpoints_test.xml";
  const auto job_of_version = [&](const std::string& radiance) {
    std::ofstream(scene_path) << "<scene version='3.0.0'><sensor type='perspective'/><emitter "
                                 "type='constant'><rgb name='radiance' value='"
                              << radiance << "'/></emitter></scene>";
    const auto description = open_scene(scene_path);
    description->film.width = description->film.height = 8;
    RenderJob job;
    job.scene = Scene::build(description);
    return job;
  };
  const RenderJob first = job_of_version("0.1");
  const Checkpoint checkpoint = saved(first);
  const RenderJob second = job_of_version("0.2");
  EXPECT_EQ(refusal(checkpoint, first), "");
  EXPECT_THAT(refusal(checkpoint, second), HasSubstr(scene_path + " has changed"));
  EXPECT_EQ(refusal(saved(first), first), "") << "saved after the file has changed";
  std::filesystem::remove(scene_path);
}

TEST_F(CheckpointsTest, are_known_by_their_content) {
  saved(room_job());
  EXPECT_TRUE(is_checkpoint(path_));
  std::ofstream(path_) << "<scene/>";
  EXPECT_FALSE(is_checkpoint(path_));
  EXPECT_FALSE(is_checkpoint("/no/such/file"));
}

}  // namespace
}  // namespace guidelight
