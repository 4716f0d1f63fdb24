#include "common/effects/plan_paths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace gibench {

namespace {

constexpr int most_written = 256;  // scatterings in a count; more are as good as no bound, which the plan still has

/// least to most repetitions as a postfix.
std::string times(int least, std::optional<int> most) {
  if (most) return fmt::format("{{{},{}}}", least, *most);
  return least == 0 ? "*" : least == 1 ? "+" : fmt::format("{{{},}}", least);
}

/// least to most scatterings one of which is not diffuse: the first of those, by its place. Alternatives beside one another: as
/// many brackets inside one another would be refused.
std::string with_one_glossy(int least, std::optional<int> most) {
  std::vector<std::string> ways;
  for (int diffuse = 0; !most || diffuse < *most; ++diffuse) {
    const std::string before = diffuse == 0 ? "" : diffuse == 1 ? "D" : fmt::format("D{{{}}}", diffuse);
    if (!most && least - diffuse <= 1) {
      ways.push_back(before + "D*[GS].*");
      break;
    }
    ways.push_back(before + "[GS]." +
                   times(std::max(0, least - diffuse - 1), most ? std::optional(*most - diffuse - 1) : std::nullopt));
  }
  return ways.size() == 1 ? ways.front() : fmt::format("({})", fmt::join(ways, "|"));
}

}  // namespace

std::string light_paths_of(const EffectPlan& plan, bool direct_of_every_lobe, const BounceRange& range) {
  const auto computes = [&](Effect effect) { return !plan.leaves_out(effect); };
  std::optional<int> last = range.last;
  if (plan.max_bounces) last = last ? std::min(*last, *plan.max_bounces) : *plan.max_bounces;
  if (last && *last > most_written) last.reset();
  const int first = range.first, indirect = std::max(1, first);
  const std::string end = computes(Effect::environment) ? "[LOB]" : "[LO]";
  const std::string seen = computes(Effect::glossy_final_bounce) ? "." : "D";
  const std::string seen_directly = direct_of_every_lobe && !plan.forbids(Effect::glossy_final_bounce) ? "." : seen;
  // A class that the scene does not call for has no path of it: left in where that makes the expression simpler.
  const bool every_class = computes(Effect::direct) && computes(Effect::diffuse_indirect) && computes(Effect::glossy_chain);
  const auto tells = [&](Effect effect) { return every_class || plan.simulates(effect); };
  const bool direct = tells(Effect::direct) && first == 0;
  const bool reaches_indirect = !last || *last >= indirect;
  const bool diffuse = tells(Effect::diffuse_indirect) && reaches_indirect;
  const bool glossy = tells(Effect::glossy_chain) && reaches_indirect;
  const auto one_more = [](std::optional<int> count) { return count ? std::optional(*count + 1) : count; };

  std::vector<std::string> parts;
  if (direct && diffuse && glossy && seen == "." && seen_directly == ".") {
    parts.push_back("C." + times(0, one_more(last)) + end);
  } else {
    if (direct) parts.push_back(fmt::format("C{}{{0,1}}{}", seen_directly, end));
    if (diffuse && glossy) parts.push_back(fmt::format("C{}.{}{}", seen, times(indirect, last), end));
    else if (diffuse) parts.push_back(fmt::format("C{}D{}{}", seen, times(indirect, last), end));
    else if (glossy) parts.push_back(fmt::format("C{}{}{}", seen, with_one_glossy(indirect, last), end));
  }
  return parts.empty() ? "C[^.]" : fmt::format("{}", fmt::join(parts, "|"));
}

}  // namespace gibench
