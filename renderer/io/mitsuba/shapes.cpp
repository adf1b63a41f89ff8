#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/io/flat_shape.h"
#include "renderer/io/mesh_file.h"
#include "renderer/io/mesh_tools.h"
#include "renderer/io/mitsuba/importer.h"
#include "renderer/math/frame.h"

namespace guidelight::mitsuba {
namespace {

/// A few containers that refer to each other twice can repeat a shape without end.
constexpr int kMaxRepeatedShapes = 100000;

/// Unit sphere, disk or cylinder to one of these sizes.
Mat4 sphere_transform(Properties& p) {
  const float radius = p.number({"radius"}, 1);
  const Vec3 center = p.vector({"center"}, Vec3(0));
  return glm::scale(glm::translate(Mat4(1), center), Vec3(radius));
}

Mat4 cylinder_transform(Properties& p) {
  const Vec3 p0 = p.vector({"p0"}, Vec3(0));
  const Vec3 axis = p.vector({"p1"}, Vec3(0, 0, 1)) - p0;
  const float radius = p.number({"radius"}, 1);
  const float length = glm::length(axis);
  if (!(length > 0)) {
    throw Error("{}: the cylinder has no length; move p1 away from p0.",
                p.node().source.to_string());
  }
  const Frame frame = Frame::from_normal(axis / length);
  return {Vec4(frame.s * radius, 0), Vec4(frame.t * radius, 0), Vec4(axis, 0), Vec4(p0, 1)};
}

void flip_v(Mesh& mesh) {
  for (Vec2& uv : mesh.uvs) uv.y = 1 - uv.y;
}

}  // namespace

/// A mesh file with what the shape asks of it; files that several shapes name are read once.
std::shared_ptr<const Mesh> Importer::mesh(Properties& p) {
  const Node& node = p.node();
  const std::string name = p.text({"filename"}, "");
  if (name.empty()) {
    throw Error("{}: {} names no file; add a 'filename'.", node.source.to_string(),
                plugin_name(node));
  }
  const std::string path = document_.find_file(name, node.source);
  const bool serialized = node.type == "serialized";
  const int index = p.integer({"shape_index"}, serialized ? 0 : -1);
  const bool flip = p.boolean({"flip_tex_coords"}, node.type == "obj");
  bool face_normals = p.boolean({"face_normals"}, false);
  const float max_angle = p.number({"max_smooth_angle"}, 0);
  p.ignore({"collapse", "load_materials", "shape_name", "vertex_normals"});
  const bool encoded = node.type == "ply" && document_.version < 2 && p.boolean({"srgb"}, true);
  if (!serialized && index >= 0) {
    warnings_.add(node.source, "obj shape_index",
                  "'shapeIndex' of an OBJ is not supported; the whole file is read.");
  }

  const std::string key = fmt::format("{} {} {} {} {} {} {}", node.type, index, flip, encoded,
                                      face_normals, max_angle, path);
  std::shared_ptr<const Mesh>& known = meshes_[key];
  if (known) return known;
  try {
    bool flat_by_file = false;
    Mesh read = serialized
                    ? read_serialized_mesh(path, index, flat_by_file)
                    : read_mesh_file(path, node.type == "obj" ? MeshFormat::Obj : MeshFormat::Ply);
    face_normals = face_normals || flat_by_file;
    if (flip) flip_v(read);
    if (encoded) {
      for (Color& color : read.colors) color = srgb_to_linear(color);
    }
    if (face_normals) {
      read.normals.clear();
    } else if (max_angle > 0) {
      compute_creased_normals(read, max_angle);
    } else if (read.normals.empty()) {
      compute_smooth_normals(read);
    }
    return known = std::make_shared<Mesh>(std::move(read));
  } catch (const Error& error) {
    throw Error("{}: {}", node.source.to_string(), error.what());
  }
}

bool Importer::geometry(Properties& p, ShapeDescription& shape) {
  const std::string& type = p.node().type;
  if (type == "obj" || type == "ply" || type == "serialized") {
    shape.geometry = MeshShape{mesh(p)};
  } else if (type == "rectangle" || type == "cube") {
    std::shared_ptr<const Mesh>& known = meshes_[type];
    if (!known) known = type == "cube" ? make_cube_mesh() : make_rectangle_mesh();
    shape.geometry = MeshShape{known};
  } else if (type == "sphere") {
    shape.geometry = SphereShape{};
    shape.to_world = shape.to_world * sphere_transform(p);
  } else if (type == "disk") {
    shape.geometry = DiskShape{};
  } else if (type == "cylinder") {
    shape.geometry = CylinderShape{};
    shape.to_world = shape.to_world * cylinder_transform(p);
  } else {
    return false;
  }
  return true;
}

/// BSDF, emitter and media of a shape.
void Importer::attach(Properties& p, ShapeDescription& shape) {
  const Node* emitter = p.object("emitter");
  if (emitter && emitter->type == "area") {
    Properties light(*emitter, warnings_);
    shape.radiance = color(light, {"radiance"}, Color(1), SpectrumUse::Emission);
    light.ignore({"sampling_weight"});
    light.warn_about_the_rest();
  } else if (emitter) {
    warnings_.add(emitter->source, plugin_name(*emitter) + " on shape",
                  fmt::format("{} on a shape is not supported; the shape does not shine.",
                              plugin_name(*emitter)));
  }
  const auto side = [&](const char* name) {
    const Node* node = p.find({name});
    if (!node || node->tag != "medium") return kNone;
    shape.is_medium_boundary = true;
    return medium(*node);
  };
  shape.interior = side("interior");
  shape.exterior = side("exterior");

  const Node* surface = p.object("bsdf");
  if (surface) {
    shape.bsdf = bsdf(*surface);
  } else if (shape.radiance) {
    shape.bsdf = add_bsdf(p.node(), " (black)", DiffuseBsdf{{Color(0), kNone}});
  } else if (shape.is_medium_boundary) {
    shape.bsdf = add_bsdf(p.node(), " (boundary)", NullBsdf{});
  }
}

std::optional<ShapeDescription> Importer::shape(const Node& node) {
  Properties p(node, warnings_);
  ShapeDescription shape;
  shape.name = node.id;
  shape.line = node.source.line;
  shape.to_world = p.transform({"to_world"});
  if (node.type == "instance") {
    const Node* target = p.object("shape");
    if (!target || target->type != "shapegroup") {
      throw Error("{}: the instance names no shapegroup; add a <ref> to one.",
                  node.source.to_string());
    }
    shape.geometry = InstanceShape{group(*target)};
    p.warn_about_the_rest();
    return drawable(node, std::move(shape));
  }
  if (!geometry(p, shape)) {
    warnings_.add(node.source, plugin_name(node),
                  fmt::format("{} is not supported; it is left out.", plugin_name(node)));
    return std::nullopt;
  }
  shape.flip_normals = p.boolean({"flip_normals"}, false);
  attach(p, shape);
  p.warn_about_the_rest();
  return drawable(node, std::move(shape));
}

std::optional<ShapeDescription> Importer::drawable(const Node& node, ShapeDescription shape) {
  if (keep_drawable(shape)) return shape;
  warnings_.add(node.source, "singular " + node.source.to_string(),
                fmt::format("{} '{}' is scaled to nothing in some direction; it is left out.",
                            plugin_name(node), shape.name));
  return std::nullopt;
}

/// One shape, or the parts of a container; nothing for a group, which is there to be copied.
std::vector<ShapeDescription> Importer::shapes_of(const Node& node) {
  if (!seen_shapes_.insert(&node).second && ++repeated_shapes_ > kMaxRepeatedShapes) {
    throw Error("{}: containers repeat shapes more than {} times; use instances of a shapegroup.",
                node.source.to_string(), kMaxRepeatedShapes);
  }
  std::vector<ShapeDescription> shapes;
  if (node.type == "shapegroup") {
    group(node);
  } else if (node.type == "merge") {
    Properties p(node, warnings_);
    for (const Node* part : p.objects("shape")) {
      for (ShapeDescription& nested : shapes_of(*part)) shapes.push_back(std::move(nested));
    }
    p.warn_about_the_rest();
  } else if (std::optional<ShapeDescription> single = shape(node)) {
    shapes.push_back(std::move(*single));
  }
  return shapes;
}

int Importer::group(const Node& node) {
  if (const auto known = groups_.find(&node); known != groups_.end()) return known->second;
  ShapeGroup group{node.id, node.source.line, {}};
  Properties p(node, warnings_);
  for (const Node* part : p.objects("shape")) {
    for (ShapeDescription& nested : shapes_of(*part)) {
      if (std::holds_alternative<InstanceShape>(nested.geometry)) {
        warnings_.add(part->source, "nested instance",
                      "an instance inside a shapegroup is not supported; it is left out.");
        continue;
      }
      if (nested.radiance) {
        warnings_.add(part->source, "light in group",
                      "an emitter inside a shapegroup is not supported; the shape does not shine.");
        nested.radiance.reset();
      }
      group.shapes.push_back(std::move(nested));
    }
  }
  p.warn_about_the_rest();
  scene_.groups.push_back(std::move(group));
  return groups_[&node] = static_cast<int>(scene_.groups.size()) - 1;
}

}  // namespace guidelight::mitsuba
