#pragma once

#include <string>

#include "renderer/image/metrics.h"

namespace guidelight {

/// All figures of a comparison as one line of JSON; keys are the names of ImageMetrics.
std::string metrics_json(const ImageMetrics& metrics);

}  // namespace guidelight
