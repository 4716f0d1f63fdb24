#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>

#include "common/core/error.h"
#include "common/light_paths/automaton.h"
#include "tests/common/light_paths/naive_matcher.h"

namespace gibench {
namespace {

using Path = std::vector<PathEvent>;
using enum PathEvent;

/// Every path of at most `longest` scatterings of these kinds, each ended by every light.
std::vector<Path> all_paths(const std::vector<PathEvent>& kinds, int longest) {
  std::vector<Path> begun{{camera}}, paths;
  for (int length = 0; length <= longest; ++length) {
    std::vector<Path> longer;
    for (const Path& path : begun) {
      for (const PathEvent end : ending_events) {
        paths.push_back(path);
        paths.back().push_back(end);
      }
      for (const PathEvent kind : kinds) {
        longer.push_back(path);
        longer.back().push_back(kind);
      }
    }
    begun = std::move(longer);
  }
  return paths;
}

const std::vector<Path>& many_paths() {
  static const std::vector<Path> paths = [] {
    std::vector<Path> all = all_paths({diffuse_reflection, glossy_reflection, mirror_reflection}, 5);
    const std::vector<Path> others = all_paths({scattering_events.begin(), scattering_events.end()}, 2);
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return paths;
}

void expect_as_by_hand(const std::string& text) {
  const PathExpression expression = parse_light_paths(text);
  const PathAutomaton automaton(expression);
  std::size_t differ = 0;
  for (const Path& path : many_paths()) differ += automaton.matches(path) != test::naive_match(expression, path) ? 1U : 0U;
  EXPECT_EQ(differ, 0U) << text;
}

std::string message_of(const std::string& text) {
  try {
    parse_light_paths(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(PathAutomaton, AcceptsWhatTryingEveryWayAccepts) {
  for (const char* text : {"C.*[LOB]",
                           "CL",
                           "C[LOB]",
                           "CD*L",
                           "CD+[LO]",
                           "C.{0,3}[LOB]",
                           "C.{2}B",
                           "C.{1,}O",
                           "CDG*S+[^L]",
                           "C(D|GS)*[LO]",
                           "C<RD>*<[LO]>",
                           "C<R[GS]>+D*L",
                           "C<T.>R*[LOB]",
                           "C[<RD><TS>]*B",
                           "C(DG){1,2}L|CS+O",
                           "C .* S .* L",
                           "C.{0,1}[LOB]|CDD+[LOB]",
                           "C.*",
                           ".*",
                           "C[^D]*[LOB]",
                           "C(D*G*)*O",
                           "C(D{0,2}G{0,2}){2}L",
                           "CD*[GS].*[LOB]",
                           "C<[^R]D>*L",
                           "C[^<RD>]*L",
                           "C(D|D)*L"})
    expect_as_by_hand(text);
}

/// A random expression, deeper parts shorter.
std::string random_expression(std::mt19937& random, int depth) {
  const auto pick = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  const char* events[] = {"D", "G",    "S",    "R",    "T",    ".",    "L",     "O",
                          "B", "[DG]", "[^D]", "<RS>", "<.D>", "[LO]", "[^LB]", "<R[DS]>"};
  if (depth == 0) return events[pick(16)];
  const std::string inner = random_expression(random, depth - 1);
  switch (pick(6)) {
    case 0: return inner + random_expression(random, depth - 1);
    case 1: return std::string("(").append(inner).append("|").append(random_expression(random, depth - 1)).append(")");
    case 2: return std::string("(").append(inner).append(")*");
    case 3: return std::string("(").append(inner).append(")+");
    case 4: {
      const std::string least = std::to_string(pick(2)), most = std::to_string(1 + pick(3));
      return std::string("(").append(inner).append("){").append(least).append(",").append(most).append("}");
    }
    default: return inner;
  }
}

TEST(PathAutomaton, AcceptsWhatTryingEveryWayAcceptsOfRandomExpressions) {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i)
    expect_as_by_hand(std::string("C").append(random_expression(random, 3)).append(i % 2 == 0 ? "[LOB]" : ""));
}

TEST(PathAutomaton, IsMinimal) {
  EXPECT_EQ(PathAutomaton("C.*[LOB]").size(), 1U);
  EXPECT_EQ(PathAutomaton("C.{0,3}[LOB]").size(), 5U) << "0 to 3 scatterings, and the dead";
  EXPECT_EQ(PathAutomaton("C(D|G|S)*[LOB]").size(), 1U);
  EXPECT_EQ(PathAutomaton("CD*[LOB]").size(), 2U);
  EXPECT_EQ(PathAutomaton("CD*D*(D|DD)*[LOB]").size(), 2U);
  EXPECT_FALSE(PathAutomaton("C.{0,3}[LOB]").tells_reflections_apart());
  EXPECT_TRUE(PathAutomaton("CD*[LOB]").tells_reflections_apart());
}

TEST(PathAutomaton, KnowsItsDeadStates) {
  const PathAutomaton automaton("CD{0,1}G[LO]");
  auto state = PathAutomaton::start;
  EXPECT_TRUE(automaton.goes_on(state));
  state = automaton.next(state, diffuse_reflection);
  EXPECT_TRUE(automaton.goes_on(state));
  EXPECT_FALSE(automaton.alive(automaton.next(state, diffuse_reflection)));
  state = automaton.next(state, glossy_reflection);
  EXPECT_TRUE(automaton.alive(state));
  EXPECT_FALSE(automaton.goes_on(state));
  EXPECT_TRUE(automaton.accepts(state, light));
  EXPECT_FALSE(automaton.accepts(state, background));
  EXPECT_FALSE(PathAutomaton("CC").alive(PathAutomaton::start)) << "no path has two cameras";
}

TEST(PathAutomaton, WhatASceneDoesNotHaveMakesStatesDead) {
  const PathAutomaton caustics("CD+[GS]+[LOB]");
  EXPECT_FALSE(caustics.restricted_to(PathEvents(diffuse_reflection) | light_ends).alive(PathAutomaton::start));
  EXPECT_TRUE(caustics.restricted_to(reflections | light_ends).alive(PathAutomaton::start));
  const PathEvents matt = PathEvents(diffuse_reflection) | emitter;
  EXPECT_TRUE(equivalent(PathAutomaton("CD*[LOB]").restricted_to(matt), PathAutomaton().restricted_to(matt)));
  EXPECT_FALSE(equivalent(PathAutomaton("CD*[LOB]"), PathAutomaton()));
  EXPECT_FALSE(equivalent(PathAutomaton("CD*[LB]").restricted_to(matt), PathAutomaton().restricted_to(matt)));
}

TEST(PathAutomaton, LargeCountsStayLinear) {
  const PathAutomaton automaton("C.{0,300}[LOB]");
  EXPECT_EQ(automaton.size(), 302U);
  Path path(302, diffuse_reflection);
  path.front() = camera, path.back() = light;
  EXPECT_TRUE(automaton.matches(path));
  path.insert(path.begin() + 1, glossy_reflection);
  EXPECT_FALSE(automaton.matches(path));
}

TEST(LightPaths, MalformedOnesAreToldWithPositionAndWhatWasExpected) {
  const std::vector<std::tuple<std::string, int, std::string>> cases{{"", 1, "an event"},
                                                                     {"C(", 3, "an event"},
                                                                     {"C(D", 4, "')'"},
                                                                     {"CD)", 3, "no '(' is open"},
                                                                     {"C[", 3, "an event of the group"},
                                                                     {"C[]L", 3, "an event of the group"},
                                                                     {"C[DL", 5, "']'"},
                                                                     {"*", 1, "an event"},
                                                                     {"CD|", 4, "an event"},
                                                                     {"C|*", 3, "an event"},
                                                                     {"CXL", 2, "an event"},
                                                                     {"CD{", 4, "a count"},
                                                                     {"CD{1", 5, "',' or '}'"},
                                                                     {"CD{3,1}L", 6, "at least 3"},
                                                                     {"CD{1,2L", 7, "'}'"},
                                                                     {"CD{999999999}L", 0, "at most"},
                                                                     {"C<", 3, "an event type"},
                                                                     {"C<RX>", 4, "a scattering kind"},
                                                                     {"C<RD", 5, "'>'"},
                                                                     {"C<R[>", 5, "a scattering kind"},
                                                                     {"CD?L", 3, "{0,1}"},
                                                                     {"C D \xc3\xa9", 5, "an event"}};
  for (const auto& [text, position, expected] : cases) {
    const std::string message = message_of(text);
    EXPECT_THAT(message, testing::HasSubstr(expected)) << text;
    if (position > 0) {
      EXPECT_THAT(message, testing::HasSubstr("position " + std::to_string(position) + ";")) << text;
    }
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_THAT(message_of(std::string(300, '(')), testing::HasSubstr("100 brackets"));
  EXPECT_THAT(message_of("C\xc3\xa9"), testing::HasSubstr("no letter of the syntax"));
}

TEST(LightPaths, CountsThatMakeTooManyStatesAreBadInput) {
  EXPECT_THROW(PathAutomaton("C((D{0,100000}G){0,100}){0,100}L"), InputError);
  EXPECT_THROW(PathAutomaton("C.{0,70000}L"), InputError);
}

std::string refusal_of(const std::string& text) {
  try {
    PathAutomaton automaton(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// Without their bounds the first three take hours or gigabytes, the others the stack.
TEST(LightPaths, WhatIsWrittenSoThatItNeverEndsIsRefused) {
  EXPECT_THAT(refusal_of("C(.{0,300}){0,300}[LOB]"), testing::HasSubstr("counts inside counts can be taken in too many ways"));
  EXPECT_THAT(refusal_of("C((D|DD|DDD){0,200}G{0,200}){0,50}[LOB]"), testing::HasSubstr("lower them, or write *"));
  EXPECT_THAT(refusal_of("C(((D{0,0}){100000}){100000}){100000}L"), testing::HasSubstr("lower them, or write *"));
  EXPECT_THAT(refusal_of("CD" + std::string(200000, '*') + "L"), testing::HasSubstr("at most 10 operators"));
  EXPECT_THAT(refusal_of("C" + std::string(200000, '[') + "L"), testing::HasSubstr("at most 100 brackets"));
  EXPECT_LT(refusal_of("C" + std::string(200000, '[') + "L").size(), 400U) << "no line fills the terminal";
}

TEST(PathAutomaton, OfThousandsOfStatesIsMinimalToo) {
  // A state a scattering, each told from the next by the last only: what takes a round of refinement for each state.
  const PathAutomaton bounded("C.{0,60000}[LOB]");
  EXPECT_EQ(bounded.size(), 60002U);
  EXPECT_TRUE(equivalent(PathAutomaton("C.{0,60001}[LOB]"), PathAutomaton("C(..){0,30000}(D{0,0}|.)[LOB]")));
  EXPECT_FALSE(equivalent(bounded, PathAutomaton("C.{0,60001}[LOB]")));
  EXPECT_EQ(PathAutomaton("C(D{1000}|D{1000})*[LOB]").size(), 1001U);
}

}  // namespace
}  // namespace gibench
