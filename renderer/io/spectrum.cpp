#include "renderer/io/spectrum.h"

#include <algorithm>
#include <array>
#include <glm/ext/vector_double3.hpp>

namespace guidelight {
namespace {

constexpr int kFirst = 360;  // [nm]
constexpr int kLast = 830;
constexpr int kStep = 1;

/// A Gaussian with different widths on its two sides.
double lobe(double x, double mean, double inverse_left, double inverse_right) {
  const double t = (x - mean) * (x < mean ? inverse_left : inverse_right);
  return std::exp(-0.5 * t * t);
}

/// CIE 1931 colour matching functions: Wyman, Sloan, Shirley 2013, "Simple Analytic Approximations
/// to the CIE XYZ Color Matching Functions", equation 4 and listing 1 (multi-lobe fit).
glm::dvec3 matching_functions(double w) {
  return {1.056 * lobe(w, 599.8, 0.0264, 0.0323) + 0.362 * lobe(w, 442.0, 0.0624, 0.0374) -
              0.065 * lobe(w, 501.1, 0.0490, 0.0382),
          0.821 * lobe(w, 568.8, 0.0213, 0.0247) + 0.286 * lobe(w, 530.9, 0.0613, 0.0322),
          1.217 * lobe(w, 437.0, 0.0845, 0.0278) + 0.681 * lobe(w, 459.0, 0.0385, 0.0725)};
}

/// CIE standard illuminant D65, relative, every 10 nm from 360 to 780 nm (CIE 15:2004, table T.1).
constexpr std::array<double, 43> kDaylight = {
    46.64,  52.09,  49.98,  54.65,  82.75,  91.49,  93.43,  86.68,  104.86, 117.01, 117.81,
    114.86, 115.92, 108.81, 109.35, 107.80, 104.79, 107.69, 104.41, 104.05, 100.00, 96.33,
    95.79,  88.69,  90.01,  89.60,  87.70,  83.29,  83.70,  80.03,  80.21,  82.28,  78.28,
    69.72,  71.61,  74.35,  61.60,  69.89,  75.09,  63.59,  46.42,  66.81,  63.38};

double daylight(double wavelength) {
  const double position = std::clamp((wavelength - kFirst) / 10, 0.0, kDaylight.size() - 1.001);
  const size_t i = static_cast<size_t>(position);
  return std::lerp(kDaylight[i], kDaylight[i + 1], position - static_cast<double>(i));
}

/// IEC 61966-2-1.
glm::dvec3 xyz_to_linear_srgb(glm::dvec3 xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// Colour of spectrum × illuminant with the luminance of the illuminant scaled to 1.
template <typename Spectrum, typename Illuminant>
glm::dvec3 integrate(const Spectrum& spectrum, const Illuminant& illuminant) {
  glm::dvec3 xyz(0);
  double norm = 0;
  for (int w = kFirst; w <= kLast; w += kStep) {
    const glm::dvec3 matching = matching_functions(w) * illuminant(w);
    xyz += matching * spectrum(w);
    norm += matching.y;
  }
  return xyz_to_linear_srgb(xyz / norm);
}

double interpolate(std::span<const SpectralSample> samples, double wavelength) {
  const auto after = std::lower_bound(
      samples.begin(), samples.end(), wavelength,
      [](const SpectralSample& sample, double w) { return sample.wavelength < w; });
  if (after == samples.end()) return 0;
  if (after->wavelength == wavelength) return after->value;
  if (after == samples.begin()) return 0;
  const SpectralSample& before = *(after - 1);
  const double t = (wavelength - before.wavelength) / (after->wavelength - before.wavelength);
  return std::lerp(before.value, after->value, t);
}

double flat(double) { return 1; }

}  // namespace

Color spectrum_to_rgb(std::span<const SpectralSample> samples, SpectrumUse use) {
  const auto spectrum = [&](double w) { return interpolate(samples, w); };
  if (use == SpectrumUse::Emission) return glm::max(Color(integrate(spectrum, flat)), Color(0));
  // The fits of the matching functions leave daylight a trace off neutral; a ratio of colours does
  // not.
  const Color rgb(integrate(spectrum, daylight) / integrate(flat, daylight));
  return glm::clamp(rgb, Color(0), Color(use == SpectrumUse::Reflectance ? 1 : kInfinity));
}

Color blackbody_rgb(double temperature) {
  const auto planck = [&](double wavelength) {  // CODATA 2018 constants, 2hc² and hc/k
    const double metres = wavelength * 1e-9;
    const double per_metre =
        1.191042972e-16 / std::pow(metres, 5) / std::expm1(1.438776877e-2 / (metres * temperature));
    return per_metre * 1e-9;
  };
  return glm::max(Color(integrate(planck, flat)), Color(0));
}

Color srgb_to_linear(Color encoded) {
  Color linear;
  for (int i = 0; i < 3; ++i) {
    const float v = encoded[i];
    linear[i] = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
  }
  return linear;
}

}  // namespace guidelight
