#include "methods/spectral/basis_making.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/core/random.h"
#include "methods/spectral/eigenvectors.h"
#include "methods/spectral/slot_order.h"
#include "methods/spectral/transfer_matrix.h"
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
  Nodes nodes;
  SurfaceGraph graph;
  Partition partition;
  BasisMaking made;

  Based(Scene scene, double vertices, std::uint32_t part_vertices, std::uint32_t functions, Laplacian kind)
      : world(std::move(scene), 1),
        mesh(world, {edge_length_for(world, vertices)}),
        interpolation(world, mesh, 0.0F, task),
        nodes(mesh),
        graph(make_graph(mesh, interpolation, nodes)),
        partition(partition_mesh(graph, part_vertices)),
        made(make_basis(graph, partition, share_out(partition, functions), kind, task)) {}
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
  made::SceneBuilder builder;
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

/// Mean square distance of vertices in one block from its middle, in vertices' areas.
double spread_of_blocks(const SamplingMesh& mesh, const Partition& partition) {
  double sum = 0.0;
  std::size_t counted = 0;
  for (std::size_t part = 0; part < partition.parts(); ++part)
    for (std::size_t begin = (partition.part_begin[part] + block_rows - 1) / block_rows * block_rows;
         begin + block_rows <= partition.part_begin[part + 1]; begin += block_rows) {
      Vec3d middle(0.0);
      const auto position = [&](std::size_t i) { return Vec3d(mesh.vertices()[partition.order[begin + i]].position); };
      for (std::size_t i = 0; i < block_rows; ++i) middle += position(i) / static_cast<double>(block_rows);
      for (std::size_t i = 0; i < block_rows; ++i) {
        const Vec3d off = position(i) - middle;
        sum += glm::dot(off, off) / static_cast<double>(mesh.vertices()[partition.order[begin + i]].area);
        ++counted;
      }
    }
  return sum / static_cast<double>(counted);
}

TEST(SpectralBasis, VerticesOfABlockAreCloseAndStayInTheirPart) {
  const Based based(square(1.0F), 3000, 333, 30, Laplacian::cotan);
  Partition partition = based.partition;
  put_neighbours_together(based.nodes, block_rows, partition);
  for (std::size_t part = 0; part < partition.parts(); ++part) {
    std::vector<std::uint32_t> members(partition.order.begin() + partition.part_begin[part],
                                       partition.order.begin() + partition.part_begin[part + 1]);
    std::sort(members.begin(), members.end());
    EXPECT_TRUE(std::equal(members.begin(), members.end(), based.partition.order.begin() + partition.part_begin[part]));
  }
  // Eight of a square lattice, two by four: (2² − 1)/12 + (4² − 1)/12 = 1.5 of its cells; in rows of the mesh, (8² − 1)/12.
  EXPECT_LT(spread_of_blocks(based.mesh, partition), 2.2);
  EXPECT_GT(spread_of_blocks(based.mesh, based.partition), 4.0);
}

TEST(SpectralBasis, OrderOfVerticesInAPartMovesTheFunctionsWithThem) {
  Based based(closed_room(), 900, 200, 60, Laplacian::cotan);
  Partition partition = based.partition;
  put_neighbours_together(based.nodes, block_rows, partition);
  ASSERT_NE(partition.order, based.partition.order);
  const BasisMaking moved = make_basis(based.graph, partition, share_out(partition, 60), Laplacian::cotan, based.task);
  for (std::size_t p = 0; p < partition.parts(); ++p)
    for (std::uint32_t slot = partition.part_begin[p]; slot < partition.part_begin[p + 1]; ++slot) {
      const auto begin = based.partition.order.begin() + partition.part_begin[p];
      const auto found = std::lower_bound(begin, begin + partition.part_size(p), partition.order[slot]);
      const auto before = static_cast<std::uint32_t>(found - based.partition.order.begin());
      const auto expected = based.basis().row(based.basis().parts()[p], before),
                 row = moved.basis.row(moved.basis.parts()[p], slot);
      EXPECT_TRUE(std::equal(row.begin(), row.end(), expected.begin()));
      EXPECT_EQ(moved.basis.weight()[slot], based.basis().weight()[before]);
    }
}

TEST(SpectralBasis, ReflectedLightIsProjectedAsIfItWereStored) {
  Based based(closed_room(), 900, 200, 60, Laplacian::cotan);
  const SpectralBasis& basis = based.basis();
  RandomStream random(1, 2, 3);
  std::vector<Rgb4> reflectance, direct, indirect, leaving;
  for (std::uint32_t slot = 0; slot < basis.slots(); ++slot) {
    for (auto* field : {&reflectance, &direct, &indirect})
      field->emplace_back(Rgb(random.next_float(), random.next_float(), random.next_float()));
    leaving.emplace_back(Rgb(reflectance[slot]) * (Rgb(direct[slot]) + Rgb(indirect[slot])));
  }
  std::vector<Rgb4> stored(basis.columns()), fused(basis.columns());
  basis.project(leaving, stored, based.task);
  basis.project_reflected(reflectance, direct, indirect, fused, based.task);
  for (std::uint32_t c = 0; c < basis.columns(); ++c)
    for (int channel = 0; channel < 3; ++channel) EXPECT_EQ(Rgb(fused[c])[channel], Rgb(stored[c])[channel]);
  // And against the sum written out.
  for (const SpectralBasis::Part& part : basis.parts())
    for (std::uint32_t f = 0; f < part.functions; ++f) {
      double expected = 0.0;
      for (std::uint32_t slot = part.begin; slot < part.end; ++slot)
        expected += static_cast<double>(basis.weight()[slot]) * static_cast<double>(basis.row(part, slot)[f]) *
                    static_cast<double>(leaving[slot].g);
      EXPECT_NEAR(stored[part.column + f].g, expected, 1e-4);
    }
}

TEST(SpectralBasis, CompleteBasisReproducesAnyFunction) {
  for (const Laplacian kind : kinds) {
    Based based(closed_room(), 600, 150, 100000, kind);
    const SpectralBasis& basis = based.basis();
    EXPECT_EQ(basis.columns(), basis.slots());
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
    EXPECT_EQ(basis.columns(), basis.parts().size());
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
  graph.area.assign(70000, 1.0);
  graph.begin.assign(70001, 0);
  Task task;
  const Partition partition = partition_mesh(graph, 100);
  const BasisMaking made = make_basis(graph, partition, share_out(partition, 10), Laplacian::cotan, task);
  EXPECT_NE(made.failure.find("70000 parts"), std::string::npos) << made.failure;
}

TEST(SpectralBasis, PartOfOneVertexHasTheConstant) {
  SurfaceGraph graph;
  graph.area = {1.0, 2.0};
  graph.begin = {0, 0, 0};
  for (const Laplacian kind : kinds) {
    Task task;
    const Partition partition = partition_mesh(graph, 100);
    const BasisMaking made = make_basis(graph, partition, share_out(partition, 100), kind, task);
    ASSERT_TRUE(made.failure.empty()) << made.failure;
    EXPECT_EQ(made.basis.columns(), 2U);  // and no padding
    std::vector<Rgb4> values{Rgb(1.0F), Rgb(5.0F)}, coefficients(made.basis.columns()), back(2);
    made.basis.project(values, coefficients, task);
    made.basis.reconstruct(coefficients, back, task);
    EXPECT_NEAR(back[0].r, 1.0F, 1e-6F);
    EXPECT_NEAR(back[1].r, 5.0F, 1e-5F);
  }
}

TEST(SpectralBasis, SliversAsThinAsFloatsMakeThemHaveABasis) {
  made::SceneBuilder builder;
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
  made::SceneBuilder builder;
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
