#include "renderer/io/mitsuba/transform.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/io/mitsuba/values.h"
#include "renderer/math/frame.h"

namespace guidelight::mitsuba {
namespace {

std::vector<float> numbers_of(const Node& node, const std::string& text) {
  const std::optional<std::vector<double>> numbers = parse_numbers(text);
  const bool finite = numbers && std::all_of(numbers->begin(), numbers->end(), [](double v) {
                        return std::isfinite(static_cast<float>(v));
                      });
  if (!finite) {
    throw Error("{}: '{}' in <{}> is not a list of finite numbers; correct it.",
                node.source.to_string(), text, node.tag);
  }
  return {numbers->begin(), numbers->end()};
}

float number_of(const Node& node, const std::string& name, float fallback) {
  const std::string* text = node.attribute(name);
  if (!text) return fallback;
  const std::vector<float> numbers = numbers_of(node, *text);
  if (numbers.size() != 1) {
    throw Error("{}: '{}' is not one number; correct attribute '{}' of <{}>.",
                node.source.to_string(), *text, name, node.tag);
  }
  return numbers[0];
}

Vec3 triple_of(const Node& node, const std::string& name, Vec3 fallback) {
  const std::string* text = node.attribute(name);
  if (!text) return fallback;
  const std::vector<float> v = numbers_of(node, *text);
  if (v.size() == 1) return Vec3(v[0]);
  if (v.size() == 2) return {v[0], v[1], fallback.z};  // texture coordinates
  if (v.size() != 3) {
    throw Error("{}: '{}' has {} numbers instead of three; correct attribute '{}' of <{}>.",
                node.source.to_string(), *text, v.size(), name, node.tag);
  }
  return {v[0], v[1], v[2]};
}

/// 16 numbers in rows, or 9 that act on (x, y, z).
Mat4 parse_matrix(const Node& node) {
  const std::string* text = node.attribute("value");
  const std::vector<float> v = text ? numbers_of(node, *text) : std::vector<float>();
  if (v.size() != 16 && v.size() != 9) {
    throw Error("{}: a matrix has {} numbers instead of 16 or 9; correct it.",
                node.source.to_string(), v.size());
  }
  const int n = v.size() == 16 ? 4 : 3;
  Mat4 matrix(1.0f);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) matrix[column][row] = v[row * n + column];
  }
  return matrix;
}

Mat4 parse_rotation(const Node& node) {
  const Vec3 axis = parse_vector(node, Vec3(0));
  if (!(length_squared(axis) > 0)) {
    throw Error("{}: a rotation has no axis; give it x, y and z.", node.source.to_string());
  }
  return glm::rotate(Mat4(1), number_of(node, "angle", 0) * kPi / 180, axis);
}

Mat4 parse_look_at(const Node& node) {
  try {
    return look_at(triple_of(node, "origin", Vec3(0)), triple_of(node, "target", Vec3(0, 0, 1)),
                   triple_of(node, "up", Vec3(0)));
  } catch (const std::exception& error) {
    throw Error("{}: {}; correct <{}>.", node.source.to_string(), error.what(), node.tag);
  }
}

Mat4 parse_part(const Node& node) {
  if (node.tag == "translate") return glm::translate(Mat4(1), parse_vector(node, Vec3(0)));
  if (node.tag == "scale") return glm::scale(Mat4(1), parse_vector(node, Vec3(1)));
  if (node.tag == "rotate") return parse_rotation(node);
  if (node.tag == "lookat") return parse_look_at(node);
  if (node.tag == "matrix") return parse_matrix(node);
  throw Error(
      "{}: <{}> is not part of a transform; use translate, rotate, scale, lookat or matrix.",
      node.source.to_string(), node.tag);
}

}  // namespace

Vec3 parse_vector(const Node& node, Vec3 fallback) {
  const Vec3 v = triple_of(node, "value", fallback);
  return {number_of(node, "x", v.x), number_of(node, "y", v.y), number_of(node, "z", v.z)};
}

Mat4 look_at(Vec3 origin, Vec3 target, Vec3 up) {
  const Vec3 direction = target - origin;
  if (!(length_squared(direction) > 0)) throw Error("origin and target of the view coincide");
  const Vec3 forward = glm::normalize(direction);
  Vec3 left = glm::cross(up, forward);
  // Without a usable up vector any will do.
  left = length_squared(left) > 1e-12f * length_squared(up) ? glm::normalize(left)
                                                            : Frame::from_normal(forward).s;
  return {Vec4(left, 0), Vec4(glm::cross(forward, left), 0), Vec4(forward, 0), Vec4(origin, 1)};
}

Mat4 parse_transform(const Node& node) {
  Mat4 matrix(1.0f);
  for (const Child& child : node.children) matrix = parse_part(*child.node) * matrix;
  for (int column = 0; column < 4; ++column) {
    if (!is_finite(Vec3(matrix[column]))) {
      throw Error("{}: the transform overflows; use smaller numbers.", node.source.to_string());
    }
  }
  return matrix;
}

Mat3 parse_uv_transform(const Node& node) {
  const bool two_dimensional =
      std::any_of(node.children.begin(), node.children.end(), [](const Child& child) {
        const std::string* value = child.node->attribute("value");
        return child.node->tag == "matrix" && value && split_list(*value).size() == 9;
      });
  const Mat4 m = parse_transform(node);
  if (two_dimensional) return Mat3(m);
  // The third coordinate of space has no meaning here; the translation takes its place.
  return {Vec3(m[0][0], m[0][1], 0), Vec3(m[1][0], m[1][1], 0), Vec3(m[3][0], m[3][1], 1)};
}

}  // namespace guidelight::mitsuba
