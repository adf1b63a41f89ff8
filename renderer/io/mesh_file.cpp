#include "renderer/io/mesh_file.h"

#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "renderer/error.h"
#include "renderer/io/mesh_precheck.h"
#include "renderer/io/mesh_tools.h"
#include "renderer/io/read_file.h"

namespace guidelight {
namespace {

Vec3 to_vec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Meshes of one file may differ in what they carry; missing normals force smooth ones for all.
void append(const aiMesh& part, bool normals, bool uvs, bool colors, Mesh& mesh) {
  const auto base = static_cast<uint32_t>(mesh.positions.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    mesh.positions.push_back(to_vec3(part.mVertices[i]));
    if (normals) mesh.normals.push_back(to_vec3(part.mNormals[i]));
    if (uvs) {
      const bool has = part.HasTextureCoords(0);
      mesh.uvs.push_back(has ? Vec2(to_vec3(part.mTextureCoords[0][i])) : Vec2(0));
    }
    if (colors) {
      const bool has = part.HasVertexColors(0);
      const aiColor4D c = has ? part.mColors[0][i] : aiColor4D(1, 1, 1, 1);
      mesh.colors.push_back({c.r, c.g, c.b});
    }
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    // Polygons become fans, as in Mitsuba; points and lines vanish. The library's own triangulation
    // aborts the program on some polygons.
    const aiFace& face = part.mFaces[f];
    for (unsigned i = 2; i < face.mNumIndices; ++i) {
      mesh.triangles.push_back(
          {base + face.mIndices[0], base + face.mIndices[i - 1], base + face.mIndices[i]});
    }
  }
}

Mesh merge(const aiScene& scene) {
  bool normals = true, uvs = false, colors = false;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    normals = normals && scene.mMeshes[m]->HasNormals();
    uvs = uvs || scene.mMeshes[m]->HasTextureCoords(0);
    colors = colors || scene.mMeshes[m]->HasVertexColors(0);
  }
  Mesh mesh;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    append(*scene.mMeshes[m], normals, uvs, colors, mesh);
  }
  return mesh;
}

}  // namespace

Mesh read_mesh_file(const std::string& path, MeshFormat format) {
  const std::string bytes = read_file_bytes(path);
  const bool ply = format == MeshFormat::Ply;
  try {
    ply ? check_ply(bytes) : check_obj(bytes);
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, ply ? "ply" : "obj");
    if (!scene) throw Error("{}", importer.GetErrorString());
    Mesh mesh = merge(*scene);
    importer.FreeScene();
    check_mesh(mesh, path);
    join_equal_vertices(mesh);
    return mesh;
  } catch (const Error& error) {
    const std::string reason = error.what();
    if (reason.starts_with("Cannot use")) throw;
    throw Error("Cannot read the mesh '{}': {}; export it again as {}.", path, reason,
                ply ? "PLY" : "OBJ");
  }
}

}  // namespace guidelight
