#pragma once

#include "renderer/integrators/guide_settings.h"
#include "renderer/integrators/integrator.h"
#include "renderer/integrators/search_radius.h"
#include "renderer/photons/density_estimate.h"
#include "renderer/transport/mis.h"

namespace guidelight {

/// The members of the family: what differs is which techniques they combine.
enum class BidirectionalKind { LightTracing, Bdpt, ProbabilisticPpm, Bpm, Bdpm, Vcm };

/// Settings of all integrators of the bidirectional kernel; each shows those that concern it.
struct BidirectionalSettings : IntegratorSettings, RadiusSettings, GuideSettings {
  explicit BidirectionalSettings(BidirectionalKind which);

  BidirectionalKind kind;
  int max_length = 12;    // segments
  int min_length = 1;     // segments
  float light_paths = 1;  // per pixel and pass
  bool emission = true;   // techniques, BDPT and VCM
  bool next_event = true;
  bool light_tracing = true;
  bool connections = true;
  bool merging = true;
  int connect_to = 0;       // 0: the pixel's own light path, 1: random vertices of all
  int random_vertices = 4;  // per camera vertex
  float alpha = 0.75f;      // radius of pass i is r·i^((α-1)/2)
  int neighbors = 50;       // BDPM: photons of an estimate
  int kernel = static_cast<int>(Kernel::Cone);
  bool merge_direct = false;
  bool lean = false;

  bool merges() const;
  /// Merges with the k nearest photons, not with all within a radius.
  bool merges_nearest() const { return kind == BidirectionalKind::Bdpm; }
  bool connects_to_random_vertices() const;
  /// Nothing is looked for beyond the first camera vertex that scatters by a finite lobe.
  bool ends_at_first_finite_vertex() const;

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override;
};

}  // namespace guidelight
