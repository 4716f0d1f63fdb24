/// Small scenes made in memory: rooms that face inwards, blocks, lamps, punctual lights.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/scene/scene.h"

namespace gibench::made {

/// Collects parts and gives a tessellated scene. Lengths in metres; corners counter-clockwise from the front.
class SceneBuilder {
 public:
  /// The index of the new material.
  std::uint32_t material(Material material);
  std::uint32_t diffuse(const std::string& name, const Rgb& albedo, const Rgb& emission = Rgb());

  /// One object of any faces, given by indices into `vertices`; a triangle repeats its third corner.
  SceneBuilder& object(const std::string& name, std::uint32_t material, const std::vector<Vec3>& vertices,
                       const std::vector<std::array<std::uint32_t, 4>>& faces, bool two_sided = false);
  SceneBuilder& quad(const std::string& name, std::uint32_t material, const std::array<Vec3, 4>& corners, bool two_sided = false);
  /// Six quads from `low` to `high` whose fronts face inwards.
  SceneBuilder& room(const std::string& name, std::uint32_t material, const Vec3& low, const Vec3& high);
  /// Six quads whose fronts face outwards, turned about the vertical axis through the block's centre.
  SceneBuilder& block(const std::string& name, std::uint32_t material, const Vec3& low, const Vec3& high,
                      float turn_degrees = 0.0F);
  SceneBuilder& light(const Light& light);
  SceneBuilder& camera(const Camera& camera);

  Scene build(const std::string& name) const;

 private:
  Scene scene_;
};

/// What one may change about the box: a unit room like the Cornell box.
struct BoxOptions {
  Rgb floor_albedo{0.7F}, left_albedo{0.6F, 0.1F, 0.1F}, right_albedo{0.1F, 0.5F, 0.1F};
  Rgb lamp_emission{10.0F};  ///< W/(m² sr), of a square of a quarter metre just under the ceiling; black: no lamp
  bool blocks = true;        ///< a tall and a short one, white as the floor
  std::vector<Light> lights;
};

/// The room [0,1]³ with a white floor, ceiling, back and front wall, coloured side walls and a camera.
Scene box_scene(const BoxOptions& options = {});

/// The same scene in other units and elsewhere: every position p becomes rotation·(scale p) + translation.
/// Intensities of point and spot lights grow with scale², so that every irradiance and radiance stays as it was.
Scene transformed(Scene scene, float scale, const Vec3& rotation_axis = {0.0F, 1.0F, 0.0F}, float degrees = 0.0F,
                  const Vec3& translation = Vec3(0.0F));

/// `count` triangles of about `size` metres strewn over a cube of edge `extent`, of one white material.
Scene random_triangles(std::size_t count, float extent, float size, std::uint64_t seed);

}  // namespace gibench::made
