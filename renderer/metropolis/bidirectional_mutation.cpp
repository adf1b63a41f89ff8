#include "renderer/metropolis/bidirectional_mutation.h"

#include <cmath>

#include "renderer/metropolis/bidirectional_sampler.h"

namespace guidelight {

namespace {

using Gap = BidirectionalSampler::Gap;

/// How the gaps that may be cut into paths of a number of vertices are chosen, and how many
/// vertices fill them.
class GapTable {
 public:
  GapTable(int size, const PathLengths& lengths);

  Gap sample(Rng& rng) const;
  /// Probability of a gap between so many kept vertices that is filled to a path of `new_size`.
  float probability(int from_light, int from_eye, int new_size) const;

  /// A new size where the gap is given, or 0 if there is no such gap.
  int sample_size(int from_light, int from_eye, float u) const;
  float size_probability(int from_light, int from_eye, int new_size) const;

 private:
  struct Cut {
    int from_light;
    int from_eye;
    int min_size;                // of the new path
    DiscreteDistribution sizes;  // of the new path, from min_size on

    int sample_size(float u) const { return min_size + static_cast<int>(sizes.sample(u).index); }
    float probability(int new_size) const {
      const int which = new_size - min_size;
      return which >= 0 && which < static_cast<int>(sizes.size()) ? sizes.pmf(which) : 0;
    }
  };
  /// Null if there is none.
  const Cut* cut(int from_light, int from_eye) const {
    const int i = from_light + from_eye <= size_ ? index_[from_light * (size_ + 1) + from_eye] : -1;
    return i < 0 ? nullptr : &cuts_[i];
  }

  int size_;
  std::vector<Cut> cuts_;
  std::vector<int> index_;  // of a cut by (from_light, from_eye), -1 if there is none
  DiscreteDistribution distribution_;
};

/// Veach prefers short gaps: of one or two segments, then each half as often as the one before.
float gap_weight(int segments) {
  return segments == 1   ? 0.25f
         : segments == 2 ? 0.5f
                         : std::pow(0.5f, static_cast<float>(segments));
}

/// … and lengths that stay.
float growth_weight(int growth) {
  return growth == 0 ? 0.5f : 0.3f * std::pow(0.5f, static_cast<float>(std::abs(growth)));
}

GapTable::GapTable(int size, const PathLengths& lengths)
    : size_(size), index_((size + 1) * (size + 1), -1) {
  // All of a path, often enough that a chain never stays away from a part of the picture for long.
  constexpr float kWholePath = 0.1f;
  std::vector<float> weights;
  // The lens is not kept from the light's side, nor the light from the eye's.
  for (int from_light = 0; from_light < size; ++from_light) {
    for (int from_eye = 0; from_eye < size && from_light + from_eye <= size; ++from_eye) {
      const int removed = size - from_light - from_eye;
      if (from_light == 1 || from_eye == 1) continue;
      Cut cut{from_light, from_eye, 0, {}};
      std::vector<float> size_weights;
      for (int new_size = lengths.min + 1; new_size <= lengths.max + 1; ++new_size) {
        const Gap gap{from_light, new_size - from_light - from_eye, from_eye};
        const bool changes = removed + gap.inserted > 0;
        if (!gap.is_possible() || !changes) continue;
        if (size_weights.empty()) cut.min_size = new_size;
        size_weights.push_back(growth_weight(new_size - size));
      }
      if (size_weights.empty()) continue;
      cut.sizes = DiscreteDistribution(size_weights);
      index_[from_light * (size + 1) + from_eye] = static_cast<int>(cuts_.size());
      cuts_.push_back(std::move(cut));
      // Where one gap length has several places, they share its weight.
      weights.push_back(removed == size
                            ? kWholePath
                            : gap_weight(removed + 1) / static_cast<float>(size - removed + 1));
    }
  }
  distribution_ = DiscreteDistribution(weights);
}

Gap GapTable::sample(Rng& rng) const {
  const Cut& cut = cuts_[distribution_.sample(rng.next_float()).index];
  const int new_size = cut.sample_size(rng.next_float());
  return {cut.from_light, new_size - cut.from_light - cut.from_eye, cut.from_eye};
}

float GapTable::probability(int from_light, int from_eye, int new_size) const {
  const Cut* found = cut(from_light, from_eye);
  if (!found) return 0;
  const auto i = static_cast<uint32_t>(found - cuts_.data());
  return distribution_.pmf(i) * found->probability(new_size);
}

int GapTable::sample_size(int from_light, int from_eye, float u) const {
  const Cut* found = cut(from_light, from_eye);
  return found ? found->sample_size(u) : 0;
}

float GapTable::size_probability(int from_light, int from_eye, int new_size) const {
  const Cut* found = cut(from_light, from_eye);
  return found ? found->probability(new_size) : 0;
}

// Where a vertex drawn from the light's (the eye's) side has no other place to be, it gets there
// with a probability: what the density of Path must be divided by to be that. 0 elsewhere.
double forced_from_light(const Path& path, int i) {
  if (i == 0) return path.light->is_delta() ? 1 : 0;
  return path.is_finite(i - 1) ? 0 : path.points[i - 1].arrival_eye;
}
double forced_from_eye(const Scene& scene, const Path& path, int i) {
  if (i == path.length()) return scene.camera().has_pinhole() ? 1 : 0;
  if (path.is_finite(i + 1)) return 0;
  return double{path.points[i + 1].jacobian} * path.points[i].arrival_light;
}

class BidirectionalMutation : public Mutation {
 public:
  BidirectionalMutation(const Scene& scene, const PathLengths& lengths)
      : scene_(scene), sampler_(scene), min_size_(lengths.min + 1) {
    for (int length = lengths.min; length <= lengths.max; ++length) {
      tables_.emplace_back(length + 1, lengths);
    }
  }

  std::string name() const override { return "bidirectional"; }
  bool is_suitable(const Path&) const override { return true; }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    const Gap gap = table(x).sample(rng);
    y.splice(x, gap.from_light, gap.inserted, gap.from_eye);
    return sampler_.fill(gap, y, rng);
  }

  /// Over all gaps whose filling makes y: those between what the paths share. A smaller kept part
  /// would have to draw a shared vertex anew, which has no density in the measure of the others,
  /// but for vertices that cannot turn out otherwise: those have a probability.
  double density(const Path& x, const Path& y) const override {
    const int shared_with_eye = shared_from_eye(x, y);
    double sum = 0;
    double forced_light = 1;
    for (int i = shared_from_light(x, y); i >= 0 && forced_light > 0; --i) {
      double forced = forced_light;
      for (int j = shared_with_eye; j >= 0 && forced > 0; --j) {
        sum += gap_density(x, y, i, j) / forced;
        if (j > 0) forced *= forced_from_eye(scene_, y, y.size() - j);
      }
      if (i > 0) forced_light *= forced_from_light(y, i - 1);
    }
    return sum;
  }

 protected:
  const GapTable& table(const Path& x) const { return tables_[x.size() - min_size_]; }
  const Scene& scene() const { return scene_; }

 private:
  /// Of the gap that keeps so many vertices of x.
  double gap_density(const Path& x, const Path& y, int from_light, int from_eye) const {
    const Gap gap{from_light, y.size() - from_light - from_eye, from_eye};
    const float probability = table(x).probability(from_light, from_eye, y.size());
    return probability > 0 && gap.is_possible() ? probability * sampler_.density(gap, y) : 0;
  }

  const Scene& scene_;
  BidirectionalSampler sampler_;
  int min_size_;
  std::vector<GapTable> tables_;  // by the number of vertices
};

/// UP of Fan et al. 2005, section 5.2, with two changes. All of the light's side is drawn anew,
/// half of the time with a guide and half of the time without: a path that has been found along a
/// guide could else hardly be left again, and would hardly be accepted. And where the guide ends
/// the path may go on. What is kept is the eye's side up to its first finite vertex, as in the
/// source, or nothing: caustics that the eye sees directly need that.
class GuidedMutation final : public BidirectionalMutation {
 public:
  GuidedMutation(const Scene& scene, const PathLengths& lengths,
                 std::shared_ptr<const GuideMixture> guides, float guided)
      : BidirectionalMutation(scene, lengths),
        sampler_(scene, {std::move(guides), kGuideShare}),
        guided_(guided) {}

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    if (rng.next_float() >= guided_) return BidirectionalMutation::propose(x, y, rng);
    const int kept = rng.next_float() < kWholePath ? 0 : kept_from_eye(x);
    const int size = table(x).sample_size(0, kept, rng.next_float());
    const Gap gap{0, size - kept, kept};
    if (size == 0) return false;
    y.splice(x, 0, gap.inserted, kept);
    return sampler_.fill(gap, y, rng);
  }

  double density(const Path& x, const Path& y) const override {
    return guided_ * guided_density(x, y) + (1 - guided_) * BidirectionalMutation::density(x, y);
  }

 private:
  static constexpr float kGuideShare = 0.5f;
  static constexpr float kWholePath = 0.5f;

  /// Vertices from the lens to the first finite one; 0 where the eye sees the light by specular
  /// events alone.
  static int kept_from_eye(const Path& x) {
    const int first = x.next_finite_towards_light(x.length());
    return first > 0 ? x.size() - first : 0;
  }

  /// As of the bidirectional mutation: what the paths share was kept, nothing more.
  double guided_density(const Path& x, const Path& y) const {
    if (shared_from_light(x, y) > (y.light->is_delta() ? 1 : 0)) return 0;
    const int kept = kept_from_eye(x);
    const int shared = shared_from_eye(x, y);
    double sum = 0;
    if (shared <= (scene().camera().has_pinhole() ? 1 : 0)) {
      sum += (kept == 0 ? 1 : kWholePath) * size_density(x, y, 0);
    }
    if (kept > 0 && shared == kept) sum += (1 - kWholePath) * size_density(x, y, kept);
    return sum;
  }

  double size_density(const Path& x, const Path& y, int kept) const {
    const Gap gap{0, y.size() - kept, kept};
    const float probability = table(x).size_probability(0, kept, y.size());
    return probability > 0 && gap.is_possible() ? probability * sampler_.density(gap, y) : 0;
  }

  BidirectionalSampler sampler_;
  float guided_;
};

}  // namespace

std::unique_ptr<Mutation> make_bidirectional_mutation(const Scene& scene,
                                                      const PathLengths& lengths,
                                                      std::shared_ptr<const GuideMixture> guides,
                                                      float guided) {
  if (!guides || guided == 0) return std::make_unique<BidirectionalMutation>(scene, lengths);
  return std::make_unique<GuidedMutation>(scene, lengths, std::move(guides), guided);
}

}  // namespace guidelight
