#include "renderer/io/mitsuba/document.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "renderer/io/mitsuba/values.h"
#include "renderer/io/read_file.h"

namespace guidelight::mitsuba {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDepth = 100;                          // of nested elements
constexpr int kMaxIncludes = 1000;                      // in one scene
constexpr size_t kMaxSceneBytes = size_t{128} << 20;    // with what it includes, in all
constexpr size_t kMaxVariableBytes = size_t{16} << 20;  // put in for variables, in all

/// Line numbers of byte offsets in one file.
class Lines {
 public:
  explicit Lines(const std::string& text) {
    for (size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') ends_.push_back(static_cast<ptrdiff_t>(i));
    }
  }
  int line_of(ptrdiff_t offset) const {
    return 1 +
           static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
  }

 private:
  std::vector<ptrdiff_t> ends_;
};

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

class Loader {
 public:
  explicit Loader(const std::map<std::string, std::string>& defines) : variables_(defines) {}

  Document load(const std::string& path) {
    document_.folders.push_back(fs::path(path).parent_path().string());
    Node& root = add_node("scene", {std::make_shared<const std::string>(path), 1});
    document_.root = &root;
    load_file(path, root);
    for (const std::unique_ptr<Node>& node : document_.nodes) finish_node(*node);
    for (const std::unique_ptr<Node>& node : document_.nodes) name_children(*node);
    resolve_references();
    check_cycles(root, 0);
    return std::move(document_);
  }

 private:
  enum class Visit { Active, Done };

  struct File {
    std::shared_ptr<const std::string> path;
    Lines lines;

    Source source(const pugi::xml_node& xml) const {
      return {path, lines.line_of(xml.offset_debug())};
    }
  };

  Node& add_node(std::string tag, Source source) {
    document_.nodes.push_back(std::make_unique<Node>());
    Node& node = *document_.nodes.back();
    node.tag = std::move(tag);
    node.source = std::move(source);
    return node;
  }

  void load_file(const std::string& path, Node& parent) {
    const std::string text = read_file_bytes(path, kMaxSceneBytes);
    scene_bytes_ += text.size();
    if (scene_bytes_ > kMaxSceneBytes) {
      throw Error("{}: the scene and what it includes have more than {} MiB; include less.", path,
                  kMaxSceneBytes >> 20);
    }
    const File file{std::make_shared<const std::string>(path), Lines(text)};
    pugi::xml_document xml;
    const pugi::xml_parse_result result = xml.load_buffer(text.data(), text.size());
    if (!result) {
      throw Error("{}:{}: the XML is malformed ({}); correct it there.", path,
                  file.lines.line_of(result.offset), result.description());
    }
    const pugi::xml_node root = xml.document_element();
    if (std::strcmp(root.name(), "scene") != 0) {
      throw Error(
          "{}:{}: the outermost element is <{}> instead of <scene>; choose a Mitsuba scene.", path,
          file.lines.line_of(root.offset_debug()), root.name());
    }
    if (active_files_.empty()) document_.version = root.attribute("version").as_double(3);
    active_files_.push_back(fs::weakly_canonical(path).string());
    collect_defaults(root, file);
    for (const pugi::xml_node& child : root.children()) add_child(child, file, parent, 1);
    active_files_.pop_back();
  }

  /// Defaults count wherever they stand; the first of a name wins and none overrides a define.
  void collect_defaults(const pugi::xml_node& root, const File& file) {
    for (const pugi::xpath_node& found : root.select_nodes(".//default")) {
      const pugi::xml_node element = found.node();
      variables_.try_emplace(
          element.attribute("name").value(),
          replace_variables(element.attribute("value").value(), file.source(element)));
    }
  }

  void add_child(const pugi::xml_node& xml, const File& file, Node& parent, int depth) {
    if (xml.type() != pugi::node_element) return;
    const Source source = file.source(xml);
    if (depth > kMaxDepth) {
      throw Error("{}: elements are nested more than {} deep; flatten the scene.",
                  source.to_string(), kMaxDepth);
    }
    const std::string tag = canonical_name(xml.name());
    if (tag == "default") return;
    if (tag == "include") return include(attribute_of(xml, "filename", source), source, parent);
    if (tag == "path") return add_folder(attribute_of(xml, "value", source), source);
    if (tag == "alias") {
      aliases_.push_back(
          {attribute_of(xml, "id", source), attribute_of(xml, "as", source), source});
      return;
    }
    Node& node = add_node(tag, source);
    for (const pugi::xml_attribute& attribute : xml.attributes()) {
      node.attributes[canonical_name(attribute.name())] = attribute.value();
    }
    parent.children.push_back({"", &node});
    for (const pugi::xml_node& child : xml.children()) add_child(child, file, node, depth + 1);
  }

  std::string attribute_of(const pugi::xml_node& xml, const char* name, const Source& source) {
    const pugi::xml_attribute attribute = xml.attribute(name);
    if (!attribute) {
      throw Error("{}: <{}> has no attribute '{}'; add it.", source.to_string(), xml.name(), name);
    }
    return replace_variables(attribute.value(), source);
  }

  void include(const std::string& name, const Source& source, Node& parent) {
    if (++include_count_ > kMaxIncludes) {
      throw Error("{}: the scene includes more than {} files; merge some.", source.to_string(),
                  kMaxIncludes);
    }
    const std::string path = document_.find_file(name, source);
    const std::string canonical = fs::weakly_canonical(path).string();
    if (std::find(active_files_.begin(), active_files_.end(), canonical) != active_files_.end()) {
      throw Error("{}: the file '{}' includes itself in the end; remove one of the includes.",
                  source.to_string(), name);
    }
    load_file(path, parent);
  }

  void add_folder(const std::string& name, const Source& source) {
    std::error_code ignored;
    for (const std::string& folder : document_.folders) {
      const fs::path path = fs::path(folder) / name;
      if (fs::is_directory(path, ignored)) {
        document_.folders.push_back(path.string());
        return;
      }
    }
    document_.warnings.push_back(fmt::format(
        "{}: there is no folder '{}'; no files are looked for in it.", source.to_string(), name));
  }

  /// Variables are replaced when all defaults are known.
  void finish_node(Node& node) {
    for (auto& [key, value] : node.attributes) value = replace_variables(value, node.source);
    const auto take = [&](const char* key) {
      const auto attribute = node.attributes.extract(key);
      return attribute ? attribute.mapped() : std::string();
    };
    node.type = take("type");
    node.id = take("id");
    if (!node.id.empty() && node.tag != "ref") register_id(node.id, node);
  }

  void name_children(Node& node) {
    for (Child& child : node.children) {
      const std::string* name = child.node->attribute("name");
      if (name) child.name = canonical_name(*name);
    }
  }

  void register_id(const std::string& id, const Node& node) {
    const auto [existing, added] = by_id_.try_emplace(id, &node);
    if (!added) {
      document_.warnings.push_back(
          fmt::format("{}: the id '{}' is already taken at {}; references see the earlier one.",
                      node.source.to_string(), id, existing->second->source.to_string()));
    }
  }

  /// Replaces $name by the longest variable that matches.
  std::string replace_variables(const std::string& text, const Source& source) {
    std::string result;
    for (size_t i = 0; i < text.size();) {
      if (text[i] != '$') {
        result += text[i++];
        continue;
      }
      size_t end = i + 1;
      while (end < text.size() && is_name_character(text[end])) ++end;
      const std::string name = text.substr(i + 1, end - i - 1);
      size_t length = name.size();
      while (length > 0 && !variables_.contains(name.substr(0, length))) --length;
      if (length == 0) {
        throw Error("{}: the variable '${}' is not defined; add a <default> or give -D {}=VALUE.",
                    source.to_string(), name, name);
      }
      const std::string& value = variables_.at(name.substr(0, length));
      variable_bytes_ += value.size();
      if (variable_bytes_ > kMaxVariableBytes) {
        throw Error("{}: the variables grow to more than {} MiB of text; shorten '${}'.",
                    source.to_string(), kMaxVariableBytes >> 20, name);
      }
      result += value;
      i += 1 + length;
    }
    return result;
  }

  /// References may stand before what they name, so they are resolved when all is read.
  void resolve_references() {
    for (const Alias& alias : aliases_) {
      const Node* target = find_id(alias.id, alias.source);
      by_id_.try_emplace(alias.as, target);
    }
    for (const std::unique_ptr<Node>& node : document_.nodes) {
      for (Child& child : node->children) {
        if (child.node->tag == "ref") child.node = find_id(child.node->id, child.node->source);
      }
    }
  }

  const Node* find_id(const std::string& id, const Source& source) const {
    const auto found = by_id_.find(id);
    if (found == by_id_.end()) {
      throw Error("{}: nothing has the id '{}'; define it or correct the reference.",
                  source.to_string(), id);
    }
    return found->second;
  }

  void check_cycles(const Node& node, int depth) {
    const auto [state, is_new] = visits_.try_emplace(&node, Visit::Active);
    if (!is_new && state->second == Visit::Done) return;
    if (!is_new || depth > kMaxDepth) {
      throw Error("{}: '{}' refers to itself through its references; break the cycle.",
                  node.source.to_string(), node.id);
    }
    for (const Child& child : node.children) check_cycles(*child.node, depth + 1);
    visits_[&node] = Visit::Done;
  }

  struct Alias {
    std::string id, as;
    Source source;
  };

  Document document_;
  std::map<std::string, std::string> variables_;
  std::map<std::string, const Node*> by_id_;
  std::vector<Alias> aliases_;
  std::vector<std::string> active_files_;  // being included, outermost first
  int include_count_ = 0;
  size_t scene_bytes_ = 0;     // read
  size_t variable_bytes_ = 0;  // put in
  std::map<const Node*, Visit> visits_;
};

}  // namespace

std::string Document::find_file(const std::string& name, const Source& source) const {
  std::vector<std::string> candidates = folders;
  candidates.push_back(fs::path(*source.file).parent_path().string());
  std::error_code ignored;
  for (const std::string& folder : candidates) {
    const fs::path path = fs::path(folder) / name;
    if (fs::is_regular_file(path, ignored)) return path.string();
  }
  throw Error("{}: the file '{}' does not exist; put it beside the scene or correct its name.",
              source.to_string(), name);
}

Document load_document(const std::string& path, const std::map<std::string, std::string>& defines) {
  return Loader(defines).load(path);
}

}  // namespace guidelight::mitsuba
