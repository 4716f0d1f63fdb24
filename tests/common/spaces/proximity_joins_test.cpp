#include "common/spaces/proximity_joins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "common/core/random.h"

namespace gibench {
namespace {

struct Pieces {
  std::vector<Place> places;
  std::vector<std::uint32_t> piece;
  std::uint32_t count = 0;

  /// A square patch of side² places in the plane of y, spacing 0.1 m.
  void add(int side, const Vec3& corner, const Vec3& normal = {0, 1, 0}, std::uint32_t label = 0) {
    for (int x = 0; x < side; ++x)
      for (int z = 0; z < side; ++z) {
        places.push_back({corner + 0.1F * Vec3(static_cast<float>(x), 0.0F, static_cast<float>(z)), normal, 0.01F, label});
        piece.push_back(count);
      }
    ++count;
  }
  std::vector<Join> joins(std::size_t wanted, float distance = 0.1F, int threads = 2) const {
    Task task(TaskSettings{1, threads, {}, {}});
    return join_small_pieces(places, piece, wanted, distance, task);
  }
  /// Pieces that remain after joins.
  std::size_t remaining(const std::vector<Join>& joins) const {
    std::vector<std::uint32_t> parent(count);
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t of) {
      while (parent[of] != of) of = parent[of];
      return of;
    };
    std::size_t left = count;
    for (const Join& join : joins) {
      const std::uint32_t a = root(piece[join.from]), b = root(piece[join.to]);
      EXPECT_NE(a, b) << "a join within one piece";
      parent[a] = b;
      --left;
    }
    return left;
  }
};

TEST(ProximityJoins, ASmallPieceGoesToTheNearestThatFacesTheSameWay) {
  Pieces pieces;
  pieces.add(20, {0, 0, 0});
  pieces.add(20, {5, 0, 0});
  pieces.add(2, {0.5F, 0.05F, 0.5F}, {0, -1, 0});  // nearer to the crumb, but turned away
  pieces.add(1, {0.5F, 0.08F, 0.5F});              // the crumb
  const auto joins = pieces.joins(3);
  ASSERT_EQ(joins.size(), 1U);
  EXPECT_EQ(pieces.piece[joins[0].from], 3U);
  EXPECT_EQ(pieces.piece[joins[0].to], 0U);
  EXPECT_NEAR(glm::length(pieces.places[joins[0].to].position - Vec3(0.5F, 0, 0.5F)), 0.0, 1e-5);
}

TEST(ProximityJoins, TheSmallestGoFirst) {
  Pieces pieces;
  pieces.add(30, {0, 0, 0});
  pieces.add(4, {0, 0.05F, 0});
  pieces.add(2, {1, 0.05F, 0});
  pieces.add(3, {2, 0.05F, 0});
  const auto joins = pieces.joins(2);
  ASSERT_EQ(joins.size(), 2U);
  EXPECT_EQ(pieces.piece[joins[0].from], 2U);
  EXPECT_EQ(pieces.piece[joins[1].from], 3U);
}

TEST(ProximityJoins, LabelsAreRespected) {
  Pieces pieces;
  pieces.add(20, {0, 0, 0}, {0, 1, 0}, 0);
  pieces.add(1, {0.5F, 0.01F, 0.5F}, {0, 1, 0}, 1);
  EXPECT_TRUE(pieces.joins(1).empty());
  pieces.add(1, {3, 0, 0.5F}, {0, 1, 0}, 1);
  const auto joins = pieces.joins(1);
  ASSERT_EQ(joins.size(), 1U);
  EXPECT_NE(pieces.piece[joins[0].from], 0U);
  EXPECT_NE(pieces.piece[joins[0].to], 0U);
}

TEST(ProximityJoins, DistanceWidensToItsBound) {
  Pieces pieces;
  pieces.add(10, {0, 0, 0});
  pieces.add(1, {20, 0, 0});
  EXPECT_EQ(pieces.joins(1).size(), 1U);        // 19.1 m, within 256 times 0.1 m
  EXPECT_TRUE(pieces.joins(1, 0.05F).empty());  // beyond 12.8 m
}

TEST(ProximityJoins, WhatFacesAwayIsNeverJoined) {
  Pieces pieces;
  pieces.add(10, {0, 0, 0});
  pieces.add(1, {0.5F, 0.01F, 0.5F}, {0, -1, 0});
  EXPECT_TRUE(pieces.joins(1).empty());
}

TEST(ProximityJoins, FewPiecesAreLeftAlone) {
  Pieces pieces;
  pieces.add(10, {0, 0, 0});
  pieces.add(10, {0, 0.01F, 0});
  EXPECT_TRUE(pieces.joins(2).empty());
  Task task;
  EXPECT_TRUE(join_small_pieces({}, {}, 1, 0.1F, task).empty());
}

Pieces loose_pieces(std::uint32_t count) {
  Pieces pieces;
  pieces.add(200, {0, 0, 0});
  for (std::uint32_t i = 0; i < count; ++i) {
    RandomStream random(1, 2, i);
    const float x = 20.0F * random.next_float(), y = 0.5F * random.next_float(), z = 20.0F * random.next_float();
    pieces.add(i % 10 == 0 ? 3 : 1, {x, y, z});
  }
  return pieces;
}

TEST(ProximityJoins, TwentyFiveThousandLoosePiecesBecomeAFew) {
  const Pieces pieces = loose_pieces(25'000);
  const auto joins = pieces.joins(300, 0.02F);
  EXPECT_EQ(pieces.remaining(joins), 300U);
}

TEST(ProximityJoins, VisitsGrowAsNLogN) {
  const auto visits_for_each = [](std::uint32_t count) {
    Pieces pieces;
    for (std::uint32_t i = 0; i < count; ++i) {  // half of them turned away, above the same floor
      RandomStream random(1, 2, i);
      const float x = random.next_float(), z = random.next_float();
      pieces.places.push_back({Vec3(x, i % 2 == 0 ? 0.0F : 0.2F, z), {0, i % 2 == 0 ? 1.0F : -1.0F, 0}, 1.0F, 0});
      pieces.piece.push_back(i);
    }
    Task task;
    const float spacing = 1.0F / std::sqrt(static_cast<float>(count));
    join_small_pieces(pieces.places, pieces.piece, 4, spacing, task);
    return static_cast<double>(task.counters()["join_visits"]) /
           (static_cast<double>(count) * std::log2(static_cast<double>(count)));
  };
  EXPECT_LE(visits_for_each(200'000), 2.0 * visits_for_each(5'000));
}

TEST(ProximityJoins, TheSameForAnyNumberOfThreads) {
  const Pieces pieces = loose_pieces(3000);
  const auto one = pieces.joins(50, 0.02F, 1), three = pieces.joins(50, 0.02F, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_TRUE(one[i].from == three[i].from && one[i].to == three[i].to);
}

}  // namespace
}  // namespace gibench
