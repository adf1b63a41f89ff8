#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer/error.h"

/// A Mitsuba scene file as a tree: variables replaced, includes spliced in, references resolved,
/// names in one dialect. What the plugins mean is the importer's business.
namespace guidelight::mitsuba {

struct Source {
  std::shared_ptr<const std::string> file;
  int line = 0;

  std::string to_string() const { return fmt::format("{}:{}", *file, line); }
};

struct Node;

struct Child {
  std::string name;  // canonical; of the reference where the node was referred to
  const Node* node;
};

/// An element: a plugin (bsdf, shape, …), a property (float, rgb, transform, …) or part of a
/// transform.
struct Node {
  std::string tag;   // canonical
  std::string type;  // plugin name, as written
  std::string id;
  std::map<std::string, std::string>
      attributes;  // all others, by canonical name; values as written
  Source source;
  std::vector<Child> children;

  /// The attribute's value, or nullptr.
  const std::string* attribute(const std::string& name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? nullptr : &found->second;
  }
};

struct Document {
  std::vector<std::unique_ptr<Node>> nodes;  // owns all
  const Node* root = nullptr;
  double version = 3;                // of the format, as the main file says: 0.x, 2 or 3
  std::vector<std::string> folders;  // where the files it names are looked for, in order
  std::vector<std::string> warnings;

  /// Where a file named at `source` is. Throws Error if it is nowhere.
  std::string find_file(const std::string& name, const Source& source) const;
};

/// Throws Error for malformed XML, missing or cyclic includes and references, and undefined
/// variables.
Document load_document(const std::string& path, const std::map<std::string, std::string>& defines);

}  // namespace guidelight::mitsuba
