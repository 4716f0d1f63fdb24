#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "common/core/error.h"
#include "common/metrics/compare_images.h"

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::string reference, test, exposures;
  float pixels_per_degree = default_pixels_per_degree;
};

template <class Number>
Number number_of(const std::string& text, const std::string& whole) {
  Number value{};
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size())
    throw InputError("--exposures " + whole, "'" + text + "' is not a number", "give START,STOP,N, for example -2,4,6");
  return value;
}

/// START,STOP,N.
ExposureRange parse_exposures(const std::string& text) {
  const std::vector<std::string> parts = CLI::detail::split(text, ',');
  if (parts.size() != 3)
    throw InputError("--exposures " + text, "three numbers are wanted", "give START,STOP,N, for example -2,4,6");
  const ExposureRange range{number_of<float>(parts[0], text), number_of<float>(parts[1], text), number_of<int>(parts[2], text)};
  constexpr float most_stops = 100.0F;
  if (!(std::abs(range.start) <= most_stops && std::abs(range.stop) <= most_stops && range.start <= range.stop))
    throw InputError("--exposures " + text, "the range does not run upwards within 100 stops of 0",
                     "give START no larger than STOP");
  if (range.count < 1 || range.count > 1000)
    throw InputError("--exposures " + text, "the number of exposures is not in 1 to 1000",
                     "give a number of exposures in that range");
  return range;
}

Json comparison_json(const ImageComparison& comparison) {
  Json json;
  for (const auto& [name, value] : comparison.values) json[name] = {{"value", value}};
  const FlipStatistics& flip = comparison.flip;
  json[comparison.flip_name] = {{"mean", flip.mean},
                                {"weighted_median", flip.weighted_median},
                                {"quartile_1", flip.quartile_1},
                                {"quartile_3", flip.quartile_3},
                                {"min", flip.min},
                                {"max", flip.max}};
  return json;
}

void print_table(const Json& json) {
  for (const auto& [name, statistics] : json.items())
    for (const auto& [statistic, value] : statistics.items())
      fmt::print("{:<28} {:.6g}\n", statistic == "value" ? name : name + " " + statistic, value.get<double>());
}

ImageFile read_compared(const std::string& file, bool quiet) {
  ImageFile read = read_image_file(file);
  if (!quiet)
    for (const std::string& warning : read.warnings) fmt::print(stderr, "gibench: warning: {}: {}\n", file, warning);
  return read;
}

ExitStatus compare(const CompareOptions& options, const CommonOptions& common) {
  ComparisonOptions how;
  how.pixels_per_degree = options.pixels_per_degree;
  if (!options.exposures.empty()) how.exposures = parse_exposures(options.exposures);
  const ImageFile reference = read_compared(options.reference, common.quiet), test = read_compared(options.test, common.quiet);
  const Json result = comparison_json(compare_images(reference, options.reference, test, options.test, how));
  if (common.json) print_json(result);
  else print_table(result);
  return ExitStatus::done;
}

}  // namespace

void add_compare(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "compare", "Computes every image metric of two EXR, HDR, PNG or JPEG files");
  verb->group(verb_group::measuring);
  set_pages(*verb, {"docs/reading-errors.md"});
  const auto options = std::make_shared<CompareOptions>();
  verb->add_option("reference", options->reference, "The picture that is taken as correct")
      ->type_name(value_kind::file)
      ->required();
  verb->add_option("test", options->test, "The picture that is compared with it")->type_name(value_kind::file)->required();
  verb->add_option("--pixels-per-degree", options->pixels_per_degree, "Resolution of the display, as FLIP's observer sees it")
      ->check(CLI::Range(1.0F, 1000.0F))
      ->capture_default_str();
  verb->add_option("--exposures", options->exposures, "START,STOP,N of HDR-FLIP, in stops; without it from the reference");
  verb->callback([&call, options] { call.action = [&call, options] { return compare(*options, call.common); }; });
}

}  // namespace gibench
