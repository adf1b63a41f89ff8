#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "renderer/image/film.h"
#include "renderer/integrators/chain_statistics.h"
#include "renderer/photons/photon_cloud.h"

namespace guidelight {

enum class SessionState { Idle, Rendering, Paused, Finished, Failed };

/// The state of a render at one moment, immutable. Copies share the picture.
struct Snapshot {
  using Layers = std::array<Image, kLayerCount>;  // by Layer

  uint64_t generation = 0;  // grows with every snapshot
  uint64_t job = 0;         // grows with every restart: which command this answers
  SessionState state = SessionState::Idle;
  int full_width = 0;  // of the job; the layers of a coarse picture are smaller
  int full_height = 0;
  bool coarse = false;
  uint32_t passes = 0;
  double seconds = 0;  // spent rendering, pauses excluded
  uint64_t samples = 0;
  /// Mean since the job began, shadow rays included; coarse pictures are not counted.
  double rays_per_second = 0;
  uint64_t rejected_samples = 0;  // not finite, counted as black
  double relative_error = 0;      // Film::estimated_relative_error
  float progress = 0;             // towards the nearest target, 0..1; 0 without targets
  std::string error;              // why it failed, if it did
  std::shared_ptr<const Layers> layers = std::make_shared<const Layers>();

  /// The photons of a recent pass; null unless asked for, and for methods without photons.
  std::shared_ptr<const PhotonCloud> photons;

  /// Of methods with Markov chains, else empty.
  std::optional<ChainStatistics> chains;

  bool has_picture() const { return !layer(Layer::Beauty).empty(); }
  const Image& layer(Layer which) const { return (*layers)[static_cast<size_t>(which)]; }
};

}  // namespace guidelight
