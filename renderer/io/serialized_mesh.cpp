#include <zlib.h>

#include <cstring>
#include <string_view>

#include "renderer/error.h"
#include "renderer/io/mesh_file.h"
#include "renderer/io/mesh_tools.h"
#include "renderer/io/read_file.h"

namespace guidelight {
namespace {

constexpr uint16_t kFormatId = 0x041C;

enum Flag : uint32_t {
  kNormals = 0x0001,
  kTexCoords = 0x0002,
  kColors = 0x0008,
  kFaceNormals = 0x0010,
  kDoublePrecision = 0x2000,
};

template <typename T>
T read_at(std::string_view bytes, uint64_t offset) {
  if (offset > bytes.size() || bytes.size() - offset < sizeof(T)) {
    throw Error("the file ends too early");
  }
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

/// Decompresses as it is read, so that a false count fails before memory is taken for it.
class InflateStream {
 public:
  explicit InflateStream(std::string_view compressed) : compressed_size_(compressed.size()) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data()));
    stream_.avail_in = static_cast<uInt>(compressed.size());
    if (inflateInit(&stream_) != Z_OK) throw Error("zlib does not start");
  }
  ~InflateStream() { inflateEnd(&stream_); }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;

  void read(void* out, size_t size) {
    stream_.next_out = static_cast<Bytef*>(out);
    stream_.avail_out = static_cast<uInt>(size);
    while (stream_.avail_out > 0) {
      const int result = inflate(&stream_, Z_NO_FLUSH);
      if (result == Z_STREAM_END && stream_.avail_out == 0) return;
      if (result != Z_OK) throw Error("its compressed data are damaged or too short");
    }
  }
  template <typename T>
  T read() {
    T value;
    read(&value, sizeof(T));
    return value;
  }

  /// Deflate compresses at most 1032 : 1 (RFC 1951), so more than this cannot follow.
  uint64_t most_bytes() const { return uint64_t{compressed_size_} * 1032; }

 private:
  z_stream stream_{};
  size_t compressed_size_;
};

/// `count` vectors of `Vector::length()` floats or doubles.
template <typename Vector>
std::vector<Vector> read_vectors(InflateStream& stream, uint64_t count, bool doubles) {
  constexpr int kComponents = Vector::length();
  std::vector<Vector> vectors(count);
  if (!doubles) {
    stream.read(vectors.data(), count * sizeof(Vector));
    return vectors;
  }
  for (Vector& vector : vectors) {
    double values[kComponents];
    stream.read(values, sizeof(values));
    for (int i = 0; i < kComponents; ++i) vector[i] = static_cast<float>(values[i]);
  }
  return vectors;
}

uint64_t checked_count(InflateStream& stream, uint64_t bytes_each) {
  const auto count = stream.read<uint64_t>();
  if (count > stream.most_bytes() / bytes_each || count * bytes_each > (uint64_t{1} << 29)) {
    throw Error("it claims {} vertices or triangles", count);
  }
  return count;
}

Mesh read_mesh(InflateStream& stream, int version, bool& has_face_normals) {
  const auto flags = stream.read<uint32_t>();
  if (version >= 4) {
    while (stream.read<char>() != '\0') {  // the name
    }
  }
  const bool doubles = flags & kDoublePrecision;
  const uint64_t vertices = checked_count(stream, doubles ? 24 : 12);
  const uint64_t triangles = checked_count(stream, 12);
  if (vertices > 0xffffffffu) throw Error("it claims {} vertices", vertices);

  has_face_normals = flags & kFaceNormals;
  Mesh mesh;
  mesh.positions = read_vectors<Vec3>(stream, vertices, doubles);
  if (flags & kNormals) mesh.normals = read_vectors<Vec3>(stream, vertices, doubles);
  if (flags & kTexCoords) mesh.uvs = read_vectors<Vec2>(stream, vertices, doubles);
  if (flags & kColors) mesh.colors = read_vectors<Vec3>(stream, vertices, doubles);
  mesh.triangles.resize(triangles);
  stream.read(mesh.triangles.data(), triangles * sizeof(mesh.triangles[0]));
  return mesh;
}

/// Where mesh `index` starts, from the table at the end of the file.
uint64_t mesh_offset(std::string_view bytes, int version, int index) {
  const auto count = read_at<uint32_t>(bytes, bytes.size() - std::min<size_t>(bytes.size(), 4));
  if (index < 0 || static_cast<uint32_t>(index) >= count) {
    throw Error("it has {} meshes and number {} is asked for", count, index);
  }
  const uint64_t entry = version >= 4 ? 8 : 4;
  const uint64_t table = uint64_t{count} * entry + 4;
  if (table > bytes.size()) throw Error("its table claims {} meshes", count);
  const uint64_t at = bytes.size() - table + static_cast<uint64_t>(index) * entry;
  return version >= 4 ? read_at<uint64_t>(bytes, at) : read_at<uint32_t>(bytes, at);
}

Mesh read_from_bytes(std::string_view bytes, int index, bool& has_face_normals) {
  if (read_at<uint16_t>(bytes, 0) != kFormatId) throw Error("it is not a serialized mesh");
  const int version = read_at<uint16_t>(bytes, 2);
  if (version != 3 && version != 4) throw Error("version {} is not supported", version);
  const uint64_t offset = mesh_offset(bytes, version, index);
  if (read_at<uint16_t>(bytes, offset) != kFormatId) {
    throw Error("no mesh starts where its table says");
  }
  if (bytes.size() - offset < 4) throw Error("the file ends too early");
  InflateStream stream(bytes.substr(offset + 4));
  return read_mesh(stream, read_at<uint16_t>(bytes, offset + 2), has_face_normals);
}

}  // namespace

Mesh read_serialized_mesh(const std::string& path, int index, bool& has_face_normals) {
  const std::string bytes = read_file_bytes(path);
  Mesh mesh;
  try {
    mesh = read_from_bytes(bytes, index, has_face_normals);
  } catch (const std::exception& error) {
    throw Error("Cannot read the mesh '{}': {}; export it again or correct shapeIndex.", path,
                error.what());
  }
  check_mesh(mesh, fmt::format("{}' number '{}", path, index));
  return mesh;
}

}  // namespace guidelight
