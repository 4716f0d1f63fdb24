#include "common/spaces/place_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/core/random.h"

namespace gibench {
namespace {

/// A square sheet of side² places, spacing 1, in the plane y = height.
void add_sheet(std::vector<Place>& places, int side, float height, const Vec3& normal, std::uint32_t label = 0) {
  for (int x = 0; x < side; ++x)
    for (int z = 0; z < side; ++z)
      places.push_back({Vec3(static_cast<float>(x), height, static_cast<float>(z)), normal, 1.0F, label});
}

std::vector<std::vector<std::uint32_t>> members_of(const std::vector<std::uint32_t>& cluster_of_place) {
  std::vector<std::vector<std::uint32_t>> members(cluster_count(cluster_of_place));
  for (std::uint32_t i = 0; i < cluster_of_place.size(); ++i) members[cluster_of_place[i]].push_back(i);
  return members;
}

Vec3 mean_normal(const std::vector<Place>& places, const std::vector<std::uint32_t>& members) {
  Vec3 sum(0.0F);
  for (const std::uint32_t member : members) sum += places[member].area * places[member].normal;
  return glm::normalize(sum);
}

Vec3 random_normal(RandomStream& random) {
  const float z = 2.0F * random.next_float() - 1.0F, angle = 2.0F * pi * random.next_float();
  const float radius = std::sqrt(std::max(0.0F, 1.0F - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<Place> random_places(std::size_t count, std::uint64_t seed) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(seed, 0, i);
    const float x = random.next_float(), y = random.next_float(), z = random.next_float();
    places.push_back({Vec3(x, y, z), random_normal(random), 1e-4F, 0});
  }
  return places;
}

TEST(PlaceClusters, ASheetFallsIntoCompactOnes) {
  std::vector<Place> places;
  add_sheet(places, 64, 0.0F, {0, 1, 0});
  Task task;
  const auto members = members_of(cluster_places(places, {64, 0.9F}, task));
  EXPECT_LE(members.size(), 64U);
  EXPECT_GE(members.size(), 32U);
  for (const auto& of : members) {
    Vec3 low(1e9F), high(-1e9F);
    for (const std::uint32_t i : of) low = glm::min(low, places[i].position), high = glm::max(high, places[i].position);
    EXPECT_LE(glm::length(high - low), 23.0F);  // the diagonal of 16 by 16, twice the area of an even share
  }
}

TEST(PlaceClusters, SheetsBackToBackStayApart) {
  std::vector<Place> places;
  add_sheet(places, 32, 0.0F, {0, 1, 0});
  add_sheet(places, 32, -0.01F, {0, -1, 0});
  Task task;
  for (const auto& of : members_of(cluster_places(places, {20, 0.5F}, task)))
    for (const std::uint32_t i : of) EXPECT_EQ(places[i].normal, places[of.front()].normal);
}

TEST(PlaceClusters, NormalsKeepToTheirMean) {
  std::vector<Place> places;  // a ball
  for (std::uint64_t i = 0; i < 5000; ++i) {
    RandomStream random(1, 2, i);
    const Vec3 normal = random_normal(random);
    places.push_back({normal, normal, 4.0F * pi / 5000.0F, 0});
  }
  Task task;
  const auto members = members_of(cluster_places(places, {200, 0.9F}, task));
  EXPECT_LE(members.size(), 200U);
  for (const auto& of : members) {
    const Vec3 mean = mean_normal(places, of);
    for (const std::uint32_t i : of) EXPECT_GE(glm::dot(places[i].normal, mean), 0.9F - 1e-4F);
  }
}

TEST(PlaceClusters, NoneMixesLabels) {
  std::vector<Place> places = random_places(5000, 3);
  for (std::size_t i = 0; i < places.size(); ++i) places[i].label = 7 * static_cast<std::uint32_t>(i % 5);
  Task task;
  const auto members = members_of(cluster_places(places, {100, -1.0F}, task));
  EXPECT_LE(members.size(), 100U);
  for (const auto& of : members)
    for (const std::uint32_t i : of) EXPECT_EQ(places[i].label, places[of.front()].label);
}

TEST(PlaceClusters, MoreLabelsThanClustersGiveOneForEach) {
  std::vector<Place> places = random_places(1000, 4);
  for (std::size_t i = 0; i < places.size(); ++i) places[i].label = static_cast<std::uint32_t>(i % 50);
  Task task;
  EXPECT_EQ(cluster_count(cluster_places(places, {10, 0.9F}, task)), 50U);
}

TEST(PlaceClusters, FewPlacesAreTheirOwn) {
  std::vector<Place> places = random_places(10, 5);
  places[3] = places[2];
  Task task;
  const auto clusters = cluster_places(places, {10, 0.9F}, task);
  for (std::uint32_t i = 0; i < clusters.size(); ++i) EXPECT_EQ(clusters[i], i);
  EXPECT_TRUE(cluster_places({}, {10, 0.9F}, task).empty());
}

TEST(PlaceClusters, PlacesAtOnePointAndWithoutAreaComeTogether) {
  const std::vector<Place> places(1000, Place{Vec3(1, 2, 3), Vec3(0, 0, 1), 0.0F, 0});
  Task task;
  EXPECT_EQ(cluster_count(cluster_places(places, {5, 0.9F}, task)), 1U);
}

/// 25 000 loose cubes of 1 cm on a floor of 100 m², which alone could take up the clusters.
TEST(PlaceClusters, CrumbsDoNotTakeUpTheClusters) {
  std::vector<Place> places;
  add_sheet(places, 100, 0.0F, {0, 1, 0});
  for (Place& place : places) place.position *= 0.1F, place.area = 0.01F;
  const std::size_t of_floor = places.size();
  for (std::uint64_t i = 0; i < 25'000; ++i) {
    RandomStream random(8, 9, i);
    const float x = 10.0F * random.next_float(), y = 3.0F * random.next_float(), z = 10.0F * random.next_float();
    for (const float sign : {-1.0F, 1.0F})
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal(0.0F);
        normal[axis] = sign;
        places.push_back({Vec3(x, y, z) + 0.005F * normal, normal, 1e-4F, 1});
      }
  }
  Task task;
  const auto clusters = cluster_places(places, {4000, 0.5F}, task);
  EXPECT_LE(cluster_count(clusters), 4000U);
  EXPECT_GE(cluster_count(clusters), 2000U);
  EXPECT_GE(std::set<std::uint32_t>(clusters.begin(), clusters.begin() + static_cast<std::ptrdiff_t>(of_floor)).size(), 20U);
}

TEST(PlaceClusters, VisitsGrowAsNLogN) {
  const auto visits_for_each = [](std::size_t count) {
    Task task;
    const auto places = random_places(count, 6);
    EXPECT_LE(cluster_count(cluster_places(places, {count / 20, 0.5F}, task)), count / 20);
    return static_cast<double>(task.counters()["cluster_visits"]) /
           (static_cast<double>(count) * std::log2(static_cast<double>(count)));
  };
  EXPECT_LE(visits_for_each(1'000'000), 1.5 * visits_for_each(10'000));
  EXPECT_LE(visits_for_each(10'000), 12.0);
}

TEST(PlaceClusters, TheSameForAnyNumberOfThreads) {
  const std::vector<Place> places = random_places(50'000, 7);
  Task one(TaskSettings{1, 1, {}, {}}), three(TaskSettings{1, 3, {}, {}});
  EXPECT_EQ(cluster_places(places, {700, 0.5F}, one), cluster_places(places, {700, 0.5F}, three));
}

}  // namespace
}  // namespace gibench
