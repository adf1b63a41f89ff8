#include "ui/tools/toolbox.h"

#include "ui/tools/inspect_tool.h"

namespace guidelight {

Toolbox::Toolbox() : tool_(std::make_unique<InspectTool>()) {}

void Toolbox::use_default() { tool_ = std::make_unique<InspectTool>(); }

}  // namespace guidelight
