#include "renderer/scene/accelerator.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <atomic>
#include <map>

#include "renderer/error.h"
#include "renderer/scene/analytic_shape.h"
#include "renderer/scene/reach.h"
#include "renderer/scene/triangle_mesh.h"

namespace guidelight {

namespace {

constexpr size_t kPacket = 8;

#if RTC_VERSION_MAJOR < 4
/// Rays of a packet come from neighbouring paths, but after the first hit they go anywhere:
/// traversal that follows each ray by itself inside the packet is twice as fast here as pure packet
/// traversal (docs/performance.md).
RTCIntersectContext make_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}
#endif

void bound_analytic(const RTCBoundsFunctionArguments* arguments) {
  const Bounds b = static_cast<const AnalyticShape*>(arguments->geometryUserPtr)->bounds();
  *arguments->bounds_o = {b.lower.x, b.lower.y, b.lower.z, 0, b.upper.x, b.upper.y, b.upper.z, 0};
}

Ray lane(RTCRayN* rays, unsigned n, unsigned i) {
  return {Vec3(RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)),
          Vec3(RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)),
          RTCRayN_tfar(rays, n, i)};
}

/// The rays of a full packet: eight of one coordinate follow each other.
RayLanes lanes_of(RTCRayN* rays) {
  constexpr size_t n = RayLanes::kCount;
  const auto eight = [](const float& first) {
    RayLanes::Lanes lanes;
    std::copy_n(&first, n, lanes.begin());
    return lanes;
  };
  return {{eight(RTCRayN_org_x(rays, n, 0)), eight(RTCRayN_org_y(rays, n, 0)),
           eight(RTCRayN_org_z(rays, n, 0))},
          {eight(RTCRayN_dir_x(rays, n, 0)), eight(RTCRayN_dir_y(rays, n, 0)),
           eight(RTCRayN_dir_z(rays, n, 0))},
          eight(RTCRayN_tnear(rays, n, 0)),
          eight(RTCRayN_tfar(rays, n, 0))};
}

/// Calls met(i, t) for every ray of a packet that meets the shape.
template <typename Met>
void for_each_met(void* user_shape, RTCRayN* rays, const int* valid, unsigned n, Met&& met) {
  const auto& shape = *static_cast<const AnalyticShape*>(user_shape);
  if (n == RayLanes::kCount) {
    const RayLanes::Lanes t = shape.intersect(lanes_of(rays));
    for (unsigned i = 0; i < n; ++i) {
      if (valid[i] && t[i] < kInfinity) met(i, t[i]);
    }
    return;
  }
  for (unsigned i = 0; i < n; ++i) {
    float t;
    if (valid[i] && shape.intersect(lane(rays, n, i), RTCRayN_tnear(rays, n, i), t)) met(i, t);
  }
}

void intersect_analytic(const RTCIntersectFunctionNArguments* arguments) {
  const unsigned n = arguments->N;
  RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, n);
  RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, n);
  for_each_met(arguments->geometryUserPtr, rays, arguments->valid, n, [&](unsigned i, float t) {
    RTCRayN_tfar(rays, n, i) = t;
    RTCHitN_geomID(hits, n, i) = arguments->geomID;
    RTCHitN_primID(hits, n, i) = arguments->primID;
    RTCHitN_instID(hits, n, i, 0) = arguments->context->instID[0];
  });
}

void occlude_analytic(const RTCOccludedFunctionNArguments* arguments) {
  const unsigned n = arguments->N;
  RTCRayN* rays = arguments->ray;
  for_each_met(arguments->geometryUserPtr, rays, arguments->valid, n,
               [&](unsigned i, float) { RTCRayN_tfar(rays, n, i) = -kInfinity; });
}

struct SceneHolder {
  explicit SceneHolder(RTCDevice device) : scene(rtcNewScene(device)) {
    // Robust: rays do not slip through the edges that triangles share. Without it, 0.4 % of the
    // rays that are aimed at edges do.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
  }
  ~SceneHolder() { rtcReleaseScene(scene); }
  SceneHolder(const SceneHolder&) = delete;
  SceneHolder& operator=(const SceneHolder&) = delete;

  RTCScene scene;
};

}  // namespace

struct Accelerator::Impl {
  uint32_t first_instance;  // geometry ids of instances follow those of the shapes
  RTCDevice device = rtcNewDevice(nullptr);
  std::unique_ptr<SceneHolder> top = std::make_unique<SceneHolder>(device);
  std::map<int, SceneHolder> groups;
  std::atomic<ssize_t> bytes{0};

  explicit Impl(uint32_t shape_count) : first_instance(shape_count) {
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* self, ssize_t change, bool) {
          static_cast<Impl*>(self)->bytes += change;
          return true;
        },
        this);
  }
  ~Impl() {
    groups.clear();
    top.reset();
    rtcReleaseDevice(device);
  }

  void attach(RTCScene scene, RTCGeometry geometry, uint32_t id) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
  }

  void throw_on_error() {
    switch (rtcGetDeviceError(device)) {
      case RTC_ERROR_NONE:
        return;
      case RTC_ERROR_OUT_OF_MEMORY:
        throw Error(
            "the scene's ray-tracing hierarchy does not fit into memory: use smaller meshes");
      default:
        throw Error("the ray-tracing library rejected the scene's geometry: check its meshes");
    }
  }
};

Accelerator::Accelerator(uint32_t shape_count) : impl_(std::make_unique<Impl>(shape_count)) {}
Accelerator::~Accelerator() = default;

void Accelerator::add_shape(const Shape& shape, uint32_t id, int group) {
  RTCScene scene = impl_->top->scene;
  if (group != kNone) scene = impl_->groups.try_emplace(group, impl_->device).first->second.scene;
  if (const auto* mesh = dynamic_cast<const TriangleMesh*>(&shape)) {
    RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh->positions().data(), 0, sizeof(Vec3), mesh->positions().size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh->triangles().data(), 0, sizeof(mesh->triangles()[0]),
                               mesh->triangles().size());
    impl_->attach(scene, geometry, id);
  } else {
    const auto& analytic = dynamic_cast<const AnalyticShape&>(shape);
    RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, const_cast<AnalyticShape*>(&analytic));
    rtcSetGeometryBoundsFunction(geometry, bound_analytic, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_analytic);
    rtcSetGeometryOccludedFunction(geometry, occlude_analytic);
    impl_->attach(scene, geometry, id);
  }
}

void Accelerator::add_instance(int group, const Mat4& to_world, uint32_t id) {
  const auto found = impl_->groups.find(group);
  if (found == impl_->groups.end()) return;  // an empty group shows nothing
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, found->second.scene);
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &to_world[0][0]);
  impl_->attach(impl_->top->scene, geometry, impl_->first_instance + id);
}

void Accelerator::build() {
  for (auto& [id, group] : impl_->groups) rtcCommitScene(group.scene);
  rtcCommitScene(impl_->top->scene);
  impl_->throw_on_error();
}

size_t Accelerator::bytes() const { return static_cast<size_t>(impl_->bytes.load()); }

namespace {

Hit make_hit(float t, uint32_t geometry, uint32_t primitive, uint32_t instance, float u, float v,
             uint32_t first_instance) {
  Hit hit;
  if (geometry == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.t = t;
  hit.shape = geometry;
  hit.primitive = primitive;
  hit.instance = instance == RTC_INVALID_GEOMETRY_ID ? kInvalidIndex : instance - first_instance;
  hit.barycentric = {u, v};
  return hit;
}

/// Embree ends the process for a ray that it calls invalid: not a number, or so large that its
/// square is not finite. Such rays are not traced.
bool is_valid(const Ray& ray) {
  return is_within(ray.origin, kLargestRay) && is_within(ray.direction, kLargestRay) &&
         !std::isnan(ray.t_max);
}

/// The same for a packet; without branches, so that all lanes are checked at once.
template <typename Packet>
void switch_off_invalid(const Packet& packet, int (&valid)[kPacket]) {
  const auto is_small = [](float x) { return -static_cast<int>(std::abs(x) <= kLargestRay); };
  for (size_t i = 0; i < kPacket; ++i) {
    valid[i] &= is_small(packet.org_x[i]) & is_small(packet.org_y[i]) & is_small(packet.org_z[i]) &
                is_small(packet.dir_x[i]) & is_small(packet.dir_y[i]) & is_small(packet.dir_z[i]) &
                -static_cast<int>(packet.tfar[i] == packet.tfar[i]);
  }
}

/// Copies up to kPacket rays into a packet; lanes beyond, and of invalid rays, are switched off.
template <typename Packet>
void load(std::span<const Ray> rays, Packet& packet, int (&valid)[kPacket]) {
  for (size_t i = 0; i < kPacket; ++i) {
    valid[i] = i < rays.size() ? -1 : 0;
    const Ray& ray = rays[std::min(i, rays.size() - 1)];
    packet.org_x[i] = ray.origin.x;
    packet.org_y[i] = ray.origin.y;
    packet.org_z[i] = ray.origin.z;
    packet.dir_x[i] = ray.direction.x;
    packet.dir_y[i] = ray.direction.y;
    packet.dir_z[i] = ray.direction.z;
    packet.tnear[i] = 0;
    packet.tfar[i] = ray.t_max;
    packet.time[i] = 0;
    packet.mask[i] = 0xffffffffu;
    packet.id[i] = 0;
    packet.flags[i] = 0;
  }
  switch_off_invalid(packet, valid);
}

/// Whether all rays of a packet go almost the same way, as camera rays do: they are faster
/// together.
template <typename Packet>
bool is_coherent(const Packet& packet) {
  constexpr float kAlmost = 0.1f;  // for unit directions
  float spread = 0;
  for (size_t i = 0; i < kPacket; ++i) {
    const float difference = std::abs(packet.dir_x[i] - packet.dir_x[0]) +
                             std::abs(packet.dir_y[i] - packet.dir_y[0]) +
                             std::abs(packet.dir_z[i] - packet.dir_z[0]);
    spread = std::max(spread, difference);
  }
  return spread < kAlmost;
}

template <typename RtcRay>
void load(const Ray& ray, RtcRay& out) {
  out = {};
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.tfar = ray.t_max;
  out.mask = 0xffffffffu;
}

}  // namespace

Hit Accelerator::intersect(const Ray& ray) const {
  if (!is_valid(ray)) return {};
  RTCRayHit query;
  load(ray, query.ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(impl_->top->scene, &query);
#else
  RTCIntersectContext context = make_context();
  rtcIntersect1(impl_->top->scene, &context, &query);
#endif
  return make_hit(query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.instID[0],
                  query.hit.u, query.hit.v, impl_->first_instance);
}

bool Accelerator::occluded(const Ray& ray) const {
  if (!is_valid(ray)) return false;
  RTCRay query;
  load(ray, query);
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(impl_->top->scene, &query);
#else
  RTCIntersectContext context = make_context();
  rtcOccluded1(impl_->top->scene, &context, &query);
#endif
  return query.tfar < 0;
}

void Accelerator::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  alignas(32) int valid[kPacket];
  RTCRayHit8 packet;
  for (size_t first = 0; first < rays.size(); first += kPacket) {
    const size_t count = std::min(kPacket, rays.size() - first);
    load(rays.subspan(first, count), packet.ray, valid);
    for (size_t i = 0; i < kPacket; ++i) {
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect8(valid, impl_->top->scene, &packet);
#else
    RTCIntersectContext context = make_context();
    if (is_coherent(packet.ray)) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid, impl_->top->scene, &context, &packet);
#endif
    for (size_t i = 0; i < count; ++i) {
      hits[first + i] = make_hit(packet.ray.tfar[i], packet.hit.geomID[i], packet.hit.primID[i],
                                 packet.hit.instID[0][i], packet.hit.u[i], packet.hit.v[i],
                                 impl_->first_instance);
    }
  }
}

void Accelerator::occluded(std::span<const Ray> rays, std::span<uint8_t> blocked) const {
  alignas(32) int valid[kPacket];
  RTCRay8 packet;
  for (size_t first = 0; first < rays.size(); first += kPacket) {
    const size_t count = std::min(kPacket, rays.size() - first);
    load(rays.subspan(first, count), packet, valid);
#if RTC_VERSION_MAJOR >= 4
    rtcOccluded8(valid, impl_->top->scene, &packet);
#else
    RTCIntersectContext context = make_context();
    rtcOccluded8(valid, impl_->top->scene, &context, &packet);
#endif
    for (size_t i = 0; i < count; ++i) blocked[first + i] = packet.tfar[i] < 0;
  }
}

}  // namespace guidelight
