#include "common/scene_io/native/read_material.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene/material_kinds.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

// Sums like 0.3 + 0.7 in single precision.
constexpr float rounding_of_sums = 1e-6F;

std::vector<std::string> keys_of(Bsdf bsdf) {
  switch (bsdf) {
    case Bsdf::diffuse: return {"albedo", "emission"};
    case Bsdf::phong: return {"diffuse", "specular", "exponent", "emission"};
    case Bsdf::ggx: return {"roughness", "f0", "diffuse", "emission"};
    case Bsdf::mirror: return {"reflectance", "emission"};
  }
  return {};
}

/// The keys whose sum is what the surface reflects straight on.
const char* reflected_parts(Bsdf bsdf) {
  switch (bsdf) {
    case Bsdf::diffuse: return "albedo";
    case Bsdf::phong: return "diffuse + specular";
    case Bsdf::ggx: return "diffuse + f0";
    case Bsdf::mirror: return "reflectance";
  }
  return "";
}

void set_keys(const json& from, Material& material, const JsonPlace& place) {
  const auto set_rgb = [&](const char* key, Rgb& value) {
    if (const auto found = from.find(key); found != from.end()) value = read_rgb(*found, place[key]);
  };
  set_rgb("albedo", material.diffuse);
  set_rgb("diffuse", material.diffuse);
  set_rgb("specular", material.specular);
  set_rgb("f0", material.f0);
  set_rgb("reflectance", material.reflectance);
  set_rgb("emission", material.emission);
  if (from.contains("exponent")) material.exponent = read_rgb(from["exponent"], place["exponent"]).r;
  material.roughness = from.value("roughness", material.roughness);
}

/// A surface must not reflect more than it gets.
void check_energy(const Material& material, const JsonPlace& place) {
  const float sum = largest(straight_reflectance(material));
  if (sum > 1.0F + rounding_of_sums)
    throw InputError(place.text(),
                     fmt::format("{} = {:.6g} is above 1: the surface would create energy", reflected_parts(material.bsdf), sum),
                     "lower one of them until no channel's sum is above 1");
}

void set_bsdf(const json& from, Material& material) {
  const auto name = from.find("bsdf");
  if (name == from.end()) return;
  for (const Bsdf bsdf : all_bsdfs)
    if (*name == to_string(bsdf)) material.bsdf = bsdf;
}

}  // namespace

Material read_material(const json& value, const std::string& name, const JsonPlace& place) {
  Material material;
  material.name = name;
  set_bsdf(value, material);
  set_keys(value, material, place);
  check_energy(material, place);
  return material;
}

Material edited_material(const json& edit, const Material& before, const JsonPlace& place) {
  Material after = before;
  set_bsdf(edit, after);
  if (after.bsdf != before.bsdf) {
    after = Material{};
    after.name = before.name;
    after.emission = before.emission;
    set_bsdf(edit, after);
  }
  const std::vector<std::string> keys = keys_of(after.bsdf);
  for (const auto& [key, value] : edit.items())
    if (key != "material" && key != "bsdf" && std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(place[key].text(), "a " + std::string(to_string(after.bsdf)) + " material has no " + in_quotes(key),
                       known_names("its keys", key, keys));
  set_keys(edit, after, place);
  check_energy(after, place);
  return after;
}

}  // namespace gibench
