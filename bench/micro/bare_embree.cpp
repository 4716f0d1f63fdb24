#include "bench/micro/bare_embree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <type_traits>

namespace gibench::micro {

namespace {

template <std::size_t width>
using HitPacket = std::conditional_t<width == 8, RTCRayHit8, RTCRayHit16>;
template <std::size_t width>
using RayPacket = std::conditional_t<width == 8, RTCRay8, RTCRay16>;

void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* query) {
  rtcIntersect8(valid, scene, context, query);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* query) {
  rtcIntersect16(valid, scene, context, query);
}
void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay8* query) {
  rtcOccluded8(valid, scene, context, query);
}
void occlude(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRay16* query) {
  rtcOccluded16(valid, scene, context, query);
}

void load(RTCRay& query, const Ray& ray) {
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = ray.t_min, query.tfar = ray.t_max;
  query.time = 0.0F, query.mask = ~0U, query.id = 0, query.flags = 0;
}

template <class Packet>
void load_packet(Packet& query, const Ray* rays, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    query.org_x[i] = rays[i].origin.x, query.org_y[i] = rays[i].origin.y, query.org_z[i] = rays[i].origin.z;
    query.dir_x[i] = rays[i].direction.x, query.dir_y[i] = rays[i].direction.y, query.dir_z[i] = rays[i].direction.z;
    query.tnear[i] = rays[i].t_min, query.tfar[i] = rays[i].t_max;
    query.time[i] = 0.0F, query.mask[i] = ~0U, query.id[i] = 0, query.flags[i] = 0;
  }
}

}  // namespace

struct BareEmbree::Impl {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

BareEmbree::BareEmbree(const Scene& scene) : impl_(std::make_unique<Impl>()) {
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(impl_->scene, RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), scene.vertices.size());
  std::copy(scene.vertices.begin(), scene.vertices.end(), static_cast<Vec3*>(vertices));
  void* triangles =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), scene.triangles.size());
  std::copy(scene.triangles.begin(), scene.triangles.end(), static_cast<Triangle*>(triangles));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}
BareEmbree::~BareEmbree() = default;

std::uint64_t BareEmbree::closest_hits(std::span<const Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  std::uint64_t sum = 0;
  for (const Ray& ray : rays) {
    RTCRayHit query;
    load(query.ray, ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene, &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) sum += query.hit.primID + 1U;
  }
  return sum;
}

std::uint64_t BareEmbree::occlusions(std::span<const Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  std::uint64_t sum = 0;
  for (const Ray& ray : rays) {
    RTCRay query;
    load(query, ray);
    rtcOccluded1(impl_->scene, &context, &query);
    sum += query.tfar < 0.0F ? 1U : 0U;
  }
  return sum;
}

template <std::size_t width>
std::uint64_t BareEmbree::closest_hits_in_packets(std::span<const Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) int valid[width];
  std::fill_n(valid, width, -1);
  std::uint64_t sum = 0;
  for (std::size_t first = 0; first < rays.size(); first += width) {
    HitPacket<width> query;
    load_packet(query.ray, rays.data() + first, width);
    std::fill_n(query.hit.geomID, width, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(query.hit.instID[0], width, RTC_INVALID_GEOMETRY_ID);
    intersect(valid, impl_->scene, &context, &query);
    for (std::size_t i = 0; i < width; ++i)
      if (query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) sum += query.hit.primID[i] + 1U;
  }
  return sum;
}

template <std::size_t width>
std::uint64_t BareEmbree::occlusions_in_packets(std::span<const Ray> rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(64) int valid[width];
  std::fill_n(valid, width, -1);
  std::uint64_t sum = 0;
  for (std::size_t first = 0; first < rays.size(); first += width) {
    RayPacket<width> query;
    load_packet(query, rays.data() + first, width);
    occlude(valid, impl_->scene, &context, &query);
    for (std::size_t i = 0; i < width; ++i) sum += query.tfar[i] < 0.0F ? 1U : 0U;
  }
  return sum;
}

template std::uint64_t BareEmbree::closest_hits_in_packets<8>(std::span<const Ray>) const;
template std::uint64_t BareEmbree::closest_hits_in_packets<16>(std::span<const Ray>) const;
template std::uint64_t BareEmbree::occlusions_in_packets<8>(std::span<const Ray>) const;
template std::uint64_t BareEmbree::occlusions_in_packets<16>(std::span<const Ray>) const;

}  // namespace gibench::micro
