/// The promises of every transport method, as checks over the way a method is made: nothing here knows which method
/// it looks at; capabilities are asked for, names never.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/method/method_entry.h"

namespace gibench::contract {

/// What was promised and did not hold, with the figures.
class Violation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One promise. `verify` throws Violation where it is broken.
struct Check {
  const char* name;  ///< in CamelCase, for test names
  void (*verify)(const MethodEntry&);
};
/// Every promise once.
std::span<const Check> all_checks();
/// Throws std::out_of_range for a name that no check has.
const Check& find_check(const std::string& name);

/// A method, or where its techniques are choices of a parameter once for each choice: of a name of its own, with quick settings
/// that choose it.
std::vector<MethodEntry> techniques_of(const MethodEntry& entry);

/// What is broken; empty where the promise holds.
std::string violation_of(const Check& check, const MethodEntry& entry);

// The light: light_checks.cpp.
void verify_doubling_the_light_doubles_the_answer(const MethodEntry& entry);
void verify_two_lights_add(const MethodEntry& entry);
void verify_no_light_gives_black(const MethodEntry& entry);
void verify_relighting_equals_a_fresh_run(const MethodEntry& entry);
// The surfaces: surface_checks.cpp.
void verify_scale_invariance(const MethodEntry& entry);
void verify_rotation_invariance(const MethodEntry& entry);
void verify_black_walls_give_no_indirect_light(const MethodEntry& entry);
void verify_bounce_bounds(const MethodEntry& entry);
void verify_every_value_is_written_and_finite(const MethodEntry& entry);
void verify_refusals_are_texts(const MethodEntry& entry);
// The plan: plan_checks.cpp.
void verify_a_convex_room_needs_no_visibility_rays(const MethodEntry& entry);
void verify_no_light_needs_no_work(const MethodEntry& entry);
void verify_black_walls_need_no_indirect_work(const MethodEntry& entry);
void verify_what_is_not_allowed_is_not_computed(const MethodEntry& entry);
void verify_light_paths_are_told(const MethodEntry& entry);
// The run: run_checks.cpp.
void verify_same_seed_same_bits(const MethodEntry& entry);
void verify_cancelling_stops_soon(const MethodEntry& entry);
// Further checks, of what the program asks: program_checks.cpp.
void verify_every_question_is_answered(const MethodEntry& entry);
void verify_parts_are_those_of_the_whole(const MethodEntry& entry);
void verify_editing_equals_a_fresh_run(const MethodEntry& entry);
// The description: description_checks.cpp.
void verify_the_entry_describes_itself(const MethodEntry& entry);
void verify_unknown_parameters_are_refused(const MethodEntry& entry);
void verify_parameters_describe_themselves(const MethodEntry& entry);
void verify_presets_can_be_chosen(const MethodEntry& entry);

}  // namespace gibench::contract
