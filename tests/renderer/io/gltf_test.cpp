#include <gmock/gmock.h>

#include <algorithm>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

SceneDescription read_sample(const std::string& bytes) {
  const TemporaryFolder folder;
  folder.write("map one.png", sample_png());
  return read_scene(folder.write("scene.gltf", bytes));
}

/// The sample with one part of its text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string gltf = sample_gltf();
  const size_t at = gltf.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return gltf.replace(at, from.size(), to);
}

/// With the material's metallic-roughness part and what follows it replaced.
SceneDescription with_material(const std::string& material, const std::string& top_level = "") {
  const std::string start = "{\"name\":\"m\"";
  std::string gltf = sample_gltf();
  const size_t at = gltf.find(start), end = gltf.find("\"accessors\"");
  return read_sample(gltf.replace(at, end - at, material + "],\n" + top_level));
}

template <typename Model>
const Model& bsdf(const SceneDescription& scene, int index) {
  return std::get<Model>(scene.bsdfs.at(static_cast<size_t>(index)).model);
}

std::string gltf_error(const std::string& bytes) {
  try {
    read_sample(bytes);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(Gltf, TextAndBinarySayTheSame) {
  for (const std::string& bytes : {sample_gltf(), sample_glb()}) {
    const SceneDescription scene = read_sample(bytes);
    EXPECT_THAT(scene.warnings, IsEmpty());
    ASSERT_EQ(scene.shapes.size(), 1u);
    const ShapeDescription& shape = scene.shapes[0];
    EXPECT_EQ(shape.name, "triangle");
    EXPECT_EQ(Vec3(shape.to_world[3]), Vec3(1, 2, 3));
    const Mesh& mesh = *std::get<MeshShape>(shape.geometry).mesh;
    EXPECT_EQ(mesh.positions[1], Vec3(1, 0, 0));
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_TRUE(mesh.normals.empty()) << "flat without normals";
    EXPECT_EQ(shape.radiance->value, Color(1));
  }
}

TEST(Gltf, NodesScaledToNothingAreLeftOutUnlessFlat) {
  const auto scaled = [](const std::string& scale) {
    return read_sample(changed(
        R"("children":[1]},{"camera":0}])",
        R"("children":[1,2]},{"camera":0},{"mesh":0,"name":"thin","scale":)" + scale + "}]"));
  };
  const SceneDescription without = scaled("[0,1,1]");
  EXPECT_EQ(without.shapes.size(), 1u);
  EXPECT_THAT(without.warnings, ::testing::ElementsAre(HasSubstr("'thin' is scaled to nothing")));
  const SceneDescription flat = scaled("[2,1,0]");  // the triangle lies in z = 0
  EXPECT_THAT(flat.warnings, IsEmpty());
  ASSERT_EQ(flat.shapes.size(), 2u);
  EXPECT_EQ(flat.shapes[1].to_world[0], Vec4(2, 0, 0, 0));
  EXPECT_EQ(flat.shapes[1].to_world[2], Vec4(0, 0, 1, 0));
}

TEST(Gltf, MetallicRoughnessIsATwoSidedBlend) {
  const SceneDescription scene = read_sample(sample_gltf());
  const auto& sides = bsdf<TwoSidedBsdf>(scene, scene.shapes[0].bsdf);
  const auto& blend = bsdf<BlendBsdf>(scene, sides.front);
  EXPECT_FLOAT_EQ(blend.weight.value, 0.25f);
  const auto& plastic = bsdf<PlasticBsdf>(scene, blend.first);
  EXPECT_EQ(plastic.diffuse_reflectance.value, Color(0.5f, 0.25f, 0.125f));
  EXPECT_FLOAT_EQ(plastic.alpha.value, 0.25f) << "roughness squared";
  EXPECT_EQ(bsdf<ConductorBsdf>(scene, blend.second).specular_reflectance.value,
            Color(0.5f, 0.25f, 0.125f));
}

TEST(Gltf, CamerasLookAlongMinusZ) {
  const CameraDescription camera = read_sample(sample_gltf()).camera;
  EXPECT_EQ(camera.fov_axis, FovAxis::Y);
  EXPECT_NEAR(camera.fov, 0.8f * 180 / kPi, 1e-4f);
  EXPECT_EQ(Vec3(camera.to_world[2]), Vec3(0, 0, -1));
  EXPECT_EQ(Vec3(camera.to_world[0]), Vec3(-1, 0, 0));
  EXPECT_EQ(Vec3(camera.to_world[3]), Vec3(1, 2, 3)) << "a child of the moved node";
  EXPECT_EQ(read_sample(sample_gltf()).film.width, 1080);
}

TEST(Gltf, WithoutCameraAndLightBothStandIn) {
  std::string gltf = changed(R"({"camera":0})", "{}");
  gltf.replace(gltf.find("[1,1,1]"), 7, "[0,0,0]");
  const SceneDescription scene = read_sample(gltf);
  EXPECT_THAT(scene.warnings,
              ::testing::ElementsAre(HasSubstr("no camera"), HasSubstr("no light")));
  EXPECT_TRUE(std::holds_alternative<ConstantEmitter>(scene.emitters.at(0).model));
}

TEST(Gltf, TransmissionIsThinGlassOrWithAVolumeSolid) {
  const SceneDescription thin = with_material(R"({"extensions":{
    "KHR_materials_transmission":{"transmissionFactor":1},"KHR_materials_ior":{"ior":1.4}}})");
  EXPECT_FLOAT_EQ(bsdf<ThinDielectricBsdf>(thin, thin.shapes[0].bsdf).int_ior, 1.4f);
  const SceneDescription solid = with_material(R"({"pbrMetallicRoughness":{"roughnessFactor":0},
    "extensions":{"KHR_materials_transmission":{"transmissionFactor":1},
    "KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,"attenuationColor":[1,0.5,1]}}})");
  EXPECT_FLOAT_EQ(bsdf<DielectricBsdf>(solid, solid.shapes[0].bsdf).int_ior, 1.5f);
  EXPECT_TRUE(solid.shapes[0].is_medium_boundary);
  // exp(-2 σ) = 0.5
  EXPECT_NEAR(solid.media.at(0).sigma_a.g, 0.346574f, 1e-5f);
  EXPECT_EQ(solid.media.at(0).sigma_a.r, 0);
}

TEST(Gltf, EmissiveStrengthAndAlphaModes) {
  const SceneDescription scene = with_material(R"({"emissiveFactor":[1,0.5,0],"alphaMode":"BLEND",
    "pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]},
    "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}}})");
  EXPECT_EQ(scene.shapes[0].radiance->value, Color(8, 4, 0));
  EXPECT_FLOAT_EQ(bsdf<MaskBsdf>(scene, scene.shapes[0].bsdf).opacity.value, 0.25f);
}

TEST(Gltf, TexturesOfSpecularReflectionAreReported) {
  const auto warnings = [](const std::string& specular) {
    return with_material(R"({"pbrMetallicRoughness":{"metallicFactor":0},"extensions":{
        "KHR_materials_specular":{)" +
                         specular + "}}}")
        .warnings;
  };
  const std::string message = "textures of 'KHR_materials_specular'";
  EXPECT_THAT(warnings(R"("specularTexture":{"index":0})"),
              ::testing::Contains(HasSubstr(message)));
  EXPECT_THAT(warnings(R"("specularColorTexture":{"index":0})"),
              ::testing::Contains(HasSubstr(message)));
  EXPECT_THAT(warnings(R"("specularFactor":0.5)"),
              ::testing::Not(::testing::Contains(HasSubstr(message))));
}

TEST(Gltf, TextureRotationIsCounterClockwiseInThePicture) {
  const SceneDescription scene = with_material(
      R"({"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0,"extensions":{
        "KHR_texture_transform":{"offset":[0.5,0],"scale":[2,3],"rotation":1.57079633}}}}})",
      R"("textures":[{"source":0}],"images":[{"uri":"map%20one.png"}],)");
  const auto& texture = std::get<BitmapTexture>(scene.textures.at(0).model);
  // Before the rotation (0.2, 0.9) with v downwards. A quarter turn to the left makes the right
  // (1, 0) the top (0, -1), and the bottom (0, 1) the right (1, 0).
  const Vec3 turned = texture.uv_transform * Vec3(0.1f, 0.3f, 1);
  EXPECT_NEAR(turned.x, 0.9f + 0.5f, 1e-6f);
  EXPECT_NEAR(turned.y, 1 + 0.2f, 1e-6f);
}

TEST(Gltf, TexturesWithSamplersAndTransforms) {
  const SceneDescription scene = with_material(
      R"({"normalTexture":{"index":0,"scale":0.5},"pbrMetallicRoughness":{"baseColorTexture":{"index":0,
        "extensions":{"KHR_texture_transform":{"offset":[0.5,0],"scale":[2,3]}}},
        "metallicRoughnessTexture":{"index":0}}})",
      R"("textures":[{"source":0,"sampler":0}],"images":[{"uri":"map%20one.png"}],
         "samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],)");
  const auto& map = bsdf<NormalMapBsdf>(scene, scene.shapes[0].bsdf);
  EXPECT_TRUE(map.y_is_against_v);
  const auto& normal =
      std::get<BitmapTexture>(scene.textures[static_cast<size_t>(map.texture)].model);
  EXPECT_NEAR(normal.image->pixel(1, 0)[0], 0.5f + (37.0f / 255 - 0.5f) / 2, 1e-6f);
  const auto& blend = bsdf<BlendBsdf>(scene, bsdf<TwoSidedBsdf>(scene, map.nested).front);
  EXPECT_EQ(blend.weight.channel, 2);
  const auto& plastic = bsdf<PlasticBsdf>(scene, blend.first);
  const auto texture = [&](int index) {
    return std::get<BitmapTexture>(scene.textures.at(static_cast<size_t>(index)).model);
  };
  const BitmapTexture base = texture(plastic.diffuse_reflectance.texture);
  EXPECT_EQ(base.wrap_u, WrapMode::Clamp);
  EXPECT_EQ(base.wrap_v, WrapMode::Mirror);
  EXPECT_EQ(base.filter, TextureFilter::Nearest);
  const Vec3 moved = base.uv_transform * Vec3(0.25f, 0.1f, 1);  // top row at v = 0
  EXPECT_NEAR(moved.x, 1, 1e-6f);
  EXPECT_NEAR(moved.y, 1 - 0.3f, 1e-6f);
  const float green = 91.0f / 255;
  EXPECT_NEAR(texture(plastic.alpha.texture).image->pixel(1, 0)[0], green * green, 1e-6f);
}

TEST(Gltf, PunctualLights) {
  std::string gltf =
      changed(R"("translation":[1,2,3])",
              R"("translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}})");
  gltf.insert(1, R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":2,
    "color":[1,0.5,0],"spot":{"innerConeAngle":0.1,"outerConeAngle":0.3}}]}},)");
  const SceneDescription spot_scene = read_sample(gltf);
  const auto& spot = std::get<SpotEmitter>(spot_scene.emitters.at(0).model);
  EXPECT_EQ(spot.intensity, Color(2, 1, 0));
  EXPECT_EQ(Vec3(spot.to_world[2]), Vec3(0, 0, -1));
  EXPECT_FLOAT_EQ(spot.beam_width, 0.1f);
  gltf.replace(gltf.find("\"spot\""), 6, "\"point\"");
  const SceneDescription point_scene = read_sample(gltf);
  EXPECT_EQ(std::get<PointEmitter>(point_scene.emitters.at(0).model).position, Vec3(1, 2, 3));
  gltf.replace(gltf.find("\"point\""), 7, "\"directional\"");
  const SceneDescription sun_scene = read_sample(gltf);
  EXPECT_EQ(std::get<DirectionalEmitter>(sun_scene.emitters.at(0).model).direction, Vec3(0, 0, -1));
}

TEST(Gltf, PrimitivesKeepOnlyTheVerticesTheyUse) {
  // Two triangles with a list of indices each, from one list of six vertices.
  std::string data;
  const auto add = [&](const auto& value) {
    data.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (int i = 0; i < 6; ++i) add(Vec3(i, i % 3 == 1, i % 3 == 2));
  for (uint32_t i = 0; i < 6; ++i) add(i);
  const TemporaryFolder folder;
  folder.write("data.bin", data);
  const SceneDescription scene = read_scene(folder.write("scene.gltf", R"({
    "asset": {"version": "2.0"},
    "buffers": [{"uri": "data.bin", "byteLength": 96}],
    "bufferViews": [{"buffer": 0, "byteLength": 72},
                    {"buffer": 0, "byteOffset": 72, "byteLength": 24}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
      {"bufferView": 1, "byteOffset": 12, "componentType": 5125, "count": 3, "type": "SCALAR"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
                               {"attributes": {"POSITION": 0}, "indices": 2}]}],
    "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]})"));
  ASSERT_EQ(scene.shapes.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const Mesh& mesh = *std::get<MeshShape>(scene.shapes[i].geometry).mesh;
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.triangles[0], (std::array<uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(mesh.positions[0].x, 3.0f * static_cast<float>(i));
  }
}

TEST(Gltf, DamageIsNamed) {
  EXPECT_THAT(gltf_error("{\"asset\":\n\n oops"), HasSubstr("line 3"));
  EXPECT_THAT(gltf_error(changed("\"2.0\"", "\"1.0\"")), HasSubstr("version '1.0'"));
  EXPECT_THAT(gltf_error(changed("\"POSITION\":0", "\"POSITION\":9")), HasSubstr("accessors[9]"));
  EXPECT_THAT(gltf_error(changed("\"count\":3", "\"count\":3000000000")), HasSubstr("3000000000"));
  EXPECT_THAT(gltf_error(changed("\"byteLength\":36", "\"byteLength\":99")),
              HasSubstr("leaves its buffer"));
  EXPECT_THAT(gltf_error(changed("\"children\":[1]", "\"children\":[0]")),
              HasSubstr("two parents"));
  EXPECT_THAT(gltf_error(changed("[1,2,3]", "[1,2,1e99]")), HasSubstr("finite"));
  EXPECT_THAT(gltf_error(changed("data:application", "missing:file")), HasSubstr("no such file"));
  EXPECT_NE(gltf_error(sample_glb().substr(0, 200)), "");
}

}  // namespace
}  // namespace guidelight::test
