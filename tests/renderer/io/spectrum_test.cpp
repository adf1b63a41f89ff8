#include "renderer/io/spectrum.h"

#include <gtest/gtest.h>

#include "renderer/io/material_data.h"
#include "renderer/io/sun_position.h"

namespace guidelight::test {
namespace {

void expect_near(Color actual, Color expected, float relative) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], relative * expected[i]) << i;
}

TEST(Spectrum, FlatReflectanceIsNeutral) {
  const std::vector<SpectralSample> flat = {{300, 0.4}, {900, 0.4}};
  expect_near(spectrum_to_rgb(flat, SpectrumUse::Reflectance), Color(0.4f), 1e-5f);
}

TEST(Spectrum, FlatEmissionIsEqualEnergyWhite) {
  // XYZ (1,1,1) times the sRGB matrix.
  const std::vector<SpectralSample> flat = {{300, 1}, {900, 1}};
  expect_near(spectrum_to_rgb(flat, SpectrumUse::Emission), Color(1.2048f, 0.9483f, 0.9089f),
              0.01f);
}

TEST(Spectrum, IlluminantAHasItsPublishedColour) {
  // CIE illuminant A, a black body of 2856 K, has x = 0.44758, y = 0.40745, which is XYZ
  // (1.0985, 1, 0.3558) and linear sRGB (1.8452, 0.8260, 0.2333) at unit luminance.
  const Color warm = blackbody_rgb(2856);
  expect_near(warm / luminance(warm), Color(1.8452f, 0.8260f, 0.2333f), 0.02f);
}

TEST(Spectrum, WarmBlackbodyIsRedAndRadiatesAsPlanckSays) {
  const Color warm = blackbody_rgb(2856);
  EXPECT_GT(warm.r, warm.g);
  EXPECT_GT(warm.g, warm.b);
  // Planck at 555 nm, 2856 K: 2hc²/λ⁵/(exp(hc/λkT)-1) = 255.7 W/(m² sr nm); the luminance, a mean
  // over the eye's curve, lies near it.
  EXPECT_NEAR(luminance(warm), 255.7f, 0.1f * 255.7f);
}

TEST(MaterialData, NamesOfBothDialects) {
  EXPECT_FLOAT_EQ(named_ior("bk7").value(), 1.5046f);
  EXPECT_FLOAT_EQ(named_ior("Diamond").value(), 2.419f);
  EXPECT_FALSE(named_ior("unobtainium"));
  EXPECT_EQ(named_conductor("none")->eta, Color(0));
  EXPECT_GT(named_conductor("Cu")->k.r, named_conductor("Cu")->k.b);
  EXPECT_EQ(named_conductor("Cu_palik")->eta, named_conductor("Cu")->eta);
  EXPECT_NE(named_conductor("V")->eta, named_conductor("VN")->eta);
  EXPECT_FALSE(named_conductor("Xx"));
}

TEST(SunPosition, NoonAndEquinox) {
  // Greenwich, 20 March 2010, an hour near true noon (equation of time -7.5 min): the sun stands in
  // the south (+z here) at 90° - latitude.
  PlaceAndTime when;
  when.month = 3, when.day = 20, when.hour = 12, when.minute = 7.5f;
  when.latitude = 51.5f, when.longitude = 0, when.timezone = 0;
  const Vec3 noon = sun_direction(when);
  EXPECT_NEAR(std::asin(noon.y) * 180 / kPi, 38.5f, 0.3f);
  EXPECT_GT(noon.z, 0.7f);
  EXPECT_NEAR(noon.x, 0, 0.02f);
  when.hour = 8;
  EXPECT_GT(sun_direction(when).x, 0.3f) << "the morning sun is in the east";
}

}  // namespace
}  // namespace guidelight::test
