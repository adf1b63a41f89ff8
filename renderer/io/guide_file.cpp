#include "renderer/io/guide_file.h"

#include <array>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "renderer/error.h"
#include "renderer/io/atomic_file.h"
#include "renderer/io/read_file.h"

namespace guidelight {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kGuideMark = "guidelight_guides";
constexpr int kGuideVersion = 1;
constexpr size_t kMaxBytes = size_t{64} << 20;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr std::array<const char*, 3> kEventNames = {"scatter", "reflect", "refract"};  // PathEvent

/// The shortest decimal number that is read back to the same float.
json number(float value) { return std::stod(fmt::format("{}", value)); }
json vector(Vec3 v) { return {number(v.x), number(v.y), number(v.z)}; }

float radians(double degrees) { return static_cast<float>(degrees * kRadiansPerDegree); }

/// The shortest number of degrees that is read back to the same angle.
double degrees(float angle) {
  double rounded = angle / kRadiansPerDegree;
  for (int digits = 1; digits <= 9; ++digits) {
    rounded = std::stod(fmt::format("{:.{}g}", angle / kRadiansPerDegree, digits));
    if (radians(rounded) == angle) break;
  }
  return rounded;
}

/// What is not used or goes without saying is left out.
std::string to_text(const GuideVertex& vertex) {
  ordered_json object = {{"position", vector(vertex.position)}};
  if (vertex.event == PathEvent::Scatter) {
    object["cone"] = degrees(vertex.cone);
  } else {
    object["event"] = kEventNames[static_cast<size_t>(vertex.event)];
  }
  return object.dump();
}

/// A line for the guide and one for each vertex.
std::string to_text(const GuidePath& guide) {
  const ordered_json object = {{"name", guide.name},
                               {"color", vector(guide.color)},
                               {"enabled", guide.enabled},
                               {"weight", number(guide.weight)},
                               {"disc_radius", number(guide.disc_radius)}};
  std::string text = object.dump();
  text.back() = ',';
  text += "\"vertices\":[";
  for (const GuideVertex& vertex : guide.vertices) {
    text += fmt::format("{}\n    {}", text.back() == '[' ? "" : ",", to_text(vertex));
  }
  return text + "]}";
}

/// One object of the file; `where` names it in errors.
class GuideReader {
 public:
  GuideReader(const json& object, std::string where, std::initializer_list<const char*> known)
      : object_(object), where_(std::move(where)) {
    if (!object.is_object()) fail("it is not an object: write {{ … }}");
    for (const auto& [key, value] : object.items()) {
      const bool is_known = std::ranges::any_of(known, [&](const char* k) { return key == k; });
      if (!is_known) fail("'{}' is not known here: remove it", key);
    }
  }

  template <typename... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw Error("{}: {}", where_, fmt::format(format, std::forward<Args>(args)...));
  }

  /// Null if it is absent.
  const json* find(const char* key) const {
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }

  void read(const char* key, std::string& to) const {
    const json* value = find(key);
    if (value && !value->is_string()) fail("'{}' is not a text", key);
    if (value) to = value->get<std::string>();
  }
  void read(const char* key, bool& to) const {
    const json* value = find(key);
    if (value && !value->is_boolean()) fail("'{}' is neither true nor false", key);
    if (value) to = value->get<bool>();
  }
  void read(const char* key, float& to) const {
    if (const json* value = find(key)) to = finite(key, *value);
  }
  void read(const char* key, Vec3& to) const {
    const json* value = find(key);
    if (!value) return;
    if (!value->is_array() || value->size() != 3) fail("'{}' is not a list of three numbers", key);
    for (int i = 0; i < 3; ++i) to[i] = finite(key, (*value)[static_cast<size_t>(i)]);
  }
  const json& list(const char* key) const {
    const json* value = find(key);
    if (!value || !value->is_array()) fail("'{}' is not there or not a list", key);
    return *value;
  }

 private:
  float finite(const char* key, const json& value) const {
    const float number = value.is_number() ? value.get<float>() : kInfinity;
    if (!std::isfinite(number)) fail("'{}' is not a number within the range of floats", key);
    return number;
  }

  const json& object_;
  std::string where_;
};

PathEvent read_event(const GuideReader& reader) {
  std::string name = kEventNames[0];
  reader.read("event", name);
  const auto found = std::ranges::find(kEventNames, name);
  if (found == kEventNames.end()) {
    reader.fail("the event '{}' is not known: write scatter, reflect or refract", name);
  }
  return static_cast<PathEvent>(found - kEventNames.begin());
}

GuideVertex read_vertex(const json& object, const std::string& where) {
  const GuideReader reader(object, where, {"position", "event", "cone"});
  if (!reader.find("position")) reader.fail("'position' is not there: give three numbers");
  GuideVertex vertex;
  reader.read("position", vertex.position);
  vertex.event = read_event(reader);
  const json* cone = reader.find("cone");
  if (cone && !cone->is_number()) reader.fail("'cone' is not a number: give degrees");
  if (cone) vertex.cone = radians(cone->get<double>());
  if (!(vertex.cone > 0 && vertex.cone <= 0.5f * kPi)) {
    reader.fail("the cone is {}: give degrees above 0 and up to 90",
                vertex.cone / kRadiansPerDegree);
  }
  return vertex;
}

GuidePath read_guide(const json& object, const std::string& where) {
  const GuideReader reader(object, where,
                           {"name", "color", "enabled", "weight", "disc_radius", "vertices"});
  GuidePath guide;
  reader.read("name", guide.name);
  reader.read("color", guide.color);
  reader.read("enabled", guide.enabled);
  reader.read("weight", guide.weight);
  reader.read("disc_radius", guide.disc_radius);
  if (!(guide.weight >= 0)) reader.fail("the weight {} is negative", guide.weight);
  if (!(guide.disc_radius > 0)) {
    reader.fail("the disc radius {} is not positive", guide.disc_radius);
  }
  const json& vertices = reader.list("vertices");
  for (size_t i = 0; i < vertices.size(); ++i) {
    guide.vertices.push_back(read_vertex(vertices[i], fmt::format("{}, vertex {}", where, i)));
  }
  if (vertices.size() < 2) {
    reader.fail("it has {} vertices: give one on a light and one where its light is wanted",
                vertices.size());
  }
  return guide;
}

json parse(const std::string& text, const std::string& where) {
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    throw Error("{}: this is not JSON: {}", where, error.what());
  }
}

}  // namespace

std::string guide_file_beside(const std::string& scene_path) {
  return std::filesystem::path(scene_path).replace_extension(".guides.json").string();
}

std::vector<GuidePath> parse_guides(const std::string& text, const std::string& where) {
  const json document = parse(text, where);
  const GuideReader reader(document, where, {kGuideMark, "guides"});
  const json* version = reader.find(kGuideMark);
  if (!version || *version != kGuideVersion) {
    reader.fail("'{}' is not {}: this is not a file of guides that can be read here", kGuideMark,
                kGuideVersion);
  }
  const json& list = reader.list("guides");
  std::vector<GuidePath> guides;
  for (size_t i = 0; i < list.size(); ++i) {
    guides.push_back(read_guide(list[i], fmt::format("{}: guide {}", where, i)));
  }
  return guides;
}

std::vector<GuidePath> read_guides(const std::string& path) {
  return parse_guides(read_file_bytes(path, kMaxBytes), path);
}

std::string guides_text(const std::vector<GuidePath>& guides) {
  std::string text = fmt::format("{{\"{}\":{},\"guides\":[", kGuideMark, kGuideVersion);
  try {
    for (const GuidePath& guide : guides) {
      text += fmt::format("{}\n  {}", text.back() == '[' ? "" : ",", to_text(guide));
    }
    return text + "\n]}\n";
  } catch (const json::exception& error) {
    throw Error("The guides cannot be written as text: {}; give them names in UTF-8.",
                error.what());
  }
}

void write_guides(const std::string& path, const std::vector<GuidePath>& guides) {
  write_file_atomically(path, guides_text(guides));
}

}  // namespace guidelight
