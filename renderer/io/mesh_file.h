#pragma once

#include <string>

#include "renderer/scene/description.h"

namespace guidelight {

enum class MeshFormat { Obj, Ply };

/// All triangles of a file as one mesh, polygons as fans, texture coordinates as written. Throws
/// Error Error for Vertices that are equal in everything are shared. Throws Error for anything that
/// cannot be read.
Mesh read_mesh_file(const std::string& path, MeshFormat format);

/// Mesh number `index` of a Mitsuba .serialized file. `has_face_normals` is set if the file asks
/// for flat shading. Throws Error for anything that cannot be read.
Mesh read_serialized_mesh(const std::string& path, int index, bool& has_face_normals);

}  // namespace guidelight
