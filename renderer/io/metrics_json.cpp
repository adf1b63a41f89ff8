#include "renderer/io/metrics_json.h"

#include <nlohmann/json.hpp>

namespace guidelight {

namespace {

nlohmann::json to_json(const ErrorMeasure& measure) {
  return {{"plain", measure.plain}, {"robust", measure.robust}};
}

}  // namespace

std::string metrics_json(const ImageMetrics& m) {
  const nlohmann::json line = {{"rms_relative_error", to_json(m.rms_relative_error)},
                               {"relative_mse", to_json(m.relative_mse)},
                               {"mean_absolute_error", to_json(m.mean_absolute_error)},
                               {"mean", m.mean},
                               {"reference_mean", m.reference_mean},
                               {"relative_bias", m.relative_bias},
                               {"rms_block_bias", m.rms_block_bias},
                               {"largest_block_bias", m.largest_block_bias},
                               {"pixels", m.pixels},
                               {"not_finite", m.not_finite},
                               {"black_reference", m.black_reference}};
  return line.dump();
}

}  // namespace guidelight
