/// A small method that keeps the contract, and the same with one known defect: a check that does not catch the
/// defect made for it checks nothing.
#pragma once

#include "common/method/method_entry.h"

namespace gibench::contract {

/// What is wrong with the method, or with what it says about itself.
enum class Defect {
  none,
  adds_a_constant,           ///< light in watts from nowhere
  drops_dim_light,           ///< a threshold in watts
  sees_one_kind_of_light,    ///< punctual lights count only where nothing emits
  glows_without_light,       ///< and only then
  piles_up_relit_light,      ///< light() adds to what was there
  knows_the_metre,           ///< the answer grows with the room
  knows_the_vertical,        ///< a wall is brighter than a floor
  is_a_little_off,           ///< by less than a placement could be, and claims to know its errors
  reflects_off_black,        ///< no albedo is below a hundredth
  ignores_the_bound,         ///< of bounces
  dims_with_bounces,         ///< more bounces, less light
  leaves_a_gap,              ///< the last value is not written
  writes_not_a_number,       ///< on degenerate input
  lights_the_backs,          ///< of one-sided surfaces
  goes_below_zero,           ///< light that is taken away
  claims_negative_variance,  ///< and to know it
  refuses_plain_scenes,      ///< without need
  refuses_with_a_code,       ///< that says nothing
  refuses_by_turns,          ///< once yes, once no
  counts_its_threads,        ///< the answer depends on how many there are
  draws_unkeyed_numbers,     ///< a random number that no seed fixes
  works_on_when_cancelled,   ///< in its loops
  keeps_what_was_cancelled,  ///< as if it had been finished
  looks_for_what_hides,      ///< where nothing does
  works_for_nothing,         ///< as if there were always something to light
  misnames_its_paths,        ///< as more than it computes
  answers_radiance_alone,    ///< in which nothing is compared at surface samples
  claims_unseen_lobes,       ///< which irradiance does not see
  answers_parts_otherwise,   ///< the indirect light alone is not what it is beside the direct light
  knows_variance_by_halves,  ///< of the total only beside that of its parts
  overlooks_edits,           ///< and keeps the scene that it had
  answers_irradiance_alone,  ///< which is enough: the rest follows from it
};

MethodEntry ambient_method(Defect defect = Defect::none);

}  // namespace gibench::contract
