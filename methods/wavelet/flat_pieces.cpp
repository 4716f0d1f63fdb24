#include "methods/wavelet/flat_pieces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "common/geometry/convex_quad.h"

namespace gibench::wavelet {

namespace {

constexpr float touching = 1e-4F;     // of the scene's diagonal: what is as near as that touches
constexpr float least_width = 2e-3F;  // of the diagonal: no cut leaves less on either side
constexpr float elongation = 1.5F;    // from which on a quad is cut across

using Polygon = std::vector<Vec3>;

struct Flat {
  Polygon corners;
  Vec3 normal;
  std::uint32_t triangle;
};

std::vector<Flat> faces_of(const World& world, FlatPieces& counts) {
  const Scene& scene = world.scene();
  std::vector<Flat> faces;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const Face& face = scene.faces[scene.triangle_face[t]];
    const bool begins_quad =
        face.is_quad() && t + 1 < scene.triangles.size() && scene.triangle_face[t + 1] == scene.triangle_face[t];
    const auto vertex = [&](std::uint32_t corner) { return scene.vertices[corner]; };
    if (begins_quad && world.area(t) > 0.0F && world.area(t + 1) > 0.0F) {
      const std::array<Vec3, 4> corners{vertex(face.corners[0]), vertex(face.corners[1]), vertex(face.corners[2]),
                                        vertex(face.corners[3])};
      if (is_planar_and_convex(corners)) {
        faces.push_back({{corners.begin(), corners.end()}, world.normal(t), t});
        ++t;
        continue;
      }
    }
    if (begins_quad) ++counts.quads_by_triangle;
    if (!(world.area(t) > 0.0F)) {
      ++counts.faces_without_area;
      continue;
    }
    const auto& [a, b, c] = scene.triangles[t].corners;
    faces.push_back({{vertex(a), vertex(b), vertex(c)}, world.normal(t), t});
  }
  return faces;
}

/// A line in the plane of a polygon, with the direction that `side` is measured in.
struct Line {
  Vec3 point, across;  ///< `across`: unit, in the polygon's plane
  float side(const Vec3& at) const { return glm::dot(at - point, across); }
};

struct Segment {
  Vec3 from, to;
};

/// Where a polygon meets a plane, if it is not in it.
std::optional<Segment> section(const Polygon& polygon, const Vec3& point, const Vec3& normal, float tolerance) {
  std::vector<Vec3> met;
  std::size_t on_plane = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const float height_a = glm::dot(a - point, normal), height_b = glm::dot(b - point, normal);
    if (std::fabs(height_a) <= tolerance) met.push_back(a), ++on_plane;
    else if (std::fabs(height_b) > tolerance && (height_a < 0.0F) != (height_b < 0.0F))
      met.push_back(a + (b - a) * (height_a / (height_a - height_b)));
  }
  if (on_plane > 2 || met.size() < 2) return std::nullopt;
  return Segment{met[0], met[1]};
}

/// The part of a segment inside a convex polygon that is drawn in by `margin`.
std::optional<Segment> inside(Segment segment, const Polygon& polygon, const Vec3& normal, float margin) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Vec3 inward = glm::cross(normal, b - a);
    const float length = glm::length(inward);
    if (!(length > 0.0F)) continue;
    const float from = glm::dot(segment.from - a, inward) / length - margin,
                to = glm::dot(segment.to - a, inward) / length - margin;
    if (from <= 0.0F && to <= 0.0F) return std::nullopt;
    const Vec3 crossing = segment.from + (segment.to - segment.from) * (from / (from - to));
    if (from < 0.0F) segment.from = crossing;
    if (to < 0.0F) segment.to = crossing;
  }
  return segment;
}

Polygon half(const Polygon& polygon, const Line& line, float sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const float side_a = sign * line.side(a), side_b = sign * line.side(b);
    if (side_a >= 0.0F) kept.push_back(a);
    if ((side_a < 0.0F) != (side_b < 0.0F) && side_a != 0.0F && side_b != 0.0F)
      kept.push_back(a + (b - a) * (side_a / (side_a - side_b)));
  }
  return kept;
}

class Cutter {
 public:
  Cutter(const std::vector<Flat>& faces, float diagonal) : faces_(faces), diagonal_(diagonal) {}

  /// The parts of one face.
  std::vector<Polygon> cut(const Flat& face) const {
    std::vector<Polygon> parts{face.corners};
    for (const Flat& other : faces_) {
      if (&other == &face) continue;
      const auto met = section(other.corners, face.corners.front(), face.normal, touching * diagonal_);
      if (!met) continue;
      const Vec3 along = met->to - met->from;
      const float length = glm::length(along);
      if (length <= least_width * diagonal_) continue;
      const Line line{met->from, glm::normalize(glm::cross(face.normal, along))};
      std::vector<Polygon> next;
      for (Polygon& part : parts) cut_part(part, face.normal, *met, line, next);
      parts = std::move(next);
    }
    return parts;
  }

 private:
  void cut_part(Polygon& part, const Vec3& normal, const Segment& met, const Line& line, std::vector<Polygon>& out) const {
    float low = 0.0F, high = 0.0F;
    for (const Vec3& corner : part) low = std::min(low, line.side(corner)), high = std::max(high, line.side(corner));
    const float least = least_width * diagonal_;
    const auto within = inside(met, part, normal, touching * diagonal_);
    if (low > -least || high < least || !within || glm::length(within->to - within->from) < least) {
      out.push_back(std::move(part));
      return;
    }
    out.push_back(half(part, line, 1.0F));
    out.push_back(half(part, line, -1.0F));
  }

  const std::vector<Flat>& faces_;
  float diagonal_;
};

/// A quad in as many parts as make them nearly square.
void add_quad(const Patch& quad, const Flat& face, std::vector<FlatPiece>& out) {
  const auto& [a, b, c, d] = quad.corners;
  const float first = 0.5F * (glm::length(b - a) + glm::length(c - d)), second = 0.5F * (glm::length(c - b) + glm::length(d - a));
  const bool lies = first >= second;
  const float ratio = std::max(first, second) / std::max(1e-30F, std::min(first, second));
  const int count = ratio < elongation ? 1 : static_cast<int>(std::min(64.0F, std::round(ratio)));
  for (int i = 0; i < count; ++i) {
    const float from = static_cast<float>(i) / static_cast<float>(count),
                to = static_cast<float>(i + 1) / static_cast<float>(count);
    const Patch part = lies ? Patch{{quad.at({from, 0.0F}), quad.at({to, 0.0F}), quad.at({to, 1.0F}), quad.at({from, 1.0F})}}
                            : Patch{{quad.at({0.0F, from}), quad.at({1.0F, from}), quad.at({1.0F, to}), quad.at({0.0F, to})}};
    out.push_back({part, face.normal, face.triangle});
  }
}

/// A convex polygon as a fan of quads, and a triangle where one corner is left over.
void add_polygon(const Polygon& polygon, const Flat& face, std::vector<FlatPiece>& out) {
  for (std::size_t i = 1; i + 1 < polygon.size(); i += 2) {
    const bool quad = i + 2 < polygon.size();
    const Patch patch{{polygon[0], polygon[i], polygon[i + 1], polygon[quad ? i + 2 : i + 1]}};
    if (!(patch.area() > 0.0F)) continue;
    if (quad) add_quad(patch, face, out);
    else out.push_back({patch, face.normal, face.triangle});
  }
}

}  // namespace

FlatPieces flat_pieces(const World& world, bool cuts) {
  FlatPieces result;
  const std::vector<Flat> faces = faces_of(world, result);
  const Cutter cutter(faces, world.diagonal());
  for (const Flat& face : faces) {
    if (!cuts || faces.size() > most_cut_faces) {
      add_polygon(face.corners, face, result.pieces);
      continue;
    }
    for (const Polygon& part : cutter.cut(face)) add_polygon(part, face, result.pieces);
  }
  return result;
}

}  // namespace gibench::wavelet
