#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/cancellation.h"
#include "bench/measure/memory_needs.h"
#include "bench/measure/picture_library.h"
#include "bench/measure/plan_options.h"
#include "bench/measure/reference_files.h"
#include "bench/measure/reference_making.h"
#include "bench/measure/reference_search.h"
#include "bench/record/file_lock.h"
#include "bench/record/output_folder.h"
#include "bench/record/reference_facts.h"
#include "bench/study/shard.h"
#include "common/core/available_memory.h"
#include "common/core/error.h"
#include "common/reference/damaged_reference.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t default_samples = 64;        // paths per value and replicate, without a target
constexpr std::uint64_t most_samples = 1ULL << 20U;  // with a target and no bound of the user's

struct ReferenceOptions {
  SceneOptions scene;
  MeasuringOptions measuring;
  std::optional<std::uint64_t> samples_per_replica, image_samples_per_replica;
  std::optional<double> target_error;
  int replicas = 8;
  std::string shard = "0/1";
  fs::path store = "references", out, packed;
  bool force = false, remake_damaged = false;
};

ReferenceGoal goal_of(const ReferenceOptions& options) {
  return {options.samples_per_replica.value_or(options.target_error ? most_samples : default_samples),
          options.image_samples_per_replica, options.target_error};
}

Reference not_begun(const ReferenceQuestion& question) {
  Reference reference;
  reference.question = question;
  return reference;
}

void check_replicas(const Reference& reference, int replicas, const fs::path& folder) {
  const auto stored = static_cast<int>(reference.surface.direct.count());
  if (stored != replicas)
    throw InputError("--replicas", fmt::format("the stored reference has {} replicates, not {}", stored, replicas),
                     fmt::format("ask for {}, or remove {}", stored, folder.string()));
}

FileLock lock_of(const ReferenceStore& store, const Scene& scene, const ReferenceQuestion& question) {
  const fs::path folder = store.folder_of(scene, question);
  return FileLock(folder.string() + ".lock", folder, FileLock::WhenTaken::wait, stop_if_cancelled);
}

/// What came with the program, if it has the replicates that are wanted; a damaged one counts as none.
std::optional<Reference> find_shipped(const ReferenceOptions& options, const LoadedScene& scene,
                                      const ReferenceQuestion& question, const CommonOptions& common) {
  const ReferenceSearch search(options.store, ReferenceSearch::Stores::own_then_shipped, scene, common.threads,
                               [&](const std::string& warning) {
                                 if (!common.quiet) fmt::print(stderr, "gibench: warning: {}\n", warning);
                               });
  auto shipped = search.find_shipped(question);
  const bool fits = shipped && shipped->surface.direct.count() == static_cast<std::size_t>(options.replicas);
  return fits ? std::move(shipped) : std::nullopt;
}

/// The stored one; with --remake-damaged none where it is damaged, and `damage` then says how.
std::optional<Reference> find(const ReferenceOptions& options, const ReferenceStore& store, const Scene& scene,
                              const ReferenceQuestion& question, std::string& damage) {
  try {
    return store.find(scene, question);
  } catch (const DamagedReference& damaged) {
    if (!options.remake_damaged) throw;
    damage = damaged.what();
    return std::nullopt;
  }
}

/// Makes or extends the whole reference in the store.
Reference make_whole(const ReferenceOptions& options, const LoadedScene& scene, const ReferenceQuestion& question,
                     const CommonOptions& common, std::string& damage) {
  const ReferenceStore store(options.store);
  const FileLock lock = lock_of(store, scene.scene(), question);
  std::optional<Reference> stored = find(options, store, scene.scene(), question, damage);
  if (stored) check_replicas(*stored, options.replicas, store.folder_of(scene.scene(), question));
  else stored = find_shipped(options, scene, question, common);
  Reference reference = stored ? std::move(*stored) : not_begun(question);
  try {
    extend_reference(scene, options.measuring, {options.replicas, 0, 1}, goal_of(options), common, reference,
                     [&](const Reference& state) { store.save(scene.scene(), state); });
  } catch (const WorkError&) {
    if (!cancellation()->load() || reference.samples_per_replica == 0) throw;
    throw WorkError(
        fmt::format("cancelled; the {} paths per value and replicate made so far are kept in {}; the same command does the rest",
                    reference.samples_per_replica, store.folder_of(scene.scene(), question).string()));
  }
  return reference;
}

fs::path shard_store(const fs::path& store, int shard, int of) { return store / "shards" / fmt::format("{}-of-{}", shard, of); }

/// The whole, where every shard has its replicates of the same samples; then the parts are removed.
std::optional<Reference> merge_if_complete(const ReferenceOptions& options, const Scene& scene, const ReferenceQuestion& question,
                                           std::uint64_t samples, int of) {
  std::string damage;  // of a part: it is not there yet
  const ReferenceStore whole_store(options.store);
  const FileLock lock = lock_of(whole_store, scene, question);
  std::vector<Reference> parts;
  for (int i = 0; i < of; ++i) {
    auto part = find(options, ReferenceStore(shard_store(options.store, i, of)), scene, question, damage);
    if (!part || part->samples_per_replica != samples) return std::nullopt;
    parts.push_back(std::move(*part));
  }
  Reference whole = merge_shards(parts);
  whole_store.save(scene, whole);
  for (int i = 0; i < of; ++i) {
    std::error_code ignored;
    fs::remove_all(ReferenceStore(shard_store(options.store, i, of)).folder_of(scene, question), ignored);
  }
  return whole;
}

/// Makes one shard; gives the whole if this was the last.
std::optional<Reference> make_shard(const ReferenceOptions& options, const LoadedScene& scene, const ReferenceQuestion& question,
                                    const Shard& shard, const CommonOptions& common, std::string& damage) {
  if (options.target_error)
    throw InputError("--target-error", "shards cannot see one another's errors", "give --samples with --shard");
  if (shard.of > options.replicas)
    throw InputError("--shard", fmt::format("{} shards for {} replicates", shard.of, options.replicas), "ask for fewer shards");
  const std::uint64_t samples = whole_samples(goal_of(options).samples_per_replica, question);
  const auto whole = find(options, ReferenceStore(options.store), scene.scene(), question, damage);
  if (whole) check_replicas(*whole, options.replicas, ReferenceStore(options.store).folder_of(scene.scene(), question));
  if (whole && whole->samples_per_replica >= samples) return whole;
  const ReferenceStore store(shard_store(options.store, shard.index, shard.of));
  {
    const FileLock lock = lock_of(store, scene.scene(), question);
    auto part = find(options, store, scene.scene(), question, damage);
    if (!part && whole) part = shard_of(*whole, shard.index, shard.of);
    Reference reference = part.value_or(not_begun(question));
    extend_reference(scene, options.measuring, {options.replicas, shard.index, shard.of}, goal_of(options), common, reference,
                     [&](const Reference& state) { store.save(scene.scene(), state); });
  }
  return merge_if_complete(options, scene.scene(), question, samples, shard.of);
}

/// Of surface samples and pixels apart where these have paths of their own number.
std::string error_text(const ReferenceFacts& facts) {
  if (!facts.image_samples_per_replica) return fmt::format("{:.4f}", facts.relative_standard_error());
  return fmt::format("{:.4f} at the surface samples, {:.4f} of the pixels with {} paths", facts.surface_error.value_or(0.0),
                     facts.image_error.value_or(0.0), *facts.image_samples_per_replica);
}

void tell(const ReferenceOptions& options, const LoadedScene& scene, const Reference& reference, const std::string& damage,
          const CommonOptions& common) {
  const ReferenceFacts facts = facts_of(scene.scene(), reference);
  if (!damage.empty() && !common.quiet) fmt::print(stderr, "gibench: warning: made anew: {}\n", damage);
  if (common.json) {
    nlohmann::ordered_json json = to_json(facts);
    if (!damage.empty()) json[remade_key] = damage;
    print_json(json);
    return;
  }
  if (!common.quiet)
    fmt::print("reference of {}: {} paths per value in each of {} replicates; relative standard error {}; {}\n",
               scene.scene().name, facts.samples_per_replica, facts.replicas, error_text(facts),
               ReferenceStore(options.store).folder_of(scene.scene(), reference.question).string());
  if (options.target_error && aimed_error(goal_of(options), facts) > *options.target_error && !common.quiet)
    fmt::print(stderr, "gibench: warning: the target error {} was not reached within {} paths per replicate\n",
               *options.target_error, facts.samples_per_replica);
}

ExitStatus reference(const ReferenceOptions& options, const CommonOptions& common) {
  strata_per_side(options.measuring.pixel_samples, "--pixel-samples");
  const Shard shard = parse_shard(options.shard);
  limits_of({{}, 0.0, options.measuring.light_paths}, options.measuring.bounces);
  const LoadedScene scene = load_world(options.scene, common.threads);
  MeasuringOptions measuring = options.measuring;
  measuring.reference_seed = common.seed;
  const ReferenceQuestion question = question_of(scene.scene(), measuring);
  require_memory(question, available_memory());
  if (!options.out.empty() && question.camera) PictureLibrary();
  std::optional<OutputFolder> folder;
  if (!options.out.empty())
    folder.emplace(options.out, reference_file, options.force, FileLock::WhenTaken::wait, stop_if_cancelled);
  std::string damage;
  const std::optional<Reference> made = shard.of == 1 ? make_whole(options, scene, question, common, damage)
                                                      : make_shard(options, scene, question, shard, common, damage);
  if (!made) {
    if (common.json) print_json({{"shard", options.shard}, {"complete", false}});
    else if (!common.quiet) fmt::print("shard {} is done; the reference is whole when the others are\n", options.shard);
    return ExitStatus::done;
  }
  if (folder) {
    write_reference_files(folder->partial(), scene.scene(), *made);
    stop_if_cancelled();
    folder->commit();
  }
  if (!options.packed.empty()) ReferenceStore(options.packed).save(scene.scene(), *made, ReferenceStore::Keep::packed);
  tell(options, scene, *made, damage, common);
  return ExitStatus::done;
}

}  // namespace

void add_reference(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "reference", "Makes, extends or merges the stored reference of a scene");
  verb->group(verb_group::measuring);
  set_pages(*verb, {"docs/own-scene.md", "docs/reading-errors.md"});
  const auto options = std::make_shared<ReferenceOptions>();
  add_scene_options(*verb, options->scene);
  verb->add_option("--target-error", options->target_error, "Relative standard error of the indirect light at which to stop")
      ->check(CLI::Range(1e-6, 10.0));
  verb->add_option(
          "--samples", options->samples_per_replica,
          fmt::format("Paths per value (surface sample or pixel) in each replicate; {} without a target", default_samples))
      ->check(CLI::Range(std::uint64_t{1}, most_samples));
  verb->add_option("--picture-samples", options->image_samples_per_replica,
                   "At most so many of these paths for each pixel; as many as at the surface without it")
      ->check(CLI::Range(std::uint64_t{1}, most_samples));
  verb->add_option("--replicas", options->replicas, "Independent replicates")->check(CLI::Range(2, 1024))->capture_default_str();
  add_measuring_options(*verb, options->measuring);
  add_light_paths_option(*verb, options->measuring.light_paths);
  verb->add_option("--references", options->store, "Folder of the reference store")
      ->type_name(value_kind::folder)
      ->capture_default_str();
  verb->add_option("--packed", options->packed,
                   "Also keep it in this reference store, in as few bits as its noise leaves meaning: a store to give to others")
      ->type_name(value_kind::folder);
  verb->add_option("--shard", options->shard, "i/n: make only the replicates r with r mod n = i; the last one merges")
      ->capture_default_str();
  verb->add_option("--out", options->out, "Also write reference.exr and reference.json into this folder")
      ->type_name(value_kind::folder);
  verb->add_flag("--force", options->force, "Replace an older --out");
  verb->add_flag("--remake-damaged", options->remake_damaged,
                 "Make a stored reference that is damaged anew; without it that is an error");
  verb->callback([&call, options] { call.action = [&call, options] { return reference(*options, call.common); }; });
}

}  // namespace gibench
