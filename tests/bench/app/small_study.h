/// A small study of the room, run as a user would.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/app/program.h"

namespace gibench::test {

/// The path tracer with each of these numbers of samples against a reference of 16.
nlohmann::ordered_json small_study(const std::vector<int>& samples = {1, 4});

/// Writes small.study.json and runs it into the folder `out`; `before` is shell text put before it.
Outcome study(const Workshop& shop, const nlohmann::ordered_json& json, const std::vector<std::string>& more = {},
              const std::string& before = {});

/// The entry of a run in a manifest; a test failure where there is none.
nlohmann::ordered_json run_of(const nlohmann::ordered_json& manifest, const std::string& id);

/// Every run and what it answers, by its folder, without what a clock, the memory or the order of runs decides.
nlohmann::ordered_json answers_in(const Workshop& shop, const std::string& out);

}  // namespace gibench::test
