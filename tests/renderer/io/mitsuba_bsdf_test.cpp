#include <gmock/gmock.h>

#include "tests/renderer/io/io_test_files.h"
#include "tests/renderer/io/sample_files.h"

namespace guidelight::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The scene that one BSDF makes, which must not warn.
SceneDescription scene_of(const std::string& bsdf, const std::string& version = "3.0.0") {
  const TemporaryFolder folder;
  folder.write("map.png", sample_png());
  SceneDescription scene = read_mitsuba(folder, "<sensor type=\"perspective\"/>" + bsdf, version);
  EXPECT_THAT(scene.warnings, IsEmpty()) << bsdf;
  return scene;
}

template <typename Model>
Model model_of(const SceneDescription& scene) {
  return std::get<Model>(scene.bsdfs.back().model);
}

template <typename Model>
Model model_of(const std::string& bsdf, const std::string& version = "3.0.0") {
  return model_of<Model>(scene_of(bsdf, version));
}

const std::string kTexture =
    R"(<texture type="bitmap" name="NAME"><string name="filename" value="map.png"/></texture>)";

std::string texture(const std::string& name) {
  std::string xml = kTexture;
  return xml.replace(xml.find("NAME"), 4, name);
}

TEST(MitsubaBsdf, DiffuseAndRoughDiffuse) {
  EXPECT_EQ(model_of<DiffuseBsdf>(R"(<bsdf type="diffuse"/>)").reflectance.value, Color(0.5f));
  EXPECT_EQ(model_of<DiffuseBsdf>(R"(<bsdf type="diffuse">
    <rgb name="reflectance" value=".1, .2 0.3"/></bsdf>)")
                .reflectance.value,
            Color(.1f, .2f, .3f));
  const auto rough = model_of<RoughDiffuseBsdf>(R"(<bsdf type="roughdiffuse">
    <float name="alpha" value="0.3"/><boolean name="useFastApprox" value="false"/></bsdf>)",
                                                "0.6.0");
  EXPECT_FLOAT_EQ(rough.alpha.value, 0.3f);
}

TEST(MitsubaBsdf, ColoursInEveryForm) {
  const auto reflectance = [](const std::string& property) {
    return model_of<DiffuseBsdf>("<bsdf type=\"diffuse\">" + property + "</bsdf>")
        .reflectance.value;
  };
  EXPECT_EQ(reflectance(R"(<spectrum name="reflectance" value="0.25"/>)"), Color(0.25f));
  EXPECT_EQ(reflectance(R"(<spectrum name="reflectance" value="0.1, 0.2, 0.3"/>)"),
            Color(.1f, .2f, .3f));
  EXPECT_EQ(reflectance(R"(<float name="reflectance" value="0.25"/>)"), Color(0.25f));
  EXPECT_EQ(reflectance(R"(<rgb name="reflectance" value="#ff0033"/>)"), Color(1, 0, 0.2f));
  EXPECT_NEAR(reflectance(R"(<srgb name="reflectance" value="0.5"/>)").g, 0.214041f, 1e-5f);
  EXPECT_NEAR(reflectance(R"(<srgb name="reflectance" value="#FFBC00"/>)").g, 0.502886f, 1e-5f);
  const Color pairs = reflectance(R"(<spectrum name="reflectance" value="360:0.3, 830:0.3"/>)");
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(pairs[i], 0.3f, 1e-4f);
  EXPECT_EQ(reflectance(R"(<spectrum type="uniform" name="reflectance">
    <float name="value" value="0.7"/></spectrum>)"),
            Color(0.7f));
  EXPECT_THAT(mitsuba_error(R"(<bsdf type="diffuse"><rgb name="reflectance" value="1 2"/></bsdf>)"),
              HasSubstr("not a colour"));
}

TEST(MitsubaBsdf, SpectraInFilesAndListsAreThoseOfPairs) {
  const TemporaryFolder folder;
  folder.write("red.spd", "# reflectance\n360 0.1\n\n 550\t0.2 # nm\r\n600 0.9\n830 0.8\n");
  folder.write("bad.spd", "360 0.1\n400\n");
  const auto reflectance = [&](const std::string& spectrum) {
    const SceneDescription scene = read_mitsuba(
        folder, "<sensor type=\"perspective\"/><bsdf type=\"diffuse\">" + spectrum + "</bsdf>");
    EXPECT_THAT(scene.warnings, IsEmpty());
    return model_of<DiffuseBsdf>(scene).reflectance.value;
  };
  const Color pairs =
      reflectance(R"(<spectrum name="reflectance" value="360:0.1, 550:0.2, 600:0.9, 830:0.8"/>)");
  EXPECT_GT(pairs.r, 2 * pairs.b);
  EXPECT_EQ(reflectance(R"(<spectrum name="reflectance" filename="red.spd"/>)"), pairs);
  EXPECT_EQ(reflectance(R"(<spectrum name="reflectance" type="irregular">
    <string name="wavelengths" value="600, 360, 550, 830"/>
    <string name="values" value="0.9, 0.1, 0.2, 0.8"/></spectrum>)"),
            pairs);
  const auto error = [&](const std::string& spectrum) -> std::string {
    try {
      reflectance(spectrum);
      return "";
    } catch (const std::exception& e) {
      return e.what();
    }
  };
  EXPECT_THAT(error(R"(<spectrum name="reflectance" filename="bad.spd"/>)"),
              HasSubstr("line 2 of 'bad.spd'"));
  EXPECT_THAT(error(R"(<spectrum name="reflectance" filename="none.spd"/>)"),
              HasSubstr("does not exist"));
  EXPECT_THAT(error(R"(<spectrum name="reflectance" type="irregular">
    <string name="wavelengths" value="400, 500"/><string name="values" value="1"/></spectrum>)"),
              HasSubstr("2 wavelengths and 1 values"));
}

TEST(MitsubaBsdf, Conductors) {
  const auto smooth = model_of<ConductorBsdf>(R"(<bsdf type="conductor">
    <string name="material" value="Au"/></bsdf>)");
  EXPECT_NEAR(smooth.eta.r, 0.143f, 1e-3f);
  EXPECT_EQ(smooth.alpha_u.value, 0);
  const auto mirror = model_of<ConductorBsdf>(R"(<bsdf type="conductor"/>)", "3.0.0");
  EXPECT_EQ(mirror.k, Color(1));
  EXPECT_NEAR(model_of<ConductorBsdf>(R"(<bsdf type="conductor"/>)", "0.6.0").k.r, 3.913f, 1e-3f)
      << "copper is the default of the old format";
  const std::string eta = R"(<bsdf type="conductor"><rgb name="eta" value="2"/></bsdf>)";
  EXPECT_NEAR(model_of<ConductorBsdf>(eta, "0.6.0").k.r, 3.913f, 1e-3f) << "for k alone too";
  EXPECT_EQ(model_of<ConductorBsdf>(eta, "0.6.0").eta, Color(2));
  EXPECT_EQ(model_of<ConductorBsdf>(eta, "3.0.0").k, Color(1));
  const auto rough = model_of<ConductorBsdf>(R"(<bsdf type="roughconductor">
    <string name="distribution" value="ggx"/><float name="alphaU" value="0.1"/>
    <float name="alphaV" value="0.3"/><float name="extEta" value="2"/>
    <rgb name="eta" value="2, 2, 4"/><rgb name="k" value="6"/>
    <spectrum name="specularReflectance" value="0.9"/></bsdf>)",
                                             "0.6.0");
  EXPECT_EQ(rough.eta, Color(1, 1, 2));
  EXPECT_EQ(rough.k, Color(3));
  EXPECT_FLOAT_EQ(rough.alpha_v.value, 0.3f);
  EXPECT_EQ(rough.distribution, Microfacet::Ggx);
  EXPECT_EQ(rough.specular_reflectance.value, Color(0.9f));
}

TEST(MitsubaBsdf, Dielectrics) {
  const auto plain = model_of<DielectricBsdf>(R"(<bsdf type="dielectric"/>)");
  EXPECT_FLOAT_EQ(plain.int_ior, 1.5046f);
  EXPECT_FLOAT_EQ(plain.ext_ior, 1.000277f);
  const auto named = model_of<DielectricBsdf>(R"(<bsdf type="dielectric">
    <string name="intIOR" value="diamond"/><string name="extIOR" value="vacuum"/></bsdf>)",
                                              "0.6.0");
  EXPECT_FLOAT_EQ(named.int_ior, 2.419f);
  EXPECT_FLOAT_EQ(named.ext_ior, 1);
  const auto rough = model_of<DielectricBsdf>(R"(<bsdf type="roughdielectric">
    <float name="int_ior" value="1.33"/><float name="alpha" value="0.05"/></bsdf>)");
  EXPECT_FLOAT_EQ(rough.alpha_u.value, 0.05f);
  EXPECT_FLOAT_EQ(rough.alpha_v.value, 0.05f);
  EXPECT_FLOAT_EQ(model_of<ThinDielectricBsdf>(R"(<bsdf type="thindielectric">
    <float name="int_ior" value="1.4"/></bsdf>)")
                      .int_ior,
                  1.4f);
}

TEST(MitsubaBsdf, Plastics) {
  const auto plain = model_of<PlasticBsdf>(R"(<bsdf type="plastic"/>)");
  EXPECT_FLOAT_EQ(plain.int_ior, 1.49f);
  EXPECT_EQ(plain.alpha.value, 0);
  const auto rough = model_of<PlasticBsdf>(R"(<bsdf type="roughplastic">
    <boolean name="nonlinear" value="true"/><float name="alpha" value="0.25"/>
    <rgb name="diffuseReflectance" value="0.1"/></bsdf>)",
                                           "0.5.0");
  EXPECT_TRUE(rough.nonlinear);
  EXPECT_FLOAT_EQ(rough.alpha.value, 0.25f);
  EXPECT_EQ(rough.diffuse_reflectance.value, Color(0.1f));
}

TEST(MitsubaBsdf, PhongAndWard) {
  EXPECT_FLOAT_EQ(model_of<PhongBsdf>(
                      R"(<bsdf type="phong"><float name="exponent" value="200"/></bsdf>)", "0.6.0")
                      .exponent.value,
                  200);
  const auto ward = model_of<WardBsdf>(R"(<bsdf type="ward"><float name="alpha" value="0.4"/>
    <string name="variant" value="ward-duer"/></bsdf>)",
                                       "0.6.0");
  EXPECT_EQ(ward.variant, WardBsdf::Variant::WardDuer);
  EXPECT_FLOAT_EQ(ward.alpha_u.value, 0.4f);
}

TEST(MitsubaBsdf, WrappersReferToEarlierEntries) {
  const SceneDescription scene = scene_of(R"(<bsdf type="mask"><float name="opacity" value="0.3"/>
    <bsdf type="twosided"><bsdf type="coating"><float name="thickness" value="2"/>
      <rgb name="sigma_a" value="0.5"/><bsdf type="roughconductor"/></bsdf>
      <bsdf type="diffuse"/></bsdf></bsdf>)");
  ASSERT_EQ(scene.bsdfs.size(), 5u);
  const auto mask = model_of<MaskBsdf>(scene);
  EXPECT_FLOAT_EQ(mask.opacity.value, 0.3f);
  const auto& sides = std::get<TwoSidedBsdf>(scene.bsdfs[mask.nested].model);
  const auto& coating = std::get<CoatingBsdf>(scene.bsdfs[sides.front].model);
  EXPECT_FLOAT_EQ(coating.thickness, 2);
  EXPECT_EQ(coating.sigma_a.value, Color(0.5f));
  EXPECT_TRUE(std::holds_alternative<ConductorBsdf>(scene.bsdfs[coating.nested].model));
  EXPECT_TRUE(std::holds_alternative<DiffuseBsdf>(scene.bsdfs[sides.back].model));
  EXPECT_LT(coating.nested, sides.front);
}

TEST(MitsubaBsdf, OneNestedBsdfServesBothSides) {
  const auto sides =
      model_of<TwoSidedBsdf>(R"(<bsdf type="twosided"><bsdf type="diffuse"/></bsdf>)");
  EXPECT_EQ(sides.front, sides.back);
}

TEST(MitsubaBsdf, BlendAndMixture) {
  const SceneDescription blended =
      scene_of("<bsdf type=\"blendbsdf\">" + texture("weight") +
               R"(<bsdf type="diffuse" id="first"/><bsdf type="plastic" id="second"/></bsdf>)");
  const auto blend = model_of<BlendBsdf>(blended);
  EXPECT_EQ(blend.weight.texture, 0);
  EXPECT_EQ(blended.bsdfs[blend.first].name, "first");
  EXPECT_EQ(blended.bsdfs[blend.second].name, "second");
  const SceneDescription mixed = scene_of(R"(<bsdf type="mixturebsdf">
    <string name="weights" value="0.2, 0.3, 0.5"/><bsdf type="diffuse"/><bsdf type="plastic"/>
    <bsdf type="conductor"/></bsdf>)",
                                          "0.6.0");
  const auto last = model_of<BlendBsdf>(mixed);
  EXPECT_FLOAT_EQ(last.weight.value, 0.5f);
  EXPECT_FLOAT_EQ(std::get<BlendBsdf>(mixed.bsdfs[last.first].model).weight.value, 0.6f);
}

TEST(MitsubaBsdf, NullNormalMapAndBumpMap) {
  model_of<NullBsdf>(R"(<bsdf type="null"/>)");
  const auto map = model_of<NormalMapBsdf>("<bsdf type=\"normalmap\">" + texture("normalmap") +
                                           R"(<bsdf type="diffuse"/></bsdf>)");
  EXPECT_EQ(map.texture, 0);
  EXPECT_EQ(map.nested, 0);
  const auto bump = model_of<BumpMapBsdf>(R"(<bsdf type="bumpmap"><texture type="scale">
    <float name="scale" value="5"/>)" + texture("x") +
                                              R"(</texture><bsdf type="diffuse"/></bsdf>)",
                                          "0.6.0");
  EXPECT_FLOAT_EQ(bump.scale, 5);
  EXPECT_EQ(bump.texture, 0);
}

TEST(MitsubaBsdf, StandInsWarn) {
  const auto warning = [](const std::string& bsdf) {
    const SceneDescription scene = read_mitsuba("<sensor type=\"perspective\"/>" + bsdf);
    return scene.warnings.size() == 1 ? scene.warnings[0] : "";
  };
  EXPECT_THAT(
      warning(R"(<bsdf type="roughconductor"><string name="distribution" value="as"/></bsdf>)"),
      HasSubstr("'as'"));
  EXPECT_THAT(warning(R"(<bsdf type="conductor"><string name="material" value="Xx"/></bsdf>)"),
              HasSubstr("copper"));
  EXPECT_THAT(warning(R"(<bsdf type="dielectric"><string name="int_ior" value="jelly"/></bsdf>)"),
              HasSubstr("jelly"));
  EXPECT_THAT(warning(R"(<bsdf type="principled"/>)"), HasSubstr("principled"));
  EXPECT_THAT(warning(R"(<bsdf type="roughcoating"><bsdf type="diffuse"/></bsdf>)"),
              HasSubstr("smooth coating"));
}

TEST(MitsubaBsdf, PrincipledBecomesABlend) {
  const SceneDescription scene = read_mitsuba(R"(<bsdf type="principled">
    <rgb name="base_color" value="0.8, 0.1, 0.1"/><float name="metallic" value="0.25"/>
    <float name="roughness" value="0.5"/></bsdf>)");
  const auto blend = model_of<BlendBsdf>(scene);
  EXPECT_FLOAT_EQ(blend.weight.value, 0.25f);
  EXPECT_FLOAT_EQ(std::get<PlasticBsdf>(scene.bsdfs[blend.first].model).alpha.value, 0.25f);
  EXPECT_EQ(std::get<ConductorBsdf>(scene.bsdfs[blend.second].model).specular_reflectance.value,
            Color(0.8f, 0.1f, 0.1f));
}

TEST(MitsubaBsdf, PrincipledSquaresTheTextureOfItsRoughness) {
  const TemporaryFolder folder;
  folder.write("map.png", sample_png());
  const SceneDescription scene = read_mitsuba(folder, R"(
    <texture type="bitmap" id="map"><string name="filename" value="map.png"/></texture>
    <bsdf type="principled"><ref id="map" name="roughness"/></bsdf>
    <bsdf type="principled"><texture type="checkerboard" name="roughness">
      <float name="color0" value="0.5"/><ref id="map" name="color1"/></texture></bsdf>)");
  const auto texture_of = [&](int bsdf) {
    return scene.textures[std::get<PlasticBsdf>(scene.bsdfs[bsdf].model).alpha.texture].model;
  };
  const Image& original = *std::get<BitmapTexture>(scene.textures[0].model).image;
  const auto checkers = std::get<CheckerboardTexture>(texture_of(1));
  EXPECT_FLOAT_EQ(checkers.color0.value.r, 0.25f);
  const auto& nested = scene.textures[checkers.color1.texture].model;
  for (const auto& texture : {texture_of(0), nested}) {
    const Image& square = *std::get<BitmapTexture>(texture).image;
    for (int x = 0; x < 4; ++x) {
      EXPECT_FLOAT_EQ(square.color(x, 1).g, sqr(luminance(original.color(x, 1))));
    }
  }
}

}  // namespace
}  // namespace guidelight::test
