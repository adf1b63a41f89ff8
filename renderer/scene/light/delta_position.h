#pragma once

#include "renderer/scene/light/light.h"

namespace guidelight {

/// A direct sample of a light at one point, of radiant intensity [W/sr] towards the reference; `wi`
/// and `distance` lead from the reference to it. pdf_direction is the density of emitting that way.
inline DirectSample point_sample(Vec3 position, Vec3 wi, float distance, Color intensity,
                                 float pdf_direction) {
  DirectSample sample;
  sample.wi = wi;
  sample.distance = distance;
  sample.radiance = intensity / sqr(distance);
  sample.pdf = 1;
  sample.position = position;
  sample.pdf_position = 1;
  sample.pdf_direction = pdf_direction;
  sample.cos_light = 1;
  return sample;
}

/// First ray of a light path from a single point.
inline EmissionSample point_emission(Vec3 position, Vec3 w, Color intensity, float pdf_direction) {
  EmissionSample sample;
  sample.ray = {position, w, kInfinity};
  sample.weight = intensity / pdf_direction;
  sample.pdf_position = 1;
  sample.pdf_direction = pdf_direction;
  sample.cos_light = 1;
  return sample;
}

}  // namespace guidelight
