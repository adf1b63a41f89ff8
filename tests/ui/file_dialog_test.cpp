#include "ui/panels/file_dialog.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

TEST(FileDialog, KnowsScenesByTheirNames) {
  const auto shows = open_scene_request().shows;
  EXPECT_TRUE(shows("/a/scene.xml"));
  EXPECT_TRUE(shows("Duck.GLB"));
  EXPECT_TRUE(shows("a.gltf"));
  EXPECT_FALSE(shows("a.obj"));
  EXPECT_FALSE(shows("xml"));
  EXPECT_FALSE(shows("a.checkpoint"));
}

TEST(FileDialog, KnowsCheckpointsByTheirNames) {
  for (const FileRequest& request : {save_checkpoint_request(), resume_checkpoint_request()}) {
    EXPECT_TRUE(request.shows("/a/room.checkpoint"));
    EXPECT_FALSE(request.shows("a.xml"));
  }
}

}  // namespace
}  // namespace guidelight
