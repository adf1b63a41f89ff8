#pragma once

#include "ui/document.h"

namespace guidelight {

/// Adds a guide with a name and a colour of its own and selects it; `label` names the step for
/// undo.
void add_guide(Document& document, GuidePath guide, const std::string& label);
void duplicate_guide(Document& document, size_t guide);
void delete_guide(Document& document, size_t guide);

}  // namespace guidelight
