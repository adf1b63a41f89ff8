#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// The clear sky and the sun seen through it (Preetham, Shirley & Smits, A Practical Analytic Model
/// for Daylight, 1999). Directions are unit and local, with up = +y. Radiance is averaged over the
/// visible spectrum, [W/(m² sr nm)], the unit in which Mitsuba's sun and sky give it: luminance /
/// (683 · 106.857).
class Daylight {
 public:
  /// Turbidity is kept within 1.7 to 10, where the model was fitted. A sun below the horizon gives
  /// the sky of sunset and no sunlight.
  Daylight(Vec3 sun_direction, float turbidity);

  /// Black below the horizon: the model has no ground.
  Color sky_radiance(Vec3 direction) const;
  /// Mean radiance of the sun's disc of angular radius kSunAngularRadius.
  Color sun_radiance() const;

  static constexpr float kSunAngularRadius = 0.2666f * kPi / 180;  // [rad]

 private:
  /// Coefficients of Perez' distribution, equation 3.
  struct Perez {
    float a, b, c, d, e;
    float operator()(float cos_theta, float gamma) const;
  };

  Vec3 sun_direction_;
  float turbidity_;
  Perez luminance_;
  Perez x_;
  Perez y_;
  // Values at the zenith over the distribution there, so that a product gives the value anywhere.
  float luminance_scale_;
  float x_scale_;
  float y_scale_;
};

}  // namespace guidelight
