#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "renderer/io/checkpoint_file.h"
#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/scene_loader.h"
#include "ui/session_metadata.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Opens what a file holds: a scene, or the session that a picture or a checkpoint was saved in,
/// with its scene if that is not open. The newest request wins. Large files are read in the
/// background; what goes wrong is said in the document's messages and changes nothing else. Guides
/// that a session replaces are kept in a file beside the scene.
class Opener {
 public:
  struct Listener {                        // called on the UI thread
    std::function<void()> scene_opened;    // the document has another scene
    std::function<void()> scene_reloaded;  // or the same, read again
    std::function<void(const std::string& path)> take_reference;
  };
  Opener(Document& document, std::shared_ptr<UiQueue> queue, Listener listener);

  /// By the content of the file; a picture without a session is taken as the reference. `defines`
  /// override <default> variables of an XML scene.
  void open(const std::string& path, const std::map<std::string, std::string>& defines = {});
  /// Goes on with a checkpoint.
  void resume(const std::string& path);
  /// Reads the open scene again; the camera and what the person has set stay as they are.
  void reload();

  /// What is being read; empty if nothing is.
  const std::string& loading() const { return reading_.empty() ? loader_.loading() : reading_; }
  /// As SceneLoader::threads_running.
  bool threads_running() const { return loader_.threads_running(); }

 private:
  struct Session {
    RememberedSession settings;
    std::optional<Checkpoint> checkpoint;
    std::string path;  // of the picture or the checkpoint
  };

  uint64_t begin_request();
  /// Reads something in the background and takes it on the UI thread, unless something else has
  /// been asked for by then.
  template <typename Read, typename Take>
  void read(const std::string& path, Read read_file, Take take);
  void open_picture(const std::string& path);
  void take_as_reference(const std::string& path);
  void open_session(const std::string& path, const Metadata& metadata,
                    std::optional<Checkpoint> checkpoint);
  void take_scene(OpenedScene opened);
  static void check(const Session& session, const Scene& scene);
  void restore(Session session);
  void set_aside(const GuideList& guides);

  Document& document_;
  std::shared_ptr<UiQueue> queue_;
  Listener listener_;
  SceneLoader loader_;
  std::optional<Session> session_;  // to restore once its scene is there
  uint64_t newest_request_ = 0;
  bool reloading_ = false;   // the open scene
  std::string reading_;      // checkpoint or picture
  BackgroundThread reader_;  // writes, too; last: it finishes before the rest goes
};

}  // namespace guidelight
