#include "renderer/io/obj_mesh.h"

#include <array>
#include <charconv>
#include <optional>
#include <unordered_map>

#include "renderer/error.h"

namespace guidelight {
namespace {

constexpr std::string_view kObjSpaces = " \t\r\v\f";
constexpr int64_t kAbsent = -1;

/// Indices of one corner of a face, from zero.
struct Corner {
  std::array<int64_t, 3> index = {kAbsent, kAbsent, kAbsent};  // position, uv, normal

  bool operator==(const Corner&) const = default;
};

struct CornerHash {
  size_t operator()(const Corner& corner) const {
    uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a over words
    for (const int64_t i : corner.index) hash = (hash ^ static_cast<uint64_t>(i)) * 0x100000001b3u;
    return hash ^ hash >> 29;
  }
};

class Parser {
 public:
  Mesh parse(std::string_view rest) {
    while (!rest.empty()) {
      ++line_;
      const std::string_view line = next_line(rest);
      const size_t begin = line.find_first_not_of(kObjSpaces);
      if (begin != std::string_view::npos) parse_line(line.substr(begin));
    }
    return build();
  }

 private:
  template <typename... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw Error("line {}: {}", line_, fmt::format(format, std::forward<Args>(args)...));
  }

  static std::string_view next_line(std::string_view& rest) {
    const size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line;
  }

  /// The next word of a line; empty at its end.
  static std::string_view next_word(std::string_view& rest) {
    const size_t begin = rest.find_first_not_of(kObjSpaces);
    if (begin == std::string_view::npos) return {};
    const size_t end = std::min(rest.find_first_of(kObjSpaces, begin), rest.size());
    const std::string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
  }

  void parse_line(std::string_view line) {
    // A backslash joins a face with the next line; no exporter that is still in use splits other
    // things.
    if (continued_ || line.starts_with("f ") || line.starts_with("f\t")) {
      if (!continued_) {
        corners_.clear();
        line.remove_prefix(1);
      }
      parse_face(line);
    } else if (line.starts_with("v ") || line.starts_with("v\t")) {
      parse_position(line.substr(1));
    } else if (line.starts_with("vt")) {
      const std::array<float, 6> v = parse_floats(line.substr(2), 1);
      uvs_.emplace_back(v[0], v[1]);
    } else if (line.starts_with("vn")) {
      const std::array<float, 6> v = parse_floats(line.substr(2), 3);
      normals_.emplace_back(v[0], v[1], v[2]);
    }
  }

  /// Up to six numbers, at least `required`; the rest of the line does not matter.
  std::array<float, 6> parse_floats(std::string_view line, int required) {
    std::array<float, 6> values{};
    for (count_ = 0; count_ < 6; ++count_) {
      std::string_view word = next_word(line);
      if (word.starts_with('+')) word.remove_prefix(1);
      double value = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (word.empty() || error == std::errc::invalid_argument) break;
      values[count_] = static_cast<float>(value);
    }
    if (count_ < required) fail("{} numbers are needed", required);
    return values;
  }

  void parse_position(std::string_view line) {
    const std::array<float, 6> v = parse_floats(line, 3);
    positions_.emplace_back(v[0], v[1], v[2]);
    const bool colored = count_ == 6;
    if (colored && colors_.empty()) colors_.resize(positions_.size() - 1, Color(1));
    if (!colors_.empty()) colors_.push_back(colored ? Color(v[3], v[4], v[5]) : Color(1));
  }

  void parse_face(std::string_view line) {
    continued_ = false;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      if (word == "\\") {
        continued_ = true;
        return;
      }
      if (word.starts_with('#')) break;
      corners_.push_back(vertex(parse_corner(word)));
      if (corners_.size() >= 3) {
        triangles_.push_back({corners_[0], corners_[corners_.size() - 2], corners_.back()});
      }
    }
  }

  /// "p", "p/t", "p//n" or "p/t/n".
  Corner parse_corner(std::string_view word) const {
    const std::array<size_t, 3> sizes = {positions_.size(), uvs_.size(), normals_.size()};
    Corner corner;
    for (int part = 0; part < 3; ++part) {
      const size_t slash = word.find('/');
      const std::string_view number = word.substr(0, slash);
      if (!number.empty()) corner.index[part] = parse_index(number, sizes[part]);
      if (slash == std::string_view::npos) break;
      word.remove_prefix(slash + 1);
    }
    if (corner.index[0] == kAbsent) fail("a face has a corner without a position");
    return corner;
  }

  /// From one upwards, or negative: counted back from the last.
  int64_t parse_index(std::string_view text, size_t size) const {
    int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const int64_t index = value < 0 ? static_cast<int64_t>(size) + value : value - 1;
    const bool number = error == std::errc() && end == text.data() + text.size();
    if (!number || index < 0 || index >= static_cast<int64_t>(size)) {
      fail("a face names '{}' and there are {} of them so far", text, size);
    }
    return index;
  }

  uint32_t vertex(const Corner& corner) {
    const auto [found, is_new] =
        vertices_.try_emplace(corner, static_cast<uint32_t>(order_.size()));
    if (is_new) order_.push_back(corner);
    return found->second;
  }

  Mesh build() const {
    bool uvs = false, normals = !normals_.empty();
    for (const Corner& corner : order_) {
      uvs = uvs || corner.index[1] != kAbsent;
      normals = normals && corner.index[2] != kAbsent;
    }
    Mesh mesh;
    for (const Corner& corner : order_) {
      const auto [p, t, n] = corner.index;
      mesh.positions.push_back(positions_[p]);
      if (uvs) mesh.uvs.push_back(t == kAbsent ? Vec2(0) : uvs_[t]);
      if (normals) mesh.normals.push_back(normals_[n]);
      if (!colors_.empty()) mesh.colors.push_back(colors_[p]);
    }
    mesh.triangles = triangles_;
    return mesh;
  }

  int line_ = 0;
  int count_ = 0;  // numbers that parse_floats found
  bool continued_ = false;
  std::vector<Vec3> positions_, normals_;
  std::vector<Vec2> uvs_;
  std::vector<Color> colors_;
  std::vector<uint32_t> corners_;  // of the face being read
  std::unordered_map<Corner, uint32_t, CornerHash> vertices_;
  std::vector<Corner> order_;
  std::vector<std::array<uint32_t, 3>> triangles_;
};

}  // namespace

Mesh decode_obj(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) throw Error("it is not a text file");
  return Parser().parse(bytes);
}

}  // namespace guidelight
