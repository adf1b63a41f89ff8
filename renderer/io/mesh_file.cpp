#include "renderer/io/mesh_file.h"

#include "renderer/error.h"
#include "renderer/io/mesh_tools.h"
#include "renderer/io/obj_mesh.h"
#include "renderer/io/ply_mesh.h"
#include "renderer/io/read_file.h"

namespace guidelight {

Mesh read_mesh_file(const std::string& path, MeshFormat format) {
  const bool ply = format == MeshFormat::Ply;
  const std::string bytes = read_file_bytes(path, size_t{512} << 20);
  Mesh mesh;
  try {
    mesh = ply ? decode_ply(bytes) : decode_obj(bytes);
  } catch (const Error& error) {
    throw Error("Cannot read the mesh '{}': {}; export it again as {}.", path, error.what(),
                ply ? "PLY" : "OBJ");
  }
  check_mesh(mesh, path);
  return mesh;
}

}  // namespace guidelight
