/// Scene files as JSON for tests, and the error that loading one gives.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "common/core/error.h"
#include "common/scene_io/load.h"
#include "common/scene_io/native/scene_file.h"

namespace gibench::test {

/// One white quad in the plane z = 0 with its front up, and nothing else.
inline nlohmann::json quad_scene() {
  return nlohmann::json::parse(R"({
    "gibench_scene": 1, "name": "quad",
    "materials": {"white": {"bsdf": "diffuse", "albedo": 0.5}},
    "objects": [{"name": "floor", "material": "white",
                 "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "faces": [[0, 1, 2, 3]]}]})");
}

/// Every kind of material, light and edit, and every optional key but those of files.
inline nlohmann::json full_scene() {
  nlohmann::json scene = quad_scene();
  scene.update(nlohmann::json::parse(R"({
    "$schema": "scene.schema.json", "description": "a test", "source": "made up",
    "materials": {
      "white": {"bsdf": "diffuse", "albedo": 0.5},
      "lamp": {"bsdf": "diffuse", "albedo": [0, 0.1, 0.2], "emission": [18.4, 15.6, 8.0]},
      "satin": {"bsdf": "phong", "diffuse": [0.3, 0.3, 0.3], "specular": 0.4, "exponent": 20, "emission": 0},
      "metal": {"bsdf": "ggx", "roughness": 0.3, "f0": [0.9, 0.6, 0.3], "diffuse": 0.05, "emission": 0},
      "glass": {"bsdf": "mirror", "reflectance": [1, 0.9, 0.8], "emission": 0}},
    "lights": [
      {"type": "point", "position": [0.5, 0.9, 0.5], "intensity": [1, 2, 3]},
      {"type": "spot", "position": [0.5, 0.9, 0.5], "direction": [0, -2, 0], "intensity": 5, "inner_degrees": 20, "outer_degrees": 30},
      {"type": "directional", "direction": [0, -1, 0], "irradiance": [1, 1, 1]},
      {"type": "environment", "radiance": [1, 2, 1]}],
    "cameras": [
      {"name": "front", "position": [0.5, 0.5, 2], "look_at": [0.5, 0.5, 0], "up": [0, 1, 0], "vertical_fov_degrees": 40, "resolution": [64, 32]},
      {"position": [0.5, 0.5, 3], "look_at": [0.5, 0.5, 0]}],
    "edits": [
      {"move": "floor", "translate": [0.1, 0, 0], "rotate_degrees": [0, 10, 0]},
      {"material": "white", "albedo": [0.2, 0.2, 0.7]},
      {"material": "satin", "bsdf": "phong", "diffuse": 0.1, "specular": 0.1, "exponent": 3, "emission": 1},
      {"material": "metal", "roughness": 0.1, "f0": 0.5},
      {"material": "glass", "reflectance": 0.5},
      {"light": 0, "position": [0.2, 0.9, 0.5], "intensity": 2},
      {"light": 1, "direction": [1, 0, 0], "inner_degrees": 5, "outer_degrees": 6},
      {"light": 2, "irradiance": 2},
      {"light": 3, "radiance": 2}],
    "exposure": {"value": 1.5, "start": -3, "stop": 2}})"));
  scene["objects"][0].update(nlohmann::json::parse(
      R"({"scale": [1, 2, 1], "rotate_degrees": [0, 0, 90], "translate": [1, 2, 3], "two_sided": true, "group": "ground"})"));
  return scene;
}

inline Scene load(const nlohmann::json& scene, const std::filesystem::path& folder = ".") {
  return parse_scene(scene.dump(), "box.scene.json", folder);
}

/// Square metres of all triangles, one side.
inline double area_of(const Scene& scene) {
  double area = 0.0;
  for (const Triangle& t : scene.triangles) {
    const Vec3 a = scene.vertices[t.corners[0]], b = scene.vertices[t.corners[1]], c = scene.vertices[t.corners[2]];
    area += 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
  }
  return area;
}

/// The message of the InputError that `call` throws; a failure where it throws none.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace gibench::test
