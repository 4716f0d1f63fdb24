#include "bench/micro/many_triangles.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/scene/made_scenes.h"

namespace gibench::micro {

namespace {

constexpr std::uint32_t rings = 81, segments = 160;  // 2 · 160 · 80 triangles a sphere

/// A point of a unit sphere whose radius swells and shrinks by a tenth.
Vec3 bumpy_point(std::uint32_t ring, std::uint32_t segment, float phase) {
  const float polar = pi * static_cast<float>(ring) / static_cast<float>(rings);
  const float azimuth = 2.0F * pi * static_cast<float>(segment) / static_cast<float>(segments);
  const float bump = std::sin(9.0F * polar + phase) * std::sin(polar) * std::cos(11.0F * azimuth);
  const Vec3 direction(std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth));
  return (1.0F + 0.1F * bump) * direction;
}

/// Two poles and rings of quads between fans of triangles.
void add_sphere(made::SceneBuilder& builder, std::uint32_t material, const Vec3& centre, float radius, std::uint32_t number) {
  const auto phase = static_cast<float>(number);
  const auto at = [](std::uint32_t ring, std::uint32_t segment) { return 1 + (ring - 1) * segments + segment % segments; };
  std::vector<Vec3> vertices{centre + radius * bumpy_point(0, 0, phase)};
  for (std::uint32_t ring = 1; ring < rings; ++ring)
    for (std::uint32_t segment = 0; segment < segments; ++segment)
      vertices.push_back(centre + radius * bumpy_point(ring, segment, phase));
  vertices.push_back(centre + radius * bumpy_point(rings, 0, phase));
  const std::uint32_t top = 0, bottom = static_cast<std::uint32_t>(vertices.size() - 1);
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::uint32_t s = 0; s < segments; ++s) {
    faces.push_back({top, at(1, s + 1), at(1, s), at(1, s)});
    for (std::uint32_t ring = 1; ring + 1 < rings; ++ring)
      faces.push_back({at(ring, s), at(ring, s + 1), at(ring + 1, s + 1), at(ring + 1, s)});
    faces.push_back({bottom, at(rings - 1, s), at(rings - 1, s + 1), at(rings - 1, s + 1)});
  }
  builder.object("sphere " + std::to_string(number), material, vertices, faces);
}

}  // namespace

Scene bumpy_spheres() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  const std::uint32_t lamp = builder.diffuse("lamp", Rgb(0.0F), Rgb(10.0F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.quad("lamp", lamp,
               {{{0.375F, 0.99F, 0.375F}, {0.625F, 0.99F, 0.375F}, {0.625F, 0.99F, 0.625F}, {0.375F, 0.99F, 0.625F}}});
  for (std::uint32_t i = 0; i < 12; ++i) {
    const Vec3 cell(static_cast<float>(i % 3), static_cast<float>(i / 6), static_cast<float>(i / 3 % 2));
    add_sphere(builder, white, Vec3(0.2F, 0.25F, 0.25F) + cell * Vec3(0.3F, 0.45F, 0.5F), 0.13F, i);
  }
  return builder.build("bumpy spheres");
}

}  // namespace gibench::micro
