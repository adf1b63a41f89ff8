#pragma once

#include "ui/document.h"
#include "ui/picture_developer.h"

namespace guidelight {

/// The picture with the guides that are followed drawn over it, named, and a legend below: for
/// slides and papers. Small pictures are enlarged. To be called between the beginning and the end
/// of a frame.
DisplayImage paint_figure(const Document& document, const Picture& picture);

}  // namespace guidelight
