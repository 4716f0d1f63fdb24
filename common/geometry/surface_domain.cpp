#include "common/geometry/surface_domain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "common/core/error.h"
#include "common/core/names.h"
#include "common/geometry/camera_sight.h"
#include "common/geometry/seen_cells.h"
#include "common/geometry/surface_sampling.h"
#include "common/scene/object_names.h"

namespace gibench {

namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) names.push_back(name);
  return names;
}

void require_object(const std::string& name, const Scene& scene, const std::string& place) {
  if (has_object(scene, name)) return;
  std::vector<std::string> known{"seen", "all"};
  for (const Object& object : scene.objects) known.push_back(object.name);
  throw InputError(place, "the scene has no object " + in_quotes(name), known_names("surface domains", name, known));
}

}  // namespace

std::string to_string(const SurfaceDomain& domain) {
  switch (domain.kind) {
    case SurfaceDomain::Kind::seen: return "seen";
    case SurfaceDomain::Kind::all: return "all";
    case SurfaceDomain::Kind::objects: break;
  }
  return fmt::format("{}", fmt::join(domain.names, ","));
}

SurfaceDomain surface_domain_of(const std::string& text, const Scene& scene, const std::string& place) {
  using Kind = SurfaceDomain::Kind;
  if (text == "all" || (text.empty() && scene.cameras.empty())) return {Kind::all, {}};
  if (text == "seen" || text.empty()) {
    if (scene.cameras.empty())
      throw InputError(place, "the scene has no camera that sees anything", "give all, or a scene with a camera");
    return {Kind::seen, {}};
  }
  const SurfaceDomain domain{Kind::objects, split(text)};
  for (const std::string& name : domain.names) require_object(name, scene, place);
  return domain;
}

std::vector<SurfaceSample> domain_samples(const World& world, const SurfaceDomain& domain, std::size_t count, std::uint64_t seed,
                                          int threads) {
  SampledPart part;
  const CameraSight sight(world);
  std::optional<SeenCells> cells;
  switch (domain.kind) {
    case SurfaceDomain::Kind::seen:
      cells.emplace(world);
      part.may_keep_in = [&cells](const Vec3& low, const Vec3& high) { return cells->overlap(low, high); };
      part.piece_size = 2.0F * cells->cell_size();
      part.keeps = [&sight](const SurfaceSample& sample, RandomStream& random) {
        return sight.sees(sample) || sight.sees_reflection_to(sample, random);
      };
      break;
    case SurfaceDomain::Kind::all: break;
    case SurfaceDomain::Kind::objects:
      part.keeps_object = [&](std::uint32_t object) {
        const std::string& own = world.scene().objects[object].name;
        return std::ranges::any_of(domain.names, [&own](const std::string& name) { return stands_for(name, own); });
      };
      break;
  }
  return area_uniform_samples(world, part, count, seed, threads);
}

}  // namespace gibench
