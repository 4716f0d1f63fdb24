/// Light transport is linear in the lights, and lights change without the rest.
#include <fmt/format.h>

#include "tests/contract/compare.h"
#include "tests/contract/contract.h"
#include "tests/contract/run.h"
#include "tests/contract/scenes.h"

namespace gibench::contract {

void verify_doubling_the_light_doubles_the_answer(const MethodEntry& entry) {
  const World world(plain_box());
  const Lighting lighting = Lighting::of(world.scene());
  const auto samples = samples_of(world);
  const std::vector<Quantity> quantities = light_quantities(entry);
  Run run(entry, world);
  const std::vector<Answer> base = run.prepare().light(lighting).shade(quantities, samples);
  // 2⁻²⁰ is a light that is all but out: thresholds in watts would show.
  for (const float factor : {2.0F, 0x1p-20F}) {
    const std::vector<Answer> multiple = run.light(scaled(lighting, factor)).shade(quantities, samples);
    for (std::size_t q = 0; q < quantities.size(); ++q)
      require_multiple(base[q], multiple[q], static_cast<double>(factor),
                       fmt::format("{} under {} times the light", to_string(quantities[q]), factor));
  }
}

void verify_two_lights_add(const MethodEntry& entry) {
  const World world(plain_box());
  const Lighting both = Lighting::of(world.scene());
  const auto samples = samples_of(world);
  const Quantity quantity = plainest_quantity(entry);
  Run run(entry, world);
  run.prepare();
  const Answer together = run.light(both).shade(quantity, samples);
  Answer sum = run.light(only_emission(both)).shade(quantity, samples);
  const Answer second = run.light(only_punctual(both)).shade(quantity, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum.direct[i] += second.direct[i];
    sum.indirect[i] += second.indirect[i];
  }
  require_same_means(together, sum, samples, slack_of(entry), "the sum of two lights' answers against both at once");
}

void verify_no_light_gives_black(const MethodEntry& entry) {
  const World dark(dark_box()), lit(plain_box());
  const std::vector<Quantity> quantities = light_quantities(entry);
  for (const Answer& unlit : fresh_answers(entry, dark, quantities, samples_of(dark))) {
    require_black(unlit.direct, "direct light of a scene without lights");
    require_black(unlit.indirect, "indirect light of a scene without lights");
  }
  // Lights that are there but put out, after a plan that reckons with them.
  Run run(entry, lit);
  run.prepare().light();
  for (const Answer& out : run.light(scaled(Lighting::of(lit.scene()), 0.0F)).shade(quantities, samples_of(lit))) {
    require_black(out.direct, "direct light once the lights are out");
    require_black(out.indirect, "indirect light once the lights are out");
  }
}

void verify_relighting_equals_a_fresh_run(const MethodEntry& entry) {
  const World world(plain_box());
  const Lighting first = Lighting::of(world.scene()), second = only_punctual(first);
  const auto samples = samples_of(world);
  const Quantity quantity = plainest_quantity(entry);
  Run run(entry, world), fresh(entry, world);
  const Answer before = run.prepare().light(first).shade(quantity, samples);
  const Answer relit = run.light(second).shade(quantity, samples);
  require_same_bits(fresh.prepare().light(second).shade(quantity, samples), relit, "a fresh run against a relit one");
  require_same_bits(before, run.light(first).shade(quantity, samples), "the first lights, and the first lights again");
}

}  // namespace gibench::contract
