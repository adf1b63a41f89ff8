#include "renderer/io/sun_position.h"

namespace guidelight {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Days since noon of 1 January 2000, universal time. The date may overflow its month (Hatcher
/// 1984).
double days_since_2000(const PlaceAndTime& when, double universal_hour) {
  const int shift = (when.month - 14) / 12;
  const int64_t day_number = (1461 * (int64_t{when.year} + 4800 + shift)) / 4 +
                             (367 * (when.month - 2 - 12 * int64_t{shift})) / 12 -
                             (3 * ((int64_t{when.year} + 4900 + shift) / 100)) / 4 + when.day -
                             32075;
  return static_cast<double>(day_number) - 0.5 + universal_hour / 24 - 2451545.0;
}

}  // namespace

Vec3 sun_direction(const PlaceAndTime& when) {
  const double hour =
      when.hour - when.timezone + (when.minute + static_cast<double>(when.second) / 60) / 60;
  const double days = days_since_2000(when, hour);

  // Ecliptic coordinates.
  const double omega = 2.1429 - 0.0010394594 * days;
  const double mean_longitude = 4.8950630 + 0.017202791698 * days;
  const double anomaly = 6.2400600 + 0.0172019699 * days;
  const double longitude = mean_longitude + 0.03341607 * std::sin(anomaly) +
                           0.00034894 * std::sin(2 * anomaly) - 0.0001134 -
                           0.0000203 * std::sin(omega);
  const double obliquity = 0.4090928 - 6.2140e-9 * days + 0.0000396 * std::cos(omega);

  // Celestial coordinates.
  const double ascension =
      std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude));
  const double declination = std::asin(std::sin(obliquity) * std::sin(longitude));

  // Local coordinates.
  const double greenwich_sidereal = 6.6974243242 + 0.0657098283 * days + hour;
  const double hour_angle = (greenwich_sidereal * 15 + when.longitude) * kDegree - ascension;
  const double latitude = when.latitude * kDegree;
  const double zenith =
      std::acos(std::cos(latitude) * std::cos(hour_angle) * std::cos(declination) +
                std::sin(declination) * std::sin(latitude));
  const double azimuth =  // from north towards east
      std::atan2(-std::sin(hour_angle), std::tan(declination) * std::cos(latitude) -
                                            std::sin(latitude) * std::cos(hour_angle));
  const double parallax = 6371.01 / 149597890 * std::sin(zenith);
  const double theta = zenith + parallax;
  return Vec3(std::sin(theta) * std::sin(azimuth), std::cos(theta),
              -std::sin(theta) * std::cos(azimuth));
}

}  // namespace guidelight
