/// The tables of a study, for the page and for files.
#pragma once

#include <string>
#include <vector>

#include "bench/report/ranking.h"
#include "bench/report/table.h"

namespace gibench::report {

/// One scene: error with interval, speed-up, seconds per stage, memory, rays; a row a run.
Table scene_table(const Study& study, std::size_t scene, const ErrorKey& key);
/// The ranking of `key` across scenes.
Table ranking_table(const Study& study, const ErrorKey& key, const std::vector<RankingRow>& rows);
/// Every error of every run, long.
Table error_table(const Study& study);
/// Called for, simulated, missing and skipped, a row a scene, method and effect.
Table effect_table(const Study& study);
/// The same at a glance: a row a scene and method, a column an effect.
Table effect_matrix(const Study& study);
/// Runs that were refused, timed out, crashed or failed, and why; skipped scenes too.
Table failure_table(const Study& study);
/// Every run: status, parameters, stages, memory, counters that are common to all.
Table run_table(const Study& study);

/// scene-NAME made of letters, digits and hyphens, unique in the study.
std::string scene_slug(const Study& study, std::size_t scene);

}  // namespace gibench::report
