#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace guidelight {

/// One setting of an integrator, described once; the panel in the viewer, `--set key=value`, the
/// metadata of exported files and docs/integrators.md all come from it. It points into the settings
/// it describes.
struct Parameter {
  struct Choice {
    int* value;
    std::vector<std::string> names;  // *value indexes them
  };

  std::string key;    // snake_case, as on the command line
  std::string label;  // as in the panel
  std::string help;   // one sentence
  std::string unit;   // empty if it has none
  std::variant<bool*, int*, float*, Choice> value;
  double minimum = 0;
  double maximum = 0;  // inclusive
  bool logarithmic = false;
  std::string unused = {};  // why it has no effect as the others are; empty if it has
};

/// The settings of one integrator: plain data in the derived struct, plus their description.
class IntegratorSettings {
 public:
  virtual ~IntegratorSettings() = default;
  virtual std::vector<Parameter> parameters() = 0;
  virtual std::unique_ptr<IntegratorSettings> clone() const = 0;
};

/// Sets one parameter from text. Throws Error naming the key, the text and what is allowed.
void set_parameter(IntegratorSettings& settings, const std::string& key, const std::string& text);

/// A parameter's value as text that set_parameter reads back to the same value.
std::string parameter_text(const Parameter& parameter);

}  // namespace guidelight
