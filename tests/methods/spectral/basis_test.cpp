#include "methods/spectral/basis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/core/random.h"
#include "methods/spectral/eigenvectors.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace spectral;

/// A mesh cut into parts, with a basis on each.
struct Based {
  World world;
  Task task;
  SamplingMesh mesh;
  Interpolation interpolation;
  SurfaceGraph graph;
  Partition partition;
  BasisMaking made;

  Based(Scene scene, double vertices, std::uint32_t part_vertices, std::uint32_t functions, Laplacian kind)
      : world(std::move(scene), 1),
        mesh(world, {edge_length_for(world, vertices)}),
        interpolation(world, mesh, task),
        graph(make_graph(mesh, interpolation)),
        partition(partition_mesh(graph, part_vertices)),
        made(BasisMaking::make(graph, partition, share_out(partition, functions), kind, task)) {}
  const SpectralBasis& basis() const { return made.basis; }
};

constexpr Laplacian kinds[] = {Laplacian::cotan, Laplacian::graph};

double inner_product(const SpectralBasis& basis, const SpectralBasis::Part& part, std::uint32_t a, std::uint32_t b) {
  double sum = 0.0;
  for (std::uint32_t slot = part.begin; slot < part.end; ++slot) {
    const auto row = basis.row(part, slot);
    sum += static_cast<double>(basis.weight()[slot]) * static_cast<double>(row[a]) * static_cast<double>(row[b]);
  }
  return sum;
}

Scene square(float side) {
  SceneBuilder builder;
  builder.quad("square", builder.diffuse("white", Rgb(0.5F)), {{{0, 0, 0}, {0, 0, side}, {side, 0, side}, {side, 0, 0}}});
  return builder.build("square");
}

TEST(SpectralBasis, FunctionsAreOrthonormalInTheirInnerProduct) {
  for (const Laplacian kind : kinds) {
    const Based based(closed_room(), 3000, 500, 200, kind);
    ASSERT_TRUE(based.made.failure.empty()) << based.made.failure;
    for (const SpectralBasis::Part& part : based.basis().parts())
      for (std::uint32_t a = 0; a < part.functions; ++a)
        for (std::uint32_t b = 0; b <= a; ++b) EXPECT_NEAR(inner_product(based.basis(), part, a, b), a == b ? 1.0 : 0.0, 1e-6);
  }
}

TEST(SpectralBasis, PartsHangTogetherAndHaveAboutTheSizeAskedFor) {
  const Based based(closed_room(), 4000, 250, 100, Laplacian::cotan);
  std::vector<std::uint32_t> seen;
  for (std::size_t p = 0; p < based.partition.parts(); ++p) {
    EXPECT_LE(based.partition.part_size(p), 500U);
    const std::set<std::uint32_t> members(based.partition.order.begin() + based.partition.part_begin[p],
                                          based.partition.order.begin() + based.partition.part_begin[p + 1]);
    std::vector<std::uint32_t> front{*members.begin()};
    std::set<std::uint32_t> reached{*members.begin()};
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t other : based.graph.neighbours(v))
        if (members.contains(other) && reached.insert(other).second) front.push_back(other);
    }
    EXPECT_EQ(reached, members);
    seen.insert(seen.end(), members.begin(), members.end());
  }
  std::sort(seen.begin(), seen.end());
  for (std::uint32_t v = 0; v < seen.size(); ++v) ASSERT_EQ(seen[v], v);
  EXPECT_EQ(seen.size(), based.mesh.vertices().size());
}

TEST(SpectralBasis, CompleteBasisReproducesAnyFunction) {
  for (const Laplacian kind : kinds) {
    Based based(closed_room(), 600, 150, 100000, kind);
    const SpectralBasis& basis = based.basis();
    EXPECT_EQ(basis.functions(), basis.slots());
    std::vector<Rgb4> values(basis.slots()), coefficients(basis.columns()), back(values);
    RandomStream random(1, 2, 3);
    for (Rgb4& value : values) value = Rgb(random.next_float(), random.next_float(), random.next_float());
    basis.project(values, coefficients, based.task);
    basis.reconstruct(coefficients, back, based.task);
    for (std::size_t i = 0; i < values.size(); ++i)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(Rgb(back[i])[c], Rgb(values[i])[c], 2e-5F);
  }
}

TEST(SpectralBasis, ConstantLightIsHeldExactlyByOneFunctionAPart) {
  for (const Laplacian kind : kinds) {
    Based based(closed_room(), 1500, 300, 1, kind);
    const SpectralBasis& basis = based.basis();
    EXPECT_EQ(basis.functions(), basis.parts().size());
    std::vector<Rgb4> values(basis.slots(), Rgb(3.0F)), coefficients(basis.columns()), back(values);
    basis.project(values, coefficients, based.task);
    basis.reconstruct(coefficients, back, based.task);
    for (const Rgb4& value : back) EXPECT_NEAR(value.r, 3.0F, 1e-4F);
  }
}

TEST(SpectralBasis, CotangentEigenvaluesOfASquareAreThoseOfTheContinuum) {
  // −Δ on a square with free edges: π²(m² + n²)/a², so that 0, 1, 1, 2, 4, 4, 5, 5, 8 times π²/a² begin the spectrum, pairs and
  // all.
  const Based based(square(2.0F), 2500, 100000, 9, Laplacian::cotan);
  ASSERT_EQ(based.partition.parts(), 1U);
  const double mean_area = 4.0 / static_cast<double>(based.graph.size());
  const auto laplacian = symmetric_laplacian(based.graph, based.partition.order, Laplacian::cotan, mean_area);
  const auto pairs = smallest_eigenpairs(laplacian.matrix, 9);
  ASSERT_TRUE(pairs);
  EXPECT_FALSE(pairs->dense);
  const double unit = pi_double * pi_double / 4.0;
  const std::array<double, 9> expected{0, 1, 1, 2, 4, 4, 5, 5, 8};
  for (Eigen::Index i = 0; i < 9; ++i)
    EXPECT_NEAR(pairs->values[i] / mean_area / unit, expected[static_cast<std::size_t>(i)], 0.02);
}

TEST(SpectralBasis, GraphLaplacianIsThePapersMatrix) {
  const Based based(square(1.0F), 60, 100000, 5, Laplacian::graph);
  const auto laplacian = symmetric_laplacian(based.graph, based.partition.order, Laplacian::graph, 1.0);
  const Eigen::VectorXd root = laplacian.weight.cwiseSqrt();
  const Eigen::MatrixXd papers = root.cwiseInverse().asDiagonal() * Eigen::MatrixXd(laplacian.matrix) * root.asDiagonal();
  for (Eigen::Index i = 0; i < papers.rows(); ++i) {
    const auto vertex = static_cast<std::uint32_t>(i);
    const auto neighbours = based.graph.neighbours(vertex);
    for (Eigen::Index j = 0; j < papers.cols(); ++j) {
      const bool joined = std::find(neighbours.begin(), neighbours.end(), static_cast<std::uint32_t>(j)) != neighbours.end();
      const double expected = i == j ? 1.0 : joined ? -1.0 / static_cast<double>(neighbours.size()) : 0.0;
      EXPECT_NEAR(papers(i, j), expected, 1e-12);
    }
  }
}

TEST(SpectralBasis, EigenvaluesThatLanczosPassesOverAreFoundAllTheSame) {
  // A diagonal matrix with clusters of equal values: a Krylov space holds one vector of each.
  constexpr Eigen::Index rows = 400;
  Eigen::SparseMatrix<double> matrix(rows, rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    matrix.insert(i, i) = i < 12 ? static_cast<double>(i / 4) : 5.0 + static_cast<double>(i);
  const auto pairs = smallest_eigenpairs(matrix, 13);
  ASSERT_TRUE(pairs);
  for (Eigen::Index i = 0; i < 12; ++i) EXPECT_NEAR(pairs->values[i], static_cast<double>(i / 4), 1e-8);
}

TEST(SpectralBasis, UnusableMatrixIsToldNotAnswered) {
  Eigen::SparseMatrix<double> matrix(300, 300);
  for (Eigen::Index i = 0; i < 300; ++i) matrix.insert(i, i) = std::nan("");
  EXPECT_FALSE(smallest_eigenpairs(matrix, 5));
}

TEST(SpectralBasis, TooManyPartsAreRefusedByName) {
  SurfaceGraph graph;  // vertices by themselves
  graph.area.assign(10000, 1.0);
  graph.begin.assign(10001, 0);
  Task task;
  const Partition partition = partition_mesh(graph, 100);
  const BasisMaking made = BasisMaking::make(graph, partition, share_out(partition, 10), Laplacian::cotan, task);
  EXPECT_NE(made.failure.find("10000 parts"), std::string::npos) << made.failure;
}

TEST(SpectralBasis, PartOfOneVertexHasTheConstant) {
  SurfaceGraph graph;
  graph.area = {1.0, 2.0};
  graph.begin = {0, 0, 0};
  for (const Laplacian kind : kinds) {
    Task task;
    const Partition partition = partition_mesh(graph, 100);
    const BasisMaking made = BasisMaking::make(graph, partition, share_out(partition, 100), kind, task);
    ASSERT_TRUE(made.failure.empty()) << made.failure;
    std::vector<Rgb4> values{Rgb(1.0F), Rgb(5.0F)}, coefficients(made.basis.columns()), back(2);
    made.basis.project(values, coefficients, task);
    made.basis.reconstruct(coefficients, back, task);
    EXPECT_NEAR(back[0].r, 1.0F, 1e-6F);
    EXPECT_NEAR(back[1].r, 5.0F, 1e-5F);
  }
}

TEST(SpectralBasis, SliversAsThinAsFloatsMakeThemHaveABasis) {
  SceneBuilder builder;
  builder.object(
      "slivers", builder.diffuse("white", Rgb(0.5F)),
      {{0.5F, 0.5F, 0.5F}, {0.6F, 0.5F, 0.5F}, {0.7F, 0.5F, 0.5F}, {0.6F, 0.5F + 1e-7F, 0.5F}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      {{0, 2, 3, 3}, {0, 1, 2, 2}, {4, 5, 6, 6}});
  for (const Laplacian kind : kinds) {
    const Based based(builder.build("slivers"), 1500, 200, 256, kind);
    EXPECT_TRUE(based.made.failure.empty()) << based.made.failure;
  }
}

TEST(SurfaceGraph, AWallThatStandsOnAFloorPartsIt) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {2, 0, 1}, {2, 0, 0}}});
  builder.quad("wall", white, {{{1.01F, 0, 0}, {1.01F, 1, 0}, {1.01F, 1, 1}, {1.01F, 0, 1}}}, true);
  const Based based(builder.build("parted floor"), 800, 100000, 10, Laplacian::cotan);
  for (std::size_t p = 0; p < based.partition.parts(); ++p) {
    bool left = false, right = false;
    for (std::uint32_t i = based.partition.part_begin[p]; i < based.partition.part_begin[p + 1]; ++i) {
      const MeshVertex& vertex = based.mesh.vertices()[based.partition.order[i]];
      if (vertex.object == 0) (vertex.position.x < 1.01F ? left : right) = true;
    }
    EXPECT_FALSE(left && right);
  }
}

}  // namespace
}  // namespace gibench::test
