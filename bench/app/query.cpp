#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/cancellation.h"
#include "bench/measure/run_method.h"
#include "bench/record/query_file.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/geometry/surface_lookup.h"

namespace gibench {

namespace {

struct QueryOptions {
  SceneOptions scene;
  MethodOptions method;
  std::filesystem::path points, out;
  std::optional<int> bounces;
  PlanOptions plan;
};

constexpr float reach = 1e-4F;  // of the scene's diagonal: how far a point may lie from its surface

/// Queries that one call of shade() answers, as indices into the list.
using Group = std::vector<std::size_t>;

std::vector<SurfaceSample> surface_points(const World& world, const std::vector<Query>& queries) {
  std::vector<SurfaceSample> samples;
  for (const Query& query : queries) {
    const Vec3 point(query.point - world.scene().origin);
    const auto sample = find_surface_point(world, point, Vec3(query.normal), reach * world.diagonal());
    if (!sample)
      throw InputError(query.place,
                       fmt::format("no surface with this normal lies within {:.3g} m of the point", reach * world.diagonal()),
                       "give a point on a surface and the normal of the side asked about");
    samples.push_back(*sample);
  }
  return samples;
}

void check_quantities(const MethodSession& method, const std::vector<Query>& queries, const std::string& name) {
  for (const Query& query : queries)
    if (!method.answers(query.quantity))
      throw InputError(query.place, fmt::format("{} does not answer {}", name, to_string(query.quantity)), "ask another method");
}

/// Answers of one method, lit once, to one group of queries of the same quantity.
void answer_group(const LitMethod& lit, const std::string& name, const std::vector<Query>& queries,
                  const std::vector<SurfaceSample>& samples, const Group& group, Task& task, std::vector<QueryAnswer>& answers) {
  const Quantity quantity = queries[group.front()].quantity;
  std::vector<SurfaceSample> asked;
  std::vector<Vec3> toward_viewer;
  for (const std::size_t i : group) {
    asked.push_back(samples[i]);
    if (quantity == Quantity::radiance) toward_viewer.push_back(queries[i].direction);
  }
  const bool variance = lit.method->knows_variance(quantity);
  std::vector<Rgb> direct(group.size()), indirect(group.size());
  std::vector<Rgb> direct_variance(variance ? group.size() : 0), indirect_variance = direct_variance,
                                                                 total_variance = direct_variance;
  const StageReport report = lit.method->shade({quantity, asked, toward_viewer},
                                               {direct, indirect, direct_variance, indirect_variance, total_variance}, task);
  require_success(report, name, "shade");
  const auto root = [](const Rgb& v) { return Rgb(std::sqrt(v.r), std::sqrt(v.g), std::sqrt(v.b)); };
  for (std::size_t i = 0; i < group.size(); ++i) {
    QueryAnswer& answer = answers[group[i]];
    const bool whole = quantity == Quantity::accessibility;  // written to `direct`, whatever the component
    const Component component = whole ? Component::direct : queries[group[i]].component;
    answer.value = component == Component::direct     ? direct[i]
                   : component == Component::indirect ? indirect[i]
                                                      : direct[i] + indirect[i];
    if (!variance) continue;
    const auto& of = component == Component::direct     ? direct_variance
                     : component == Component::indirect ? indirect_variance
                                                        : total_variance;
    answer.standard_error = root(of[i]);
  }
}

ExitStatus query(const QueryOptions& options, const CommonOptions& common) {
  const MethodChoice choice = choose_method(options.method);
  limits_of(options.plan, options.bounces);
  std::vector<Query> queries = parse_queries(read_file(options.points), options.points.string());
  const LoadedScene scene = load_world(options.scene, common.threads);
  const std::vector<SurfaceSample> samples = surface_points(*scene.world, queries);
  check_quantities(*make_session(*choice.entry, choice.parameters), queries, choice.entry->name);
  RunLog log({}, common.quiet);
  std::map<std::optional<int>, std::map<Quantity, Group>> groups;
  for (std::size_t i = 0; i < queries.size(); ++i)
    groups[queries[i].bounces ? queries[i].bounces : options.bounces][queries[i].quantity].push_back(i);
  std::vector<QueryAnswer> answers(queries.size());
  for (const auto& [bounces, by_quantity] : groups) {
    Task task = make_task(common, fmt::format("{}, {}", scene.scene().name, choice.entry->name));
    const LitMethod lit = prepare_and_light(*scene.world, choice, options.plan, bounces, task, log);
    for (const auto& [quantity, group] : by_quantity)
      answer_group(lit, choice.entry->name, queries, samples, group, task, answers);
  }
  stop_if_cancelled();
  const nlohmann::ordered_json json = answers_json(queries, answers);
  if (!options.out.empty()) write_file_atomically(options.out, json.dump(2) + "\n");
  if (common.json || options.out.empty()) print_json(json);
  return ExitStatus::done;
}

}  // namespace

void add_query(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "query", "Computes the light at given points of a scene by one method");
  verb->group(verb_group::computing);
  set_pages(*verb, {"docs/queries.md"});
  const auto options = std::make_shared<QueryOptions>();
  add_scene_options(*verb, options->scene);
  add_method_options(*verb, options->method);
  verb->add_option("--points", options->points, "JSON file of queries")->type_name(value_kind::file)->required();
  verb->add_option("--out", options->out, "JSON file for the answers; without it they go to stdout")->type_name(value_kind::file);
  add_bounces_option(*verb, options->bounces);
  add_plan_options(*verb, options->plan);
  add_light_paths_option(*verb, options->plan.light_paths);
  verb->callback([&call, options] { call.action = [&call, options] { return query(*options, call.common); }; });
}

}  // namespace gibench
