#include "renderer/io/checkpoint_file.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "renderer/error.h"
#include "renderer/io/atomic_file.h"

namespace guidelight {

namespace {

constexpr const char* kMark = "guidelight_checkpoint";  // key of the version
constexpr int kVersion = 3;
constexpr int kLargestSide = 65536;
constexpr float kLargestRadius = 32;  // [pixels] that scenes may ask of a filter

nlohmann::json filter_json(const FilterSettings& f) {
  return {{"kind", static_cast<int>(f.kind)},
          {"radius", f.radius},
          {"stddev", f.stddev},
          {"b", f.b},
          {"c", f.c}};
}

FilterSettings filter_from(const std::string& path, const nlohmann::json& json) {
  FilterSettings f;
  const int kind = json.at("kind");
  f.radius = json.at("radius");
  const bool is_known = kind >= 0 && kind <= static_cast<int>(FilterKind::Mitchell);
  if (!is_known || !(f.radius >= 0 && f.radius <= kLargestRadius)) {
    throw Error("{}: a filter of kind {} and radius {} is not possible: the file is damaged", path,
                kind, f.radius);
  }
  f.kind = static_cast<FilterKind>(kind);
  f.stddev = json.at("stddev");
  f.b = json.at("b");
  f.c = json.at("c");
  return f;
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  const Film& film = *checkpoint.film;
  const std::vector<double> state = film.state();
  const nlohmann::json header = {{kMark, kVersion},
                                 {"width", film.width()},
                                 {"height", film.height()},
                                 {"filter", filter_json(film.filter().settings())},
                                 {"next_pass", checkpoint.next_pass},
                                 {"seconds", checkpoint.seconds},
                                 {"seed", checkpoint.seed},
                                 {"numbers", state.size()},
                                 {"identity", checkpoint.identity}};
  std::string bytes;
  try {
    bytes = header.dump() + "\n";
  } catch (const nlohmann::json::exception&) {
    throw Error("{}: the scene's path or a variable of it is not UTF-8 text: rename it", path);
  }
  const size_t start = bytes.size();
  bytes.resize(start + state.size() * sizeof(double));
  std::memcpy(bytes.data() + start, state.data(), state.size() * sizeof(double));
  write_file_atomically(path, bytes);
}

Checkpoint read_checkpoint(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error("{}: cannot open the checkpoint: check the path", path);
  std::string line;
  std::getline(file, line);
  try {
    const nlohmann::json header = nlohmann::json::parse(line);
    if (header.at(kMark) != kVersion) {
      throw Error("{}: written by another version of the program: render again", path);
    }
    const int width = header.at("width");
    const int height = header.at("height");
    if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
      throw Error("{}: a film of {}x{} pixels is not possible: the file is damaged", path, width,
                  height);
    }
    std::ostringstream rest;
    rest << file.rdbuf();
    const std::string bytes = std::move(rest).str();
    if (bytes.size() != header.at("numbers").get<size_t>() * sizeof(double)) {
      throw Error("{}: the checkpoint is cut off: use an older copy or render again", path);
    }
    std::vector<double> state(bytes.size() / sizeof(double));
    std::memcpy(state.data(), bytes.data(), bytes.size());
    auto film = std::make_shared<Film>(width, height, filter_from(path, header.at("filter")));
    film->restore(state);
    Checkpoint checkpoint;
    checkpoint.film = std::move(film);
    checkpoint.next_pass = header.at("next_pass");
    checkpoint.seconds = header.at("seconds");
    checkpoint.seed = header.at("seed");
    checkpoint.identity = header.at("identity").get<Metadata>();
    return checkpoint;
  } catch (const nlohmann::json::exception&) {
    throw Error("{}: this is not a checkpoint, or its first line is damaged: check the path", path);
  }
}

bool is_checkpoint(const std::string& path) {
  constexpr size_t kBeginning = 1024;  // the keys are in alphabetical order
  std::error_code ignored;             // opening a pipe would wait for its other end
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string beginning(kBeginning, ' ');
  file.read(beginning.data(), kBeginning);
  return beginning.starts_with("{") && beginning.find(kMark) != std::string::npos;
}

}  // namespace guidelight
