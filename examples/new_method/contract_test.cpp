/// The checks that every method must pass, on this one.
#include "tests/contract/contract.h"

#include <cstdio>
#include <string>

#include "methods/gathering/gathering.h"

int main() {
  using namespace gibench;
  int violations = 0;
  for (const MethodEntry& technique : contract::techniques_of(gathering_entry()))
    for (const contract::Check& check : contract::all_checks()) {
      const std::string violation = contract::violation_of(check, technique);
      if (!violation.empty()) ++violations;
      std::printf("%s %s: %s\n", technique.name.c_str(), check.name, violation.empty() ? "holds" : violation.c_str());
    }
  return violations == 0 ? 0 : 1;
}
