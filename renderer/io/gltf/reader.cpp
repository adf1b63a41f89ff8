#include "renderer/io/gltf/reader.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "renderer/io/flat_shape.h"
#include "renderer/io/framing.h"
#include "renderer/io/gltf/asset.h"
#include "renderer/io/gltf/materials.h"
#include "renderer/io/mesh_tools.h"

namespace guidelight::gltf {
namespace {

constexpr int kMaxNodeDepth = 500;

/// glTF cameras and lights look along -z with +x to the right; ours along +z with +x to the left.
const Mat4 kTurnAround(Vec4(-1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, -1, 0), Vec4(0, 0, 0, 1));

Mat4 local_transform(const Json& node) {
  Mat4 matrix(1.0f);
  if (find(node, "matrix")) {
    const std::vector<float> m = numbers_of(node, "matrix", std::vector<float>(16));
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
    return matrix;
  }
  const std::vector<float> t = numbers_of(node, "translation", {0, 0, 0});
  const std::vector<float> r = numbers_of(node, "rotation", {0, 0, 0, 1});
  const std::vector<float> s = numbers_of(node, "scale", {1, 1, 1});
  matrix = glm::translate(matrix, Vec3(t[0], t[1], t[2]));
  matrix = matrix * glm::mat4_cast(glm::normalize(glm::quat(r[3], r[0], r[1], r[2])));
  return glm::scale(matrix, Vec3(s[0], s[1], s[2]));
}

/// Triangle lists, strips and fans as a list; empty for points and lines.
std::vector<std::array<uint32_t, 3>> triangles_of(const std::vector<uint32_t>& indices, int mode) {
  std::vector<std::array<uint32_t, 3>> triangles;
  if (mode == 4) {
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
      triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    }
  } else if (mode == 5) {
    for (size_t i = 0; i + 2 < indices.size(); ++i) {  // every other triangle is turned
      const size_t odd = i % 2;
      triangles.push_back({indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
    }
  } else if (mode == 6) {
    for (size_t i = 1; i + 1 < indices.size(); ++i) {
      triangles.push_back({indices[0], indices[i], indices[i + 1]});
    }
  }
  return triangles;
}

class Reader {
 public:
  Reader(const Asset& asset, const std::string& path, SceneDescription& scene)
      : asset_(asset),
        scene_(scene),
        notices_(path, scene.warnings),
        materials_(asset, scene, notices_) {}

  void read() {
    check_extensions();
    visited_.resize(asset_.count("nodes"));
    for (const int root : root_nodes()) read_node(root, Mat4(1), 0);
    if (scene_.shapes.empty()) throw Error("it has no triangles");
    if (!has_camera_) {
      scene_.camera = framing_camera(scene_);
      scene_.film.width = 1280;
      scene_.film.height = 720;
      notices_.add("the scene has no camera; one that sees all of it stands in.");
    }
    const bool shines =
        std::any_of(scene_.shapes.begin(), scene_.shapes.end(),
                    [](const ShapeDescription& s) { return s.radiance.has_value(); });
    if (!shines && scene_.emitters.empty()) {
      scene_.emitters.push_back({"default light", 0, ConstantEmitter{Color(1)}});
      notices_.add("the scene has no light; a constant white environment stands in.");
    }
    if (asset_.count("animations") > 0) {
      notices_.add("animations are not supported; the scene is shown at rest.");
    }
  }

 private:
  void check_extensions() {
    const Json* required = find(asset_.json(), "extensionsRequired");
    if (!required || !required->is_array()) return;
    for (const Json& name : *required) {
      const std::string text = name.is_string() ? name.get<std::string>() : "";
      if (text == "KHR_draco_mesh_compression" || text == "EXT_meshopt_compression") {
        throw Error("its meshes are compressed with '{}'", text);
      }
    }
  }

  std::vector<int> root_nodes() const {
    std::vector<int> roots;
    if (asset_.count("scenes") > 0) {
      const int index = std::max(index_of(asset_.json(), "scene"), 0);
      if (const Json* nodes = find(asset_.entry("scenes", index), "nodes")) {
        for (const Json& node : *nodes) roots.push_back(node_index(node));
      }
      return roots;
    }
    std::vector<bool> is_child(asset_.count("nodes"));
    for (size_t i = 0; i < is_child.size(); ++i) {
      if (const Json* children = find(asset_.entry("nodes", static_cast<int>(i)), "children")) {
        for (const Json& child : *children) {
          const auto index = static_cast<size_t>(node_index(child));
          if (index < is_child.size()) is_child[index] = true;
        }
      }
    }
    for (size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  static int node_index(const Json& json) {
    if (!json.is_number_unsigned() || json.get<uint64_t>() > 0x7fffffff) {
      throw Error("a list of nodes has an entry that is not an index");
    }
    return json.get<int>();
  }

  void read_node(int index, const Mat4& parent, int depth) {
    const Json& node = asset_.entry("nodes", index);
    if (visited_[static_cast<size_t>(index)] || depth > kMaxNodeDepth) {
      throw Error("nodes[{}] has two parents or is its own", index);
    }
    visited_[static_cast<size_t>(index)] = true;
    const Mat4 to_world = parent * local_transform(node);
    const std::string name = text_of(node, "name", "");
    if (const int mesh = index_of(node, "mesh"); mesh != kNone) read_mesh(mesh, to_world, name);
    if (const int camera = index_of(node, "camera"); camera != kNone) {
      read_camera(asset_.entry("cameras", camera), to_world * kTurnAround);
    }
    if (const Json* extensions = find(node, "extensions")) {
      if (const Json* light = find(*extensions, "KHR_lights_punctual")) {
        read_light(index_of(*light, "light"), to_world * kTurnAround, name);
      }
    }
    if (find(node, "skin")) notices_.add("skins are not supported; meshes keep their rest pose.");
    if (const Json* children = find(node, "children")) {
      for (const Json& child : *children) read_node(node_index(child), to_world, depth + 1);
    }
  }

  void read_mesh(int index, const Mat4& to_world, const std::string& name) {
    const Json* primitives = find(asset_.entry("meshes", index), "primitives");
    if (!primitives || !primitives->is_array()) return;
    for (size_t p = 0; p < primitives->size(); ++p) {
      const Json& primitive = (*primitives)[p];
      const int mode = find(primitive, "mode") ? index_of(primitive, "mode") : 4;
      if (mode < 4 || mode > 6) {
        notices_.add("points and lines are not supported; they are left out.");
        continue;
      }
      const Json* attributes = find(primitive, "attributes");
      if (!attributes || index_of(*attributes, "POSITION") == kNone) continue;
      const bool colors = find(*attributes, "COLOR_0");
      const Surface surface = materials_.surface(index_of(primitive, "material"), colors);
      ShapeDescription shape;
      shape.name = name;
      shape.to_world = to_world;
      shape.geometry = MeshShape{
          primitive_mesh(primitive, mode, surface.uv_set, fmt::format("meshes[{}]", index), p)};
      shape.bsdf = surface.bsdf;
      shape.radiance = surface.radiance;
      shape.is_medium_boundary = surface.interior != kNone;
      shape.interior = surface.interior;
      if (!keep_drawable(shape)) {
        notices_.add(fmt::format(
            "the node '{}' is scaled to nothing in some direction; its mesh is left out.", name));
        continue;
      }
      scene_.shapes.push_back(std::move(shape));
    }
  }

  std::shared_ptr<const Mesh> primitive_mesh(const Json& primitive, int mode, int uv_set,
                                             const std::string& mesh_name, size_t number) {
    std::shared_ptr<const Mesh>& known = meshes_[{&primitive, uv_set}];
    if (known) return known;
    Mesh mesh;
    const Json& attributes = primitive.at("attributes");
    const auto read = [&](const std::string& attribute, auto& list) {
      using Vector = typename std::decay_t<decltype(list)>::value_type;
      const int accessor = index_of(attributes, attribute.c_str());
      if (accessor == kNone) return;
      const std::vector<float> values = asset_.floats(accessor, Vector::length());
      list.resize(values.size() / Vector::length());
      for (size_t i = 0; i < values.size(); ++i)
        list[i / Vector::length()][i % Vector::length()] = values[i];
    };
    read("POSITION", mesh.positions);
    read("NORMAL", mesh.normals);  // without, glTF wants flat shading, as Mesh does
    read(fmt::format("TEXCOORD_{}", uv_set), mesh.uvs);
    read("COLOR_0", mesh.colors);

    std::vector<uint32_t> indices;
    if (const int accessor = index_of(primitive, "indices"); accessor != kNone) {
      indices = asset_.indices(accessor);
    } else {
      for (uint32_t i = 0; i < mesh.positions.size(); ++i) indices.push_back(i);
    }
    mesh.triangles = triangles_of(indices, mode);
    check_mesh(mesh, fmt::format("{}.primitives[{}]", mesh_name, number));
    drop_unused_vertices(mesh);  // many primitives may share one list of them
    return known = std::make_shared<Mesh>(std::move(mesh));
  }

  void read_camera(const Json& json, const Mat4& to_world) {
    if (has_camera_) {
      notices_.add("only the first camera of the scene is used.");
      return;
    }
    has_camera_ = true;
    CameraDescription& camera = scene_.camera;
    camera.to_world = to_world;
    float aspect = 16.0f / 9;
    const bool orthographic = text_of(json, "type", "") == "orthographic";
    const Json* lens = find(json, orthographic ? "orthographic" : "perspective");
    if (!lens) throw Error("a camera has no parameters");
    if (orthographic) {
      const float width = std::abs(number_of(*lens, "xmag", 1));
      const float height = std::abs(number_of(*lens, "ymag", 1));
      if (!(width > 0 && height > 0)) throw Error("a camera sees nothing");
      camera.model = CameraModel::Orthographic;
      camera.to_world = glm::scale(camera.to_world, Vec3(width, width, 1));
      aspect = width / height;
    } else {
      camera.fov = number_of(*lens, "yfov", 0.8f) * 180 / kPi;
      camera.fov_axis = FovAxis::Y;
      aspect = number_of(*lens, "aspectRatio", aspect);
      if (!(camera.fov > 0 && camera.fov < 180 && aspect > 0)) {
        throw Error("a camera has a field of view of {} degrees", camera.fov);
      }
    }
    camera.near_clip = std::max(number_of(*lens, "znear", 0.01f), 0.0f);
    camera.far_clip = number_of(*lens, "zfar", std::max(1e4f, camera.near_clip * 1e4f));
    if (!(camera.far_clip > camera.near_clip))
      throw Error("a camera's clip distances leave nothing");
    scene_.film.height = 720;
    scene_.film.width =
        std::clamp(static_cast<int>(std::lround(720 * std::min(aspect, 16.0f))), 1, 11520);
  }

  /// KHR_lights_punctual; photometric units count as radiometric ones.
  void read_light(int index, const Mat4& to_world, const std::string& name) {
    const Json* extensions = find(asset_.json(), "extensions");
    const Json* punctual = extensions ? find(*extensions, "KHR_lights_punctual") : nullptr;
    const Json* lights = punctual ? find(*punctual, "lights") : nullptr;
    if (!lights || !lights->is_array() || index < 0 ||
        static_cast<size_t>(index) >= lights->size()) {
      throw Error("the light {} is used and does not exist", index);
    }
    const Json& light = (*lights)[static_cast<size_t>(index)];
    const std::vector<float> c = numbers_of(light, "color", {1, 1, 1});
    const Color intensity = number_of(light, "intensity", 1) * Color(c[0], c[1], c[2]);
    const std::string type = text_of(light, "type", "");
    if (type == "point") {
      scene_.emitters.push_back({name, 0, PointEmitter{Vec3(to_world[3]), intensity}});
    } else if (type == "directional") {
      const Vec3 direction = transform_vector(to_world, Vec3(0, 0, 1));
      if (!(length_squared(direction) > 0)) throw Error("a directional light has no direction");
      scene_.emitters.push_back(
          {name, 0, DirectionalEmitter{glm::normalize(direction), intensity}});
    } else if (type == "spot") {
      const Json* cone = find(light, "spot");
      SpotEmitter spot;
      spot.to_world = to_world;
      spot.intensity = intensity;
      spot.cutoff_angle =
          std::clamp(cone ? number_of(*cone, "outerConeAngle", kPi / 4) : kPi / 4, 1e-3f, kPi / 2);
      const float inner = cone ? number_of(*cone, "innerConeAngle", 0) : 0;
      spot.beam_width = std::clamp(inner, 0.0f, spot.cutoff_angle);
      scene_.emitters.push_back({name, 0, spot});
    } else {
      notices_.add(fmt::format("lights of type '{}' are not supported; they are left out.", type));
    }
  }

  const Asset& asset_;
  SceneDescription& scene_;
  Notices notices_;
  Materials materials_;
  std::map<std::pair<const Json*, int>, std::shared_ptr<const Mesh>> meshes_;
  std::vector<bool> visited_;
  bool has_camera_ = false;
};

}  // namespace

SceneDescription read_gltf_scene(const std::string& path, const std::string& bytes) {
  try {
    const Asset asset(path, bytes);
    SceneDescription scene;
    Reader(asset, path, scene).read();
    return scene;
  } catch (const std::exception& error) {
    throw Error("Cannot open the glTF scene '{}': {}; export it again.", path, error.what());
  }
}

}  // namespace guidelight::gltf
