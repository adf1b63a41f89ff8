#pragma once

#include <memory>

#include "ui/tools/tool.h"

namespace guidelight {

/// The tool in hand, shared by the views; the default one picks pixels to inspect.
class Toolbox {
 public:
  Toolbox();

  Tool& tool() { return *tool_; }
  const Tool& tool() const { return *tool_; }
  void use(std::unique_ptr<Tool> tool) { tool_ = std::move(tool); }
  void use_default();
  /// Puts a tool aside that has done its work.
  void tidy() {
    if (tool_->finished()) use_default();
  }

  template <class Kind>
  bool holds() const {
    return dynamic_cast<const Kind*>(tool_.get()) != nullptr;
  }

 private:
  std::unique_ptr<Tool> tool_;
};

}  // namespace guidelight
