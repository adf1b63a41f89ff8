#pragma once

#include <memory>
#include <string>

#include "renderer/scene/description.h"

namespace guidelight {

/// Unit normals from the triangles around each vertex, weighted by the angle they have there
/// (Thürmer and Wüthrich 1998, "Computing Vertex Normals from Polygonal Facets"). Vertices are
/// smooth where they are shared by index.
void compute_smooth_normals(Mesh& mesh);

/// Merges vertices that are equal in everything, so that they are shared by index.
void join_equal_vertices(Mesh& mesh);

/// Drops vertices that no triangle names, whose indices must be in range.
void drop_unused_vertices(Mesh& mesh);

/// Splits vertices so that only triangles whose planes differ by less than `max_angle` [degrees]
/// share one, and computes normals. Around a vertex of many triangles, planes that differ by less
/// than a degree count as one.
void compute_creased_normals(Mesh& mesh, float max_angle);

/// Throws Error naming `name` for positions that are not finite, indices out of range, lists of
/// different length and no triangles at all. Normals, uvs and colours that cannot be used become
/// the triangle's normal, zero and white.
void check_mesh(Mesh& mesh, const std::string& name);

/// Two triangles over [-1,1]² in z = 0, normal +z, uv from (0,0) to (1,1).
std::shared_ptr<const Mesh> make_rectangle_mesh();

/// [-1,1]³ with outward normals, each side with uv from (0,0) to (1,1).
std::shared_ptr<const Mesh> make_cube_mesh();

}  // namespace guidelight
