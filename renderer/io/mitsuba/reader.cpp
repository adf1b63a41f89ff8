#include "renderer/io/mitsuba/reader.h"

#include "renderer/io/framing.h"
#include "renderer/io/mitsuba/importer.h"

namespace guidelight::mitsuba {

void Importer::import_scene() {
  Properties p(*document_.root, warnings_);
  // BSDFs first, so that their order is that of the file.
  for (const Node* node : p.objects("bsdf")) bsdf(*node);
  for (const Node* node : p.objects("texture")) texture(*node);
  for (const Node* node : p.objects("medium")) medium(*node);
  for (const Node* node : p.objects("shape")) {
    for (ShapeDescription& shape : shapes_of(*node)) scene_.shapes.push_back(std::move(shape));
  }
  for (const Node* node : p.objects("emitter")) emitter(*node);
  for (const Node* node : p.objects("sensor")) sensor(*node);
  for (const Node* node : p.objects("integrator")) integrator(*node);
  p.objects("spectrum");  // there to be referred to
  p.warn_about_the_rest();
  if (!has_sensor_) {
    scene_.camera = framing_camera(scene_);
    warnings_.add(document_.root->source, "no sensor",
                  "the scene has no sensor; a camera that sees all of it stands in.");
  }
}

SceneDescription read_mitsuba_scene(const std::string& path,
                                    const std::map<std::string, std::string>& defines) {
  const Document document = load_document(path, defines);
  SceneDescription scene;
  scene.warnings = document.warnings;
  Importer(document, scene).import_scene();
  return scene;
}

}  // namespace guidelight::mitsuba
