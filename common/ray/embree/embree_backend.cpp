#include "common/ray/embree/embree_backend.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

#include "common/ray/embree/embree_scene.h"

namespace gibench {

namespace {

constexpr std::size_t packet = 8;  // rays that Embree traces together on AVX2

/// Writes what Embree reads: nothing is cleared that Embree writes itself.
void load_ray(RTCRay& query, const Ray& ray) {
  query.org_x = ray.origin.x, query.org_y = ray.origin.y, query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x, query.dir_y = ray.direction.y, query.dir_z = ray.direction.z;
  query.tnear = ray.t_min, query.tfar = ray.t_max;
  query.time = 0.0F;
  query.mask = ~0U, query.id = 0, query.flags = 0;
}

void load_packet(RTCRay8& query, std::span<const Ray> rays, int (&valid)[packet]) {
  for (std::size_t i = 0; i < packet; ++i) {
    const Ray& ray = rays[std::min(i, rays.size() - 1)];
    valid[i] = i < rays.size() ? -1 : 0;
    query.org_x[i] = ray.origin.x, query.org_y[i] = ray.origin.y, query.org_z[i] = ray.origin.z;
    query.dir_x[i] = ray.direction.x, query.dir_y[i] = ray.direction.y, query.dir_z[i] = ray.direction.z;
    query.tnear[i] = ray.t_min, query.tfar[i] = ray.t_max;
    query.time[i] = 0.0F;
    query.mask[i] = ~0U, query.id[i] = 0, query.flags[i] = 0;
  }
}

/// Copies a column's values from `first` on, `count` of a packet, and repeats the last behind them.
void load_column(float (&column)[packet], std::span<const float> values, std::size_t first, std::size_t count) {
  std::copy_n(values.data() + first, count, column);
  std::fill(column + count, column + packet, column[count - 1]);
}

/// The triangles, copied into Embree's buffers.
RTCGeometry triangle_geometry(RTCDevice device, std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), vertices.size());
  std::copy(vertices.begin(), vertices.end(), static_cast<Vec3*>(corners));
  void* indices =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), triangles.size());
  std::copy(triangles.begin(), triangles.end(), static_cast<Triangle*>(indices));
  return geometry;
}

class EmbreeBackend final : public RayBackend {
 public:
  EmbreeBackend(std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads) {
    rtcSetSceneFlags(embree_.scene(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(embree_.scene(), RTC_BUILD_QUALITY_MEDIUM);
    embree_.build(triangles.empty() ? nullptr : triangle_geometry(embree_.device(), vertices, triangles), threads);
  }
  std::size_t bytes() const override { return static_cast<std::size_t>(std::max<std::int64_t>(0, embree_.bytes())); }

 private:
  void do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const override;
  void do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override;
  void do_fan_hits(const RayFan& fan, const FanHits& hits) const override;
  Hit do_closest_hit(const Ray& ray) const override;
  bool do_occluded(const Ray& ray) const override;

  EmbreeScene embree_;
};

Hit EmbreeBackend::do_closest_hit(const Ray& ray) const {
  alignas(16) RTCRayHit query;
  load_ray(query.ray, ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_.scene(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar};
}

bool EmbreeBackend::do_occluded(const Ray& ray) const {
  alignas(16) RTCRay query;
  load_ray(query, ray);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_.scene(), &context, &query);
  return query.tfar < 0.0F;
}

void EmbreeBackend::do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t first = 0; first < rays.size(); first += packet) {
    const std::size_t count = std::min(packet, rays.size() - first);
    alignas(32) RTCRayHit8 query;
    alignas(32) int valid[packet];
    load_packet(query.ray, rays.subspan(first, count), valid);
    for (unsigned& id : query.hit.geomID) id = RTC_INVALID_GEOMETRY_ID;
    for (unsigned& id : query.hit.instID[0]) id = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect8(valid, embree_.scene(), &context, &query);
    for (std::size_t i = 0; i < count; ++i) {
      const bool found = query.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      hits[first + i] = found ? Hit{query.hit.primID[i], query.hit.u[i], query.hit.v[i], query.ray.tfar[i]} : Hit{};
    }
  }
}

void EmbreeBackend::do_fan_hits(const RayFan& fan, const FanHits& hits) const {
  const std::size_t total = fan.x.size();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  alignas(32) RTCRayHit8 query;
  alignas(32) int valid[packet];
  for (std::size_t i = 0; i < packet; ++i) {
    query.ray.org_x[i] = fan.origin.x, query.ray.org_y[i] = fan.origin.y, query.ray.org_z[i] = fan.origin.z;
    query.ray.tnear[i] = query.ray.time[i] = 0.0F;
    query.ray.mask[i] = ~0U, query.ray.id[i] = 0, query.ray.flags[i] = 0;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  for (std::size_t first = 0; first < total; first += packet) {
    const std::size_t count = std::min(packet, total - first);
    load_column(query.ray.dir_x, fan.x, first, count);
    load_column(query.ray.dir_y, fan.y, first, count);
    load_column(query.ray.dir_z, fan.z, first, count);
    for (std::size_t i = 0; i < packet; ++i) {
      valid[i] = i < count ? -1 : 0;
      query.ray.tfar[i] = std::numeric_limits<float>::infinity();
      query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      query.hit.primID[i] = Hit::none;  // left where nothing is met: the scene is one geometry
    }
    rtcIntersect8(valid, embree_.scene(), &context, &query);
    std::copy_n(query.hit.primID, count, hits.triangle.data() + first);
    std::copy_n(query.hit.u, count, hits.u.data() + first);
    std::copy_n(query.hit.v, count, hits.v.data() + first);
  }
}

void EmbreeBackend::do_occlusions(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t first = 0; first < rays.size(); first += packet) {
    const std::size_t count = std::min(packet, rays.size() - first);
    alignas(32) RTCRay8 query;
    alignas(32) int valid[packet];
    load_packet(query, rays.subspan(first, count), valid);
    rtcOccluded8(valid, embree_.scene(), &context, &query);
    for (std::size_t i = 0; i < count; ++i) occluded[first + i] = query.tfar[i] < 0.0F ? 1 : 0;
  }
}

}  // namespace

std::unique_ptr<const RayBackend> make_embree_backend(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                                      int threads) {
  return std::make_unique<EmbreeBackend>(vertices, triangles, threads);
}

}  // namespace gibench
