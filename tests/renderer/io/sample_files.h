#pragma once

#include <string>

#include "renderer/scene/description.h"

/// Small valid files of every format that is read, for the tests to write and to damage.
namespace guidelight::test {

std::string sample_obj();
std::string sample_ply_text();
/// Coloured quad and triangle.
std::string sample_ply_binary(bool big_endian = false);
/// Two meshes; the second with normals and uvs.
std::string sample_serialized(int version = 4, bool doubles = false);
/// One triangle; buffer as data URI.
std::string sample_gltf();
std::string sample_glb();

std::string sample_png();  // 4 × 4
std::string sample_jpeg();
std::string sample_hdr();  // 16 × 8, run-length coded
std::string sample_bmp();
std::string sample_tga();
std::string sample_exr();

}  // namespace guidelight::test
