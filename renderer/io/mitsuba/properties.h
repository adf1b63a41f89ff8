#pragma once

#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "renderer/io/mitsuba/document.h"
#include "renderer/io/spectrum.h"
#include "renderer/math/vector.h"

namespace guidelight::mitsuba {

/// Collects warnings; each subject is reported once, where it is met first.
class Warnings {
 public:
  explicit Warnings(std::vector<std::string>& sentences) : sentences_(sentences) {}

  /// `subject` tells apart what is the same warning.
  void add(const Source& source, const std::string& subject, const std::string& sentence) {
    if (subjects_.insert(subject).second) {
      sentences_.push_back(source.to_string() + ": " + sentence);
    }
  }

 private:
  std::vector<std::string>& sentences_;
  std::set<std::string> subjects_;
};

/// "bsdf 'plastic'".
std::string plugin_name(const Node& node);

/// Colour of a float, spectrum, rgb, srgb or blackbody property. Throws Error if it cannot be read.
Color parse_color(const Node& node, SpectrumUse use);

/// Colour of a spectrum known at some wavelengths [nm], in any order; linear in between. Throws
/// Error if there are not as many values, or none.
Color sampled_color(const Node& node, std::span<const double> wavelengths,
                    std::span<const double> values, SpectrumUse use);

/// What is written inside a plugin, by name. Remembers what was asked for, to warn about the rest.
/// Names may be given in either dialect; the first that is present of several is taken.
/// All throw Error with file and line for a value of another type or a number that is not finite.
class Properties {
 public:
  using Names = std::initializer_list<const char*>;

  Properties(const Node& node, Warnings& warnings) : node_(node), warnings_(warnings) {}

  const Node& node() const { return node_; }

  /// Property or nested plugin of that name, or nullptr.
  const Node* find(Names names);
  /// Nested plugins of that kind, in order.
  std::vector<const Node*> objects(const char* tag);
  /// The first of them, or nullptr.
  const Node* object(const char* tag);

  float number(Names names, float fallback);
  int integer(Names names, int fallback);
  bool boolean(Names names, bool fallback);
  std::string text(Names names, const std::string& fallback);
  Vec3 vector(Names names, Vec3 fallback);
  Mat4 transform(Names names);

  /// These do not matter to us.
  void ignore(Names names);
  /// Warns about everything that nobody asked for.
  void warn_about_the_rest();

 private:
  const Node& node_;
  Warnings& warnings_;
  std::set<const Node*> used_;
};

}  // namespace guidelight::mitsuba
