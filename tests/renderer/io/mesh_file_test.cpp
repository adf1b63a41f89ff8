#include "renderer/io/mesh_file.h"

#include <gmock/gmock.h>

#include "renderer/error.h"
#include "renderer/io/mesh_tools.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::HasSubstr;

Mesh read_mesh_bytes(const std::string& bytes, MeshFormat format) {
  const TemporaryFolder folder;
  return read_mesh_file(folder.write("mesh with spaces.OBJ", bytes), format);
}

std::string mesh_error(const std::string& bytes, MeshFormat format) {
  try {
    read_mesh_bytes(bytes, format);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(ObjFile, GroupsQuadsAndNegativeIndices) {
  const Mesh mesh = read_mesh_bytes(sample_obj(), MeshFormat::Obj);
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.positions.size(), 5u) << "equal corners share a vertex, over groups too";
  EXPECT_EQ(mesh.positions[mesh.triangles[2][0]], Vec3(0, 0, 1)) << "-1 is the latest vertex";
  EXPECT_EQ(mesh.uvs[mesh.triangles[0][2]], Vec2(1, 0.75f));
  EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
}

TEST(ObjFile, VertexColoursAndMissingParts) {
  const Mesh mesh = read_mesh_bytes(
      "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nvn 0 0 1\nf 1//1 2 3\n", MeshFormat::Obj);
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(mesh.colors[1], Color(0, 1, 0));
  EXPECT_TRUE(mesh.normals.empty()) << "normals count only if every corner has one";
  EXPECT_TRUE(mesh.uvs.empty());
}

TEST(ObjFile, ErrorsNameTheLine) {
  EXPECT_THAT(mesh_error("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", MeshFormat::Obj),
              HasSubstr("line 4"));
  EXPECT_THAT(mesh_error("v 0 0 0\nf 1 -2 1\n", MeshFormat::Obj), HasSubstr("line 2"));
  EXPECT_THAT(mesh_error("v 0 0\n", MeshFormat::Obj), HasSubstr("line 1"));
  EXPECT_THAT(mesh_error("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::Obj),
              HasSubstr("not finite"));
  EXPECT_THAT(mesh_error("v 1e99 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", MeshFormat::Obj),
              HasSubstr("not finite"));
  EXPECT_THAT(mesh_error("# nothing\n", MeshFormat::Obj), HasSubstr("no triangles"));
}

TEST(PlyFile, TextWithNormalsAndTextureCoordinates) {
  const Mesh mesh = read_mesh_bytes(sample_ply_text(), MeshFormat::Ply);
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.uvs[2], Vec2(1, 0.25f));
  EXPECT_EQ(mesh.normals[3], Vec3(0, 0, 1));
}

TEST(PlyFile, BinaryOfBothByteOrdersWithColours) {
  for (const bool big_endian : {false, true}) {
    const Mesh mesh = read_mesh_bytes(sample_ply_binary(big_endian), MeshFormat::Ply);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    EXPECT_EQ(mesh.positions[2], Vec3(1, 1, 0));
    EXPECT_EQ(mesh.triangles[1], (std::array<uint32_t, 3>{0, 2, 3}));
    ASSERT_EQ(mesh.colors.size(), 4u);
    EXPECT_FLOAT_EQ(mesh.colors[2].g, 102.0f / 255);
  }
}

TEST(PlyFile, FalseCountsAndIndicesAreErrors) {
  std::string ply = sample_ply_text();
  ply.replace(ply.find("vertex 4"), 8, "vertex 99999999999");
  EXPECT_THAT(mesh_error(ply, MeshFormat::Ply), HasSubstr("99999999999"));
  ply = sample_ply_text();
  ply.replace(ply.find("4 0 1 2 3"), 9, "4 0 1 2 9");
  EXPECT_THAT(mesh_error(ply, MeshFormat::Ply), HasSubstr("vertex 9 of 4"));
  ply.replace(ply.find("4 0 1 2 9"), 9, "4 0 1 2 -1");
  EXPECT_NE(mesh_error(ply, MeshFormat::Ply), "");
  const std::string binary = sample_ply_binary();
  EXPECT_THAT(mesh_error(binary.substr(0, binary.size() - 5), MeshFormat::Ply),
              HasSubstr("too early"));
}

TEST(SerializedFile, BothVersionsAndPrecisions) {
  const TemporaryFolder folder;
  for (const int version : {3, 4}) {
    for (const bool doubles : {false, true}) {
      const std::string path = folder.write("m.serialized", sample_serialized(version, doubles));
      bool flat = true;
      const Mesh plain = read_serialized_mesh(path, 0, flat);
      EXPECT_TRUE(plain.normals.empty() && plain.uvs.empty());
      EXPECT_FALSE(flat);
      const Mesh full = read_serialized_mesh(path, 1, flat);
      EXPECT_EQ(full.triangles.size(), 1u);
      EXPECT_EQ(full.positions[1], Vec3(1, 0, 0));
      EXPECT_EQ(full.normals[2], Vec3(0, 0, 1));
      EXPECT_EQ(full.uvs[0], Vec2(0, 0.25f));
      EXPECT_THROW(read_serialized_mesh(path, 2, flat), Error);
      EXPECT_THROW(read_serialized_mesh(path, -1, flat), Error);
    }
  }
}

TEST(MeshTools, SmoothNormalsWeighByAngle) {
  // A corner of a cube: three squares meet at the origin, one of them cut into two triangles there.
  // Weighted by angle each side counts the same, so the normal is the diagonal.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  mesh.triangles = {{0, 2, 4}, {0, 4, 1}, {0, 3, 2}, {0, 1, 3}};
  compute_smooth_normals(mesh);
  const Vec3 expected = glm::normalize(Vec3(-1));
  EXPECT_NEAR(glm::length(mesh.normals[0] - expected), 0, 1e-6f);
}

TEST(MeshTools, CreasesAppearAboveTheAngle) {
  Mesh roof;  // two triangles at 90 degrees that share an edge
  roof.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  roof.triangles = {{0, 2, 1}, {0, 1, 3}};
  Mesh smooth = roof;
  compute_creased_normals(smooth, 100);
  EXPECT_EQ(smooth.positions.size(), 4u);
  compute_creased_normals(roof, 80);
  EXPECT_EQ(roof.positions.size(), 6u);
  EXPECT_NEAR(std::abs(roof.normals[roof.triangles[0][0]].z), 1, 1e-6f);
}

/// A flat disc and a blunt cone below it, each of many triangles around the same vertex.
Mesh two_fans(uint32_t count) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  for (const float height : {0.0f, -1.0f}) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (uint32_t i = 0; i < count; ++i) {
      const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(count);
      mesh.positions.emplace_back(std::cos(phi), std::sin(phi), height);
      mesh.triangles.push_back({0, first + i, first + (i + 1) % count});
    }
  }
  return mesh;
}

TEST(MeshTools, CreasesAtAVertexOfManyTrianglesAreTheSameAsAtOneOfFew) {
  for (const uint32_t count : {100u, 20000u}) {
    Mesh mesh = two_fans(count);
    compute_creased_normals(mesh, 30);
    const auto normal = [&](size_t triangle) { return mesh.normals[mesh.triangles[triangle][0]]; };
    EXPECT_NEAR(glm::distance(normal(0), Vec3(0, 0, 1)), 0, 1e-3f) << count;
    // The cone's sides, at 45 degrees, are smooth with those next to them, up to 43 degrees round
    // the axis, and not with the disc. Over these the mean of (cos φ, 1) is (0.909, 1).
    EXPECT_NEAR(normal(count).z, 0.740f, 0.005f) << count;
    EXPECT_GT(normal(count).x, 0.5f) << count;
    EXPECT_LT(normal(count + count / 2).x, -0.5f) << count;
  }
}

TEST(MeshTools, UnusedVerticesAreDropped) {
  Mesh mesh;
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}};
  mesh.uvs = {{9, 9}, {0, 0}, {1, 0}, {8, 8}, {0, 1}};
  mesh.triangles = {{4, 1, 2}};
  drop_unused_vertices(mesh);
  EXPECT_THAT(mesh.positions, ::testing::ElementsAre(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)));
  EXPECT_THAT(mesh.uvs, ::testing::ElementsAre(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)));
  EXPECT_EQ(mesh.triangles[0], (std::array<uint32_t, 3>{2, 0, 1}));
}

TEST(MeshTools, CubeFacesOutwards) {
  const auto cube = make_cube_mesh();
  ASSERT_EQ(cube->triangles.size(), 12u);
  for (const auto& t : cube->triangles) {
    const Vec3 a = cube->positions[t[0]], b = cube->positions[t[1]], c = cube->positions[t[2]];
    const Vec3 normal = glm::cross(b - a, c - a);
    EXPECT_GT(glm::dot(normal, a), 0);
    EXPECT_GT(glm::dot(normal, cube->normals[t[0]]), 0);
  }
}

}  // namespace
}  // namespace guidelight::test
