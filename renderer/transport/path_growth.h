#pragma once

#include "renderer/sampling/primary_samples.h"
#include "renderer/transport/path.h"

namespace guidelight {

// How explicit paths are built, vertex by vertex. Each function returns false where the path ends;
// Path::update() computes what follows from the vertices once they all stand. `Random` is Rng or
// PrimarySamples.

/// Makes x₀ what a light has emitted from, with the first direction.
void start_from(Path& path, const Light& light, const EmissionSample& emission);

/// Draws x₀ on a light and the first direction; points[0] must exist. At infinity also the place of
/// the first ray, which goes to `ray`.
template <typename Random>
bool sample_light(const Scene& scene, Path& path, Random& rng, Ray& ray);

/// Draws the lens vertex for a place in the picture; the first ray from there goes to `ray`.
void sample_lens(const Scene& scene, Path& path, Vec2 raster, Vec2 u_lens, Ray& ray);

/// Puts the lens vertex where it can be joined with the vertex before.
bool connect_to_lens(const Scene& scene, Path& path, Vec2 u_lens);

/// Makes points[i] what a ray from the light's side hits.
bool arrive_from_light(const Scene& scene, Path& path, int i, const Ray& ray);
/// Makes points[i] what a ray from the eye's side hits or, for i = 0, the light that it finds; u
/// chooses one of several lights at infinity.
bool arrive_from_eye(const Scene& scene, Path& path, int i, const Ray& ray, float u);

/// Draws the way on from vertex i by its BSDF; sets its event and arrives at the next vertex.
template <typename Random>
bool scatter_to_eye(const Scene& scene, Path& path, int i, Vec3 to_light, Random& rng);
template <typename Random>
bool scatter_to_light(const Scene& scene, Path& path, int i, Vec3 to_eye, Random& rng);

/// From vertex `from` along `ray` to vertex `to`, scattering between by the delta events that the
/// vertices have (of another path with as many vertices: the one that is being mutated).
bool follow_to_eye(const Scene& scene, Path& path, int from, int to, Ray ray);
bool follow_to_light(const Scene& scene, Path& path, int from, int to, Ray ray, float u);

/// Unit directions from a vertex to its neighbours, from positions alone: edges need not be
/// updated.
Vec3 direction_to_light(const Path& path, int i);
Vec3 direction_to_eye(const Path& path, int i);

/// Whether vertex i has a finite lobe, or is an end of the path.
bool may_scatter_finitely(const Path& path, int i);
/// Lets vertices i and i + 1 scatter finitely, to be joined by a connection; false if one cannot.
bool join(Path& path, int i);

/// Whether nothing stands between vertices i and i + 1, whose edge is up to date.
bool is_visible(const Scene& scene, const Path& path, int i);

}  // namespace guidelight
