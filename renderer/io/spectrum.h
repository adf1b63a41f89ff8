#pragma once

#include <span>

#include "renderer/math/vector.h"

/// Spectra become linear sRGB as soon as they are read.
namespace guidelight {

/// Reflectances and coefficients are seen under daylight (D65), so that a flat spectrum is neutral.
/// Emission is what it is: a flat spectrum is the reddish equal-energy white, of luminance 1.
enum class SpectrumUse { Reflectance, Coefficient, Emission };

struct SpectralSample {
  double wavelength;  // [nm]
  double value;
};

/// Linear interpolation between samples in ascending order of wavelength, zero outside of them.
/// Reflectances are clamped to 0..1, other colours to ≥ 0.
Color spectrum_to_rgb(std::span<const SpectralSample> samples, SpectrumUse use);

/// Radiance of a black body at a temperature [K], per nm as in Mitsuba: W/(m² sr nm), as a colour.
Color blackbody_rgb(double temperature);

/// sRGB transfer function, 0..1 to linear.
Color srgb_to_linear(Color encoded);

}  // namespace guidelight
