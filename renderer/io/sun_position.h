#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// Defaults are Mitsuba's: Tokyo, 10 July 2010, 15:00.
struct PlaceAndTime {
  int year = 2010;
  int month = 7;
  int day = 10;
  float hour = 15;  // local time
  float minute = 0;
  float second = 0;
  float latitude = 35.6894f;    // [degrees north]
  float longitude = 139.6917f;  // [degrees east]
  float timezone = 9;           // [hours] east of Greenwich
};

/// Unit vector towards the sun: +y is up, -z north, +x east. Blanco-Muriel et al. 2001, "Computing
/// the Solar Vector" (0.5 minutes of arc, 1999–2015).
Vec3 sun_direction(const PlaceAndTime& when);

}  // namespace guidelight
