#include "renderer/scene/light/daylight.h"

#include <algorithm>
#include <array>

namespace guidelight {

namespace {

/// ∫ȳ dλ over the CIE 1931 observer [nm]: turns tristimulus sums into means over the spectrum.
constexpr float kYIntegral = 106.857f;
constexpr float kLumensPerWatt = 683;

/// CIE 1931 colour matching functions, multi-lobe fit (Wyman, Sloan & Shirley, JCGT 2013).
Vec3 color_matching(float wavelength) {
  const auto lobe = [&](float peak, float below, float above) {
    const float t = (wavelength - peak) / (wavelength < peak ? below : above);
    return std::exp(-0.5f * t * t);
  };
  return {1.056f * lobe(599.8f, 37.9f, 31.0f) + 0.362f * lobe(442.0f, 16.0f, 26.7f) -
              0.065f * lobe(501.1f, 20.4f, 26.2f),
          0.821f * lobe(568.8f, 46.9f, 40.5f) + 0.286f * lobe(530.9f, 16.3f, 31.1f),
          1.217f * lobe(437.0f, 11.8f, 36.0f) + 0.681f * lobe(459.0f, 26.0f, 13.8f)};
}

/// Linear sRGB of CIE XYZ; colours outside the gamut are cut.
Color rgb_of_xyz(Vec3 xyz) {
  const Color rgb(3.2404542f * xyz.x - 1.5371385f * xyz.y - 0.4985314f * xyz.z,
                  -0.9692660f * xyz.x + 1.8760108f * xyz.y + 0.0415560f * xyz.z,
                  0.0556434f * xyz.x - 0.2040259f * xyz.y + 1.0572252f * xyz.z);
  return glm::max(rgb, Color(0));
}

constexpr float kFirstWavelength = 380;  // [nm]
constexpr float kWavelengthStep = 10;

/// Sun outside the atmosphere, 380 to 750 nm [W/(m² sr nm)] (table 2).
constexpr std::array kSolarRadiance = {
    16559.0f, 16233.7f, 21127.5f, 25888.2f, 25829.1f, 24232.3f, 26760.5f, 29658.3f,
    30545.4f, 30057.5f, 30663.7f, 28830.4f, 28712.1f, 27825.0f, 27100.6f, 27233.6f,
    26361.3f, 25503.8f, 25060.2f, 25311.6f, 25355.9f, 25134.2f, 24631.5f, 24173.2f,
    23685.3f, 23212.1f, 22827.7f, 22339.8f, 21970.2f, 21526.7f, 21097.9f, 20728.3f,
    20240.4f, 19870.8f, 19427.2f, 19072.4f, 18628.9f, 18259.2f};

/// Absorption of ozone at the same wavelengths [1/cm] (table 2; none below 450 nm).
constexpr std::array kOzone = {0.0f,   0.0f,   0.0f,   0.0f,   0.0f,   0.0f,   0.0f,   0.003f,
                               0.006f, 0.009f, 0.014f, 0.021f, 0.03f,  0.04f,  0.048f, 0.063f,
                               0.075f, 0.085f, 0.103f, 0.12f,  0.12f,  0.115f, 0.125f, 0.12f,
                               0.105f, 0.09f,  0.079f, 0.067f, 0.057f, 0.048f, 0.036f, 0.028f,
                               0.023f, 0.018f, 0.014f, 0.011f, 0.01f,  0.009f};
static_assert(kOzone.size() == kSolarRadiance.size());

/// Polynomial of degree 3 in θ, coefficients from the highest.
float cubic(float theta, float c3, float c2, float c1, float c0) {
  return ((c3 * theta + c2) * theta + c1) * theta + c0;
}

}  // namespace

float Daylight::Perez::operator()(float cos_theta, float gamma) const {
  return (1 + a * std::exp(b / cos_theta)) *
         (1 + c * std::exp(d * gamma) + e * sqr(std::cos(gamma)));
}

Daylight::Daylight(Vec3 sun_direction, float turbidity)
    : sun_direction_(glm::normalize(sun_direction)),
      turbidity_(std::clamp(turbidity, 1.7f, 10.0f)) {
  const float t = turbidity_;
  // Appendix A.2.
  luminance_ = {0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
  x_ = {-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f,
        -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f};
  y_ = {-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f,
        -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f};

  const float theta = std::min(std::acos(std::clamp(sun_direction_.y, -1.0f, 1.0f)), 0.5f * kPi);
  const float chi = (4.0f / 9 - t / 120) * (kPi - 2 * theta);
  const float zenith_luminance =  // [kcd/m²]
      std::max(0.0f, (4.0453f * t - 4.9710f) * std::tan(chi) - 0.2155f * t + 2.4192f);
  const float zenith_x = t * t * cubic(theta, 0.00166f, -0.00375f, 0.00209f, 0) +
                         t * cubic(theta, -0.02903f, 0.06377f, -0.03202f, 0.00394f) +
                         cubic(theta, 0.11693f, -0.21196f, 0.06052f, 0.25886f);
  const float zenith_y = t * t * cubic(theta, 0.00275f, -0.00610f, 0.00317f, 0) +
                         t * cubic(theta, -0.04214f, 0.08970f, -0.04153f, 0.00516f) +
                         cubic(theta, 0.15346f, -0.26756f, 0.06670f, 0.26688f);
  // Equation 4: values are relative to the zenith, whose angle to the sun is θ.
  luminance_scale_ = 1000 * zenith_luminance / (kLumensPerWatt * kYIntegral) / luminance_(1, theta);
  x_scale_ = zenith_x / x_(1, theta);
  y_scale_ = zenith_y / y_(1, theta);
}

Color Daylight::sky_radiance(Vec3 direction) const {
  if (!(direction.y > 0)) return Color(0);
  const float gamma = std::acos(std::clamp(glm::dot(direction, sun_direction_), -1.0f, 1.0f));
  const float luminance = luminance_scale_ * luminance_(direction.y, gamma);
  const float x = x_scale_ * x_(direction.y, gamma);
  const float y = y_scale_ * y_(direction.y, gamma);
  return rgb_of_xyz(luminance * Vec3(x / y, 1, (1 - x - y) / y));
}

Color Daylight::sun_radiance() const {
  if (!(sun_direction_.y > 0)) return Color(0);
  // Appendix A.1. The bands of water vapour and mixed gases begin at 690 nm, where the eye is blind
  // to all but a thousandth of the light, and are left out.
  const float degrees = std::acos(std::min(sun_direction_.y, 1.0f)) * 180 / kPi;
  const float air_mass = 1 / (sun_direction_.y + 0.15f * std::pow(93.885f - degrees, -1.253f));
  const float beta = 0.04608365822050f * turbidity_ - 0.04586025928522f;
  constexpr float kOzoneThickness = 0.35f;  // [cm]
  Vec3 xyz(0);
  for (size_t i = 0; i < kSolarRadiance.size(); ++i) {
    const float wavelength = kFirstWavelength + kWavelengthStep * static_cast<float>(i);
    const float micrometres = wavelength / 1000;
    const float rayleigh = 0.008735f * std::pow(micrometres, -4.08f);
    const float aerosol = beta * std::pow(micrometres, -1.3f);
    const float ozone = kOzone[i] * kOzoneThickness;
    const float transmittance = std::exp(-air_mass * (rayleigh + aerosol + ozone));
    xyz += kSolarRadiance[i] * transmittance * kWavelengthStep * color_matching(wavelength);
  }
  return rgb_of_xyz(xyz / kYIntegral);
}

}  // namespace guidelight
