#include "tests/renderer/io/sample_files.h"

#include <stb/stb_image_write.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "renderer/io/image_file.h"
#include "tests/renderer/io/io_test_files.h"

namespace guidelight::test {
namespace {

template <typename T>
void append(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string compress(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  ::compress(reinterpret_cast<Bytef*>(out.data()), &size,
             reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  out.resize(size);
  return out;
}

template <typename Real>
std::string serialized_body(int version, uint32_t flags) {
  std::string body;
  append<uint32_t>(body, flags);
  if (version >= 4) body.append("mesh", 5);
  append<uint64_t>(body, 3);
  append<uint64_t>(body, 1);
  for (const double v : {0, 0, 0, 1, 0, 0, 0, 1, 0}) append<Real>(body, static_cast<Real>(v));
  if (flags & 1) {
    for (int i = 0; i < 3; ++i) {
      for (const double v : {0, 0, 1}) append<Real>(body, static_cast<Real>(v));
    }
  }
  if (flags & 2) {
    for (const double v : {0.0, 0.25, 1.0, 0.25, 0.0, 1.0})
      append<Real>(body, static_cast<Real>(v));
  }
  for (const uint32_t i : {0u, 1u, 2u}) append<uint32_t>(body, i);
  return body;
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0);
    }
    for (size_t k = 0; k < 4; ++k) {
      out += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
    }
  }
  return out;
}

/// Positions of one triangle and its indices.
std::string triangle_buffer() {
  std::string buffer;
  for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) append<float>(buffer, v);
  for (const uint16_t i : {0, 1, 2, 0}) append<uint16_t>(buffer, i);
  return buffer;
}

std::string gltf_json(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
 "nodes":[{"mesh":0,"name":"triangle","translation":[1,2,3],"children":[1]},{"camera":0}],
 "cameras":[{"type":"perspective","perspective":{"yfov":0.8,"aspectRatio":1.5,"znear":0.1}}],
 "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
 "materials":[{"name":"m","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0.125,1],
   "metallicFactor":0.25,"roughnessFactor":0.5},"emissiveFactor":[1,1,1]}],
 "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
   {"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
 "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},
   {"buffer":0,"byteOffset":36,"byteLength":6}],
 "buffers":[{)" +
         uri + R"("byteLength":42}]})";
}

void collect(void* context, void* data, int size) {
  static_cast<std::string*>(context)->append(static_cast<char*>(data), static_cast<size_t>(size));
}

std::string checker_pixels(int width, int height) {
  std::string pixels;
  for (int i = 0; i < width * height; ++i) {
    for (const int c : {i * 37, i * 91, 255 - i}) pixels += static_cast<char>(c);
  }
  return pixels;
}

}  // namespace

std::string sample_obj() {
  return "# two groups\nmtllib none.mtl\ng first\n"
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
         "vt 0 0\nvt 1 0\nvt 1 0.75\nvt 0 0.75\nvn 0 0 1\n"
         "f 1/1/1 2/2/1 3/3/1 4/4/1\ng second\nv 0 0 1\nusemtl m\nf -1/1/1 2/2/1 3/3/1\n";
}

std::string sample_ply_text() {
  return "ply\nformat ascii 1.0\ncomment text\nelement vertex 4\nproperty float x\n"
         "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
         "property float nz\nproperty float s\nproperty float t\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n"
         "0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n1 1 0 0 0 1 1 0.25\n0 1 0 0 0 1 0 0.25\n"
         "4 0 1 2 3\n";
}

std::string sample_ply_binary(bool big_endian) {
  std::string ply = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                    "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                    "property float z\nproperty uchar red\nproperty uchar green\n"
                    "property uchar blue\nelement face 2\nproperty uchar flags\n"
                    "property list uchar int vertex_index\nend_header\n";
  for (int i = 0; i < 4; ++i) {
    append<float>(ply, i == 1 || i == 2 ? 1.f : 0.f, big_endian);
    append<float>(ply, i >= 2 ? 1.f : 0.f, big_endian);
    append<float>(ply, 0.f, big_endian);
    for (const int c : {255, 51 * i, 0}) ply += static_cast<char>(c);
  }
  for (const int corners : {4, 3}) {
    ply += '\0';
    ply += static_cast<char>(corners);
    for (int i = 0; i < corners; ++i) append<int32_t>(ply, i, big_endian);
  }
  return ply;
}

std::string sample_serialized(int version, bool doubles) {
  std::string file;
  std::vector<uint64_t> offsets;
  for (const uint32_t flags : {0u, 3u}) {
    offsets.push_back(file.size());
    append<uint16_t>(file, 0x041C);
    append<uint16_t>(file, static_cast<uint16_t>(version));
    file += compress(doubles ? serialized_body<double>(version, flags | 0x2000)
                             : serialized_body<float>(version, flags | 0x1000));
  }
  for (const uint64_t offset : offsets) {
    if (version >= 4) {
      append<uint64_t>(file, offset);
    } else {
      append<uint32_t>(file, static_cast<uint32_t>(offset));
    }
  }
  append<uint32_t>(file, 2);
  return file;
}

std::string sample_gltf() {
  return gltf_json("\"uri\":\"data:application/octet-stream;base64," + base64(triangle_buffer()) +
                   "\",");
}

std::string sample_glb() {
  std::string json = gltf_json("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = triangle_buffer();
  std::string glb = "glTF";
  append<uint32_t>(glb, 2);
  append<uint32_t>(glb, static_cast<uint32_t>(28 + json.size() + buffer.size()));
  append<uint32_t>(glb, static_cast<uint32_t>(json.size()));
  glb += "JSON" + json;
  append<uint32_t>(glb, static_cast<uint32_t>(buffer.size()));
  glb += std::string("BIN\0", 4) + buffer;
  return glb;
}

std::string sample_png() {
  std::string bytes;
  stbi_write_png_to_func(collect, &bytes, 4, 4, 3, checker_pixels(4, 4).data(), 12);
  return bytes;
}

std::string sample_jpeg() {
  std::string bytes;
  stbi_write_jpg_to_func(collect, &bytes, 16, 16, 3, checker_pixels(16, 16).data(), 90);
  return bytes;
}

std::string sample_hdr() {
  std::vector<float> pixels(16 * 8 * 3);
  for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<float>(i % 7) * 3.5f;
  std::string bytes;
  stbi_write_hdr_to_func(collect, &bytes, 16, 8, 3, pixels.data());
  return bytes;
}

std::string sample_bmp() {
  std::string bytes;
  stbi_write_bmp_to_func(collect, &bytes, 4, 4, 3, checker_pixels(4, 4).data());
  return bytes;
}

std::string sample_tga() {
  std::string bytes;
  stbi_write_tga_to_func(collect, &bytes, 4, 4, 3, checker_pixels(4, 4).data());
  return bytes;
}

std::string sample_exr() {
  const TemporaryFolder folder;
  ImageLayers picture;
  picture.layers.emplace_back("beauty", Image(8, 4, 3));
  picture.layers.emplace_back("depth", Image(8, 4, 1));
  for (auto& [name, image] : picture.layers) {
    for (size_t i = 0; i < image.data().size(); ++i) image.data()[i] = static_cast<float>(i) * 0.5f;
  }
  picture.metadata["scene"] = "sample";
  write_exr(folder / "sample.exr", picture);
  return file_bytes(folder / "sample.exr");
}

}  // namespace guidelight::test
