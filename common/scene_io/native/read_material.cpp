#include "common/scene_io/native/read_material.h"

#include <fmt/format.h>
#include <array>

#include <nlohmann/json.hpp>
#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/scene_io/native/read_values.h"

namespace gibench {

namespace {

using nlohmann::json;

// Sums like 0.3 + 0.7 in single precision.
constexpr float rounding_of_sums = 1e-6F;

struct Kind {
  const char* name;
  Bsdf bsdf;
  std::vector<std::string> keys;
};

const std::array<Kind, 4>& kinds() {
  static const std::array<Kind, 4> all{{{"diffuse", Bsdf::diffuse, {"albedo", "emission"}},
                                        {"phong", Bsdf::phong, {"diffuse", "specular", "exponent", "emission"}},
                                        {"ggx", Bsdf::ggx, {"roughness", "f0", "diffuse", "emission"}},
                                        {"mirror", Bsdf::mirror, {"reflectance", "emission"}}}};
  return all;
}

const Kind& kind_of(Bsdf bsdf) {
  for (const Kind& kind : kinds())
    if (kind.bsdf == bsdf) return kind;
  GIBENCH_CHECK(false, "every Bsdf is a kind of material");
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
  const bool is_ggx = material.bsdf == Bsdf::ggx;
  const float sum = largest(material.diffuse + (is_ggx ? material.f0 : material.specular));
  if (sum > 1.0F + rounding_of_sums)
    throw InputError(place.text(),
                     fmt::format("{} = {:.6g} is above 1: the surface would create energy",
                                 is_ggx ? "diffuse + f0" : "diffuse + specular", sum),
                     "lower one of them until no channel's sum is above 1");
}

void set_bsdf(const json& from, Material& material) {
  const auto name = from.find("bsdf");
  if (name == from.end()) return;
  for (const Kind& kind : kinds())
    if (*name == kind.name) material.bsdf = kind.bsdf;
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
  const Kind& kind = kind_of(after.bsdf);
  for (const auto& [key, value] : edit.items())
    if (key != "material" && key != "bsdf" && std::find(kind.keys.begin(), kind.keys.end(), key) == kind.keys.end())
      throw InputError(place[key].text(), "a " + std::string(kind.name) + " material has no " + in_quotes(key),
                       known_names("its keys", key, kind.keys));
  set_keys(edit, after, place);
  check_energy(after, place);
  return after;
}

}  // namespace gibench
