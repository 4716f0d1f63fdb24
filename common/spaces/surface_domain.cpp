#include "common/spaces/surface_domain.h"

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
#include "common/spaces/side_light.h"

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
  std::vector<std::string> known{"seen", "all", "whole"};
  for (const Object& object : scene.objects) known.push_back(object.name);
  throw InputError(place, "the scene has no object " + in_quotes(name), known_names("surface domains", name, known));
}

/// What light or a camera reaches.
class OpenSpace {
 public:
  OpenSpace(const World& world, int threads) : task_(TaskSettings{domain_seed, threads, {}, {}}), light_(world, task_) {}

  bool holds(std::uint32_t triangle, bool front) const {
    return light_.is_reached(triangle, front) || light_.is_seen(triangle, front);
  }
  bool holds(const SurfaceSample& sample) const { return light_.is_reached(sample) || light_.is_seen(sample); }

  DomainFacts facts() const {
    double all = 0.0, sealed = 0.0;
    const SideCells& cells = light_.cells();
    for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
      const auto area = static_cast<double>(cells.area(cell));
      all += area;
      if (!light_.is_cell_reached(cell) && !light_.is_cell_seen(cell)) sealed += area;
    }
    return {all > 0.0 ? sealed / all : 0.0, light_.nothing_reached()};
  }

 private:
  static constexpr std::uint64_t domain_seed = 1;

  Task task_;
  SideLight light_;
};

}  // namespace

std::string DomainFacts::note() const {
  if (nothing_reached) return "no light reaches any side that can reflect it: all of them count as lit";
  if (!sealed_share || *sealed_share == 0.0) return {};
  return fmt::format(
      "{:.1f}% of the area that light can leave is sealed away from all light and cameras: it has no surface samples",
      100.0 * *sealed_share);
}

std::string to_string(const SurfaceDomain& domain) {
  switch (domain.kind) {
    case SurfaceDomain::Kind::seen: return "seen";
    case SurfaceDomain::Kind::all: return "all";
    case SurfaceDomain::Kind::whole: return "whole";
    case SurfaceDomain::Kind::objects: break;
  }
  return fmt::format("{}", fmt::join(domain.names, ","));
}

SurfaceDomain surface_domain_of(const std::string& text, const Scene& scene, const std::string& place) {
  using Kind = SurfaceDomain::Kind;
  if (text == "all" || (text.empty() && scene.cameras.empty())) return {Kind::all, {}};
  if (text == "whole") return {Kind::whole, {}};
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
                                          int threads, DomainFacts* facts) {
  SampledPart part;
  std::optional<OpenSpace> open;
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
    case SurfaceDomain::Kind::all:
      open.emplace(world, threads);
      part.keeps_side = [&open](std::uint32_t triangle, bool front) { return open->holds(triangle, front); };
      part.keeps = [&open](const SurfaceSample& sample, RandomStream&) { return open->holds(sample); };
      if (facts != nullptr) *facts = open->facts();
      break;
    case SurfaceDomain::Kind::whole: break;
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
