#include "ui/opener.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "renderer/error.h"
#include "renderer/io/guide_file.h"
#include "renderer/session/picture_export.h"
#include "ui/numbered_files.h"

namespace guidelight {

Opener::Opener(Document& document, std::shared_ptr<UiQueue> queue, Listener listener)
    : document_(document),
      queue_(std::move(queue)),
      listener_(std::move(listener)),
      loader_(
          queue_, [this](OpenedScene opened) { take_scene(std::move(opened)); },
          [this](const std::string& reason) {
            session_.reset();
            document_.messages().error(reason);
          }) {}

void Opener::open(const std::string& path, const std::map<std::string, std::string>& defines) {
  if (is_picture_path(path)) {
    open_picture(path);
  } else if (is_checkpoint(path)) {
    resume(path);
  } else {
    begin_request();
    loader_.load(path, defines);
  }
}

/// Drops what was asked for before.
uint64_t Opener::begin_request() {
  loader_.forget();
  session_.reset();
  reading_.clear();
  reloading_ = false;
  return ++newest_request_;
}

void Opener::reload() {
  if (!document_.has_scene()) return;
  begin_request();
  reloading_ = true;
  loader_.load(document_.opened().path, document_.opened().defines);
}

template <typename Read, typename Take>
void Opener::read(const std::string& path, Read read_file, Take take) {
  const uint64_t request = begin_request();
  reading_ = path;
  reader_.run([this, path, request, read_file, take] {
    // `this` is only used on the UI thread, which drops what is posted once the opener is gone.
    const auto finish = [&](std::function<void()> deliver) {
      queue_->post([this, request, deliver = std::move(deliver)] {
        if (request != newest_request_) return;
        reading_.clear();
        deliver();
      });
    };
    try {
      finish([take, content = read_file(path)] { take(content); });
    } catch (const std::exception& error) {
      finish([this, text = sentence_about(error, "Cannot read '" + path + "'")] {
        document_.messages().error(text);
      });
    }
  });
}

void Opener::open_picture(const std::string& path) {
  read(path, read_metadata, [this, path](const Metadata& metadata) {
    if (!session_of(metadata) && document_.has_scene()) {
      take_as_reference(path);
      return;
    }
    open_session(path, metadata, {});
  });
}

void Opener::take_as_reference(const std::string& path) {
  listener_.take_reference(path);
  document_.messages().note(path + " is what the render is compared with now.");
}

void Opener::resume(const std::string& path) {
  read(path, read_checkpoint, [this, path](const Checkpoint& checkpoint) {
    open_session(path, describe_checkpoint(checkpoint), checkpoint);
  });
}

void Opener::open_session(const std::string& path, const Metadata& metadata,
                          std::optional<Checkpoint> checkpoint) {
  auto settings = session_of(metadata);
  if (!settings) {
    document_.messages().error(
        path + " carries no session: choose a picture or a checkpoint that Guidelight saved");
    return;
  }
  if (checkpoint) settings->guides.reset();  // it has none, whatever was rendered with
  Session session{*settings, std::move(checkpoint), path};
  const OpenedScene& opened = document_.opened();
  if (document_.has_scene() && opened.path == settings->scene_path &&
      opened.defines == settings->defines) {
    restore(std::move(session));
  } else {
    session_ = std::move(session);
    loader_.load(settings->scene_path, settings->defines);
  }
}

void Opener::take_scene(OpenedScene opened) {
  auto session = std::exchange(session_, {});
  try {
    if (session) check(*session, *opened.scene);
    if (std::exchange(reloading_, false)) {
      document_.reload(std::move(opened));
      listener_.scene_reloaded();
    } else {
      document_.open(std::move(opened));
      listener_.scene_opened();
    }
    if (session) restore(*std::move(session));
  } catch (const std::exception& error) {
    document_.messages().error(error.what());
  }
}

/// Throws Error if the session cannot be restored with this scene.
void Opener::check(const Session& session, const Scene& scene) {
  const RenderJob job = job_of(session.settings, scene);
  if (session.checkpoint) resume_from(*session.checkpoint, job, session.path);
}

/// Changes nothing if it cannot be done.
void Opener::restore(Session session) {
  try {
    check(session, document_.scene());
    const GuideList before = document_.guides();
    restore_session(session.settings, document_);
    if (document_.guides() != before && !before->empty()) set_aside(before);
    if (session.checkpoint) {
      document_.resume(*std::move(session.checkpoint), session.path);
    } else {
      document_.messages().note(
          session.path + " has brought its camera, settings and guides.",
          {"Use as reference", [this, path = session.path] { take_as_reference(path); }});
    }
  } catch (const std::exception& error) {
    document_.messages().error(error.what());
  }
}

/// The file beside the scene will soon hold those of the session.
void Opener::set_aside(const GuideList& guides) {
  reader_.run([this, guides, file = guide_file_beside(document_.opened().path)] {
    const std::filesystem::path path = file;
    try {
      const std::string aside =
          NumberedFiles(path.parent_path().string()).next(path.filename().string(), "earlier");
      write_guides(aside, *guides);
      queue_->post([this, aside] {
        document_.messages().note("The guides that were here before are kept as " + aside);
      });
    } catch (const std::exception& error) {
      queue_->post([this, text = std::string(error.what())] { document_.messages().error(text); });
    }
  });
}

}  // namespace guidelight
