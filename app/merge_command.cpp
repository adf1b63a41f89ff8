#include <fmt/core.h>

#include <map>

#include "app/commands.h"
#include "app/scene_arguments.h"
#include "renderer/error.h"
#include "renderer/session/checkpoints.h"

namespace guidelight {

namespace {

void merge(const std::vector<std::string>& inputs, const std::string& output) {
  const Checkpoint first = read_checkpoint(inputs.front());
  auto film = std::make_shared<Film>(*first.film);
  Checkpoint merged = first;
  std::map<uint64_t, std::string> files = {{first.seed, inputs[0]}};  // by seed
  for (size_t i = 1; i < inputs.size(); ++i) {
    const Checkpoint next = read_checkpoint(inputs[i]);
    if (next.identity != first.identity) {
      throw Error("{} and {} show different scenes or settings: merge parts of one render",
                  inputs[0], inputs[i]);
    }
    const auto [same, is_new] = files.insert({next.seed, inputs[i]});
    if (!is_new) {
      throw Error(
          "{} and {} were rendered with the same seed and hold the same samples: use another "
          "--seed for each part",
          same->second, inputs[i]);
    }
    film->merge(*next.film);
    merged.seconds += next.seconds;
    merged.next_pass += next.next_pass;
  }
  merged.film = film;
  ImageLayers picture;
  picture.metadata = describe_checkpoint(merged);
  picture.metadata["passes"] = fmt::format("{}", merged.next_pass);
  picture.metadata["seconds"] = fmt::format("{:.3f}", merged.seconds);
  for (const Layer layer : kAllLayers)
    picture.layers.emplace_back(layer_name(layer), film->develop(layer));
  write_exr(output, picture);
  fmt::print("{}\n", output);
}

}  // namespace

void add_merge_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "merge", "Join checkpoints of one render made with different seeds into one EXR");
  const auto inputs = std::make_shared<std::vector<std::string>>();
  const auto output = std::make_shared<std::string>();
  command->add_option("CHECKPOINTS", *inputs, "Files written by render --checkpoint")->required();
  command->add_option("-o,--output", *output, "EXR to write")->required()->check(ends_in(".exr"));
  command->callback([inputs, output] { merge(*inputs, *output); });
}

}  // namespace guidelight
