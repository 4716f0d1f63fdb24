/// The tables of a study, for the page and for files.
#pragma once

#include <string>
#include <vector>

#include "reports/tables/ranking.h"
#include "reports/tables/table.h"

namespace gibench::report {

/// One scene: error with interval, speed-up, seconds per stage, memory, rays; one row for each run.
Table scene_table(const Study& study, std::size_t scene, const ErrorKey& key);
/// The ranking of `key` across scenes.
Table ranking_table(const Study& study, const ErrorKey& key, const std::vector<RankingRow>& rows);
/// Every error of every run, long.
Table error_table(const Study& study);
/// Called for, simulated, missing and skipped, one row for each scene, method and effect.
Table effect_table(const Study& study);
/// Overview: one row for each scene and plan, one column for each effect, and what the missing effects cost.
Table effect_matrix(const Study& study);
/// What each scene calls for, a column an effect, and its bounce bound.
Table call_table(const Study& study);
/// The same with the evidence, one row for each scene and effect.
Table evidence_table(const Study& study);
/// Error of every run in its two parts: what its light paths lack, and its discretisation of those it has.
Table split_table(const Study& study, const ErrorKey& key);
/// Both parts by the number of reflections, for runs that measured them.
Table bounce_table(const Study& study, const ErrorKey& key);
/// Runs that were refused, timed out, crashed or failed, and why; skipped scenes too.
Table failure_table(const Study& study);
/// Every run: status, parameters, stages, memory, counters that are common to all.
Table run_table(const Study& study);
/// A relit frame compared with path tracing, one row for each relighting.
Table relight_table(const Study& study);
/// The frames of all relightings, a row each.
Table relit_frame_table(const Study& study);
/// After how many frames preparing has paid for itself, in words; empty where it was not measured.
std::string relight_sentence(const StudyRelight& relight);

/// scene-NAME made of letters, digits and hyphens, unique in the study.
std::string scene_slug(const Study& study, std::size_t scene);

}  // namespace gibench::report
