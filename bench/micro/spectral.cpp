/// The spectral mesh basis: its precomputation beside bare rays, its relit frame, its sparse product beside Eigen's.
#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "bench/micro/interleaved.h"
#include "bench/micro/method_timing.h"
#include "common/core/data_folder.h"
#include "common/core/error.h"
#include "common/core/random.h"
#include "common/scene_io/load.h"
#include "methods/spectral/relighting.h"
#include "methods/spectral/transfer_making.h"
#include "methods/spectral/transfer_rows.h"
#include "methods/spectral/vertex_light.h"

namespace gibench::micro {
namespace {

using namespace spectral;
using Settings = std::vector<std::pair<std::string, std::string>>;

Scene window_room() { return load_scene(data_folder() / "scenes" / "window-room.scene.json"); }

constexpr const char* wanted_vertices = "23500";  // gives 31 000

spectral::Settings settings(const Settings& chosen) { return settings_from(Parameters(settings_schema(), chosen)); }

double wall_seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Rays, basis and rounding of a coarse mesh with the paper's 16 384 rays per vertex, beside Embree alone on as many rays of the
/// same kind: as many from each point, in no order.
void precomputation(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(0));
  const World world(window_room(), threads);
  const BareEmbree bare(world.scene());
  const std::vector<Ray> gathers = cosine_rays(world, {.count = 1U << 19, .rays_per_point = 1U << 14});
  const std::vector<Ray> segments = cosine_rays(world, {.count = 1U << 16, .length = 0.3F, .seed = 2});
  time_against_bare(state, bare, gathers, segments, threads, [&] {
    Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
    const double start = process_seconds();
    const TransferMaking made =
        make_transfer(world, settings({{"vertices", "600"}, {"rays", "16384"}, {"basis_functions", "128"}}), {}, task);
    const double seconds = process_seconds() - start;
    GIBENCH_CHECK(succeeded(made.termination), "it was not made");
    return Work{seconds, task.counters()};
  });
}
BENCHMARK(precomputation)->Arg(1)->Arg(2)->ArgName("threads")->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(2);

/// The rows alone, of some of the window room's vertices at the mesh and basis of full size, rays per vertex as given.
void transfer_rows(benchmark::State& state) {
  constexpr std::size_t blocks = 12, block_rows = 8;  // next to one another in a block, as the precomputation takes them
  const auto rays = static_cast<int>(state.range(0)), threads = static_cast<int>(state.range(1));
  static const World world(window_room());
  static const BareEmbree bare(world.scene());
  static Task making;
  static const TransferMaking made =
      make_transfer(world, settings({{"vertices", wanted_vertices}, {"rays", "1"}, {"compression_error", "0"}}), {}, making);
  const std::vector<Ray> gathers = cosine_rays(world, {.count = 1U << 19, .rays_per_point = static_cast<std::size_t>(rays)});
  const std::vector<Ray> segments = cosine_rays(world, {.count = 1U << 16, .length = 0.3F, .seed = 2});
  const Transfer& transfer = made.transfer;
  const VertexRays traced = rays_of(world, transfer, rays, 1);
  time_against_bare(state, bare, gathers, segments, threads, [&] {
    Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
    const double start = process_seconds();
    task.parallel_chunks(blocks * block_rows, block_rows, [&](const ChunkRange& range) {
      RayStream stream = task.rays(world);
      TransferRows rows(transfer.basis, traced);
      std::vector<float> row(block_rows * transfer.basis.columns());
      const std::size_t first = range.chunk * transfer.basis.slots() / blocks;
      rows.irradiance(std::span(transfer.node_of_slot).subspan(first, block_rows), stream, row);
      benchmark::DoNotOptimize(row.data());
    });
    return Work{process_seconds() - start, task.counters()};
  });
}
BENCHMARK(transfer_rows)
    ->ArgsProduct({{1024, 16384}, {1, 2}})
    ->ArgNames({"rays", "threads"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(5);

TransferWish wish_of(const World& world) {
  TransferWish wish;
  for (std::uint32_t object = 0; object < world.scene().objects.size(); ++object)
    wish.reflectance.emplace_back(world.scene().material_of_object(object).diffuse / pi);
  return wish;
}

/// The indirect light of the window room under its sky, all bounces, one value per slot.
std::vector<Rgb4> relit_room(const World& world, const Transfer& transfer, Task& task) {
  const DirectLight light(world, Lighting::of(world.scene()));
  const std::vector<Rgb4> direct = direct_irradiance(world, transfer, light, settings({{"direct_samples", "64"}}), task);
  std::vector<Rgb4> reflectance;
  for (const std::uint32_t node : transfer.node_of_slot)
    reflectance.emplace_back(world.scene().material_of_object(transfer.nodes[node].object).diffuse / pi);
  return relight(transfer, direct, reflectance, {}, task).irradiance;
}

/// Mean square of (x − A)(x − B) over that of A·B: the squared relative error of x against the truth behind A and B.
double squared_error(const std::vector<Rgb4>& x, const std::vector<Rgb4>& a, const std::vector<Rgb4>& b) {
  double squares = 0.0, errors = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    squares += static_cast<double>(a[i].g) * static_cast<double>(b[i].g);
    errors += static_cast<double>(x[i].g - a[i].g) * static_cast<double>(x[i].g - b[i].g);
  }
  return errors / squares;
}

/// What compression leaves of the matrix, and what it adds to the error of the room's indirect light, all bounces (root mean
/// square over vertices; in quadrature), beside the error that the rays alone make and the seconds on all threads that the whole
/// of mesh, basis and compressed matrix takes. Arguments: thousandths that it may add, rays per vertex.
void compression(benchmark::State& state) {
  const World world(window_room());
  const std::string rays = std::to_string(state.range(1)), error = std::to_string(1e-3 * static_cast<double>(state.range(0)));
  const auto transfer_with = [&](const std::string& compression_error, std::uint64_t seed) {
    Task task({.seed = seed, .threads = 0, .cancel = {}, .on_progress = {}});
    TransferMaking made =
        make_transfer(world, settings({{"vertices", wanted_vertices}, {"rays", rays}, {"compression_error", compression_error}}),
                      wish_of(world), task);
    GIBENCH_CHECK(succeeded(made.termination), "it was not made");
    return std::move(made.transfer);
  };
  Task task;
  for (auto _ : state) {
    const std::vector<Rgb4> first = relit_room(world, transfer_with("0", 2), task),
                            second = relit_room(world, transfer_with("0", 3), task);
    const std::vector<Rgb4> whole = relit_room(world, transfer_with("0", 1), task);
    const auto start = std::chrono::steady_clock::now();
    const Transfer rounded = transfer_with(error, 1);
    state.counters["seconds_to_prepare"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double of_rays = squared_error(whole, first, second),
                 of_both = squared_error(relit_room(world, rounded, task), first, second);
    state.counters["error_of_rays"] = std::sqrt(std::max(0.0, of_rays));
    state.counters["added_error"] = std::sqrt(std::max(0.0, of_both - of_rays));
    state.counters["coefficients_per_vertex"] =
        static_cast<double>(rounded.one_bounce.coefficients()) / static_cast<double>(whole.size());
    state.counters["matrix_bytes"] = static_cast<double>(rounded.one_bounce.bytes());
    state.counters["basis_bytes"] = static_cast<double>(rounded.basis.bytes());
  }
}
BENCHMARK(compression)
    ->ArgsProduct({{10, 20, 40}, {1024}})
    ->ArgsProduct({{20}, {256, 4096}})
    ->ArgNames({"thousandths", "rays"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

/// The window room with 30 000 vertices and 1024 functions; few rays, which the product's shape hardly depends on.
struct Room {
  World world{window_room()};
  Task task;
  TransferMaking made;
  std::vector<Rgb4> direct, reflectance, light;

  /// `thousandths`: that compression may add.
  explicit Room(std::int64_t thousandths)
      : made(make_transfer(world,
                           settings({{"vertices", wanted_vertices},
                                     {"rays", "1024"},
                                     {"compression_error", std::to_string(1e-3 * static_cast<double>(thousandths))}}),
                           wish_of(world), task)) {
    GIBENCH_CHECK(succeeded(made.termination), "it was not made");
    RandomStream random(1, 2, 3);
    for (std::uint32_t slot = 0; slot < made.transfer.basis.slots(); ++slot) {
      direct.emplace_back(Rgb(random.next_float(), random.next_float(), random.next_float()));
      reflectance.emplace_back(Rgb(0.25F, 0.2F, 0.15F));
    }
    for (std::uint32_t c = 0; c < made.transfer.basis.columns(); ++c) light.emplace_back(Rgb(random.next_float()));
  }
  const TransferMatrix& matrix() const { return made.transfer.one_bounce; }
};
const Room& room(std::int64_t thousandths) {
  static std::map<std::int64_t, Room> rooms;
  return rooms.try_emplace(thousandths, thousandths).first->second;
}

void count_room(benchmark::State& state, const Room& room) {
  state.counters["vertices"] = static_cast<double>(room.direct.size());
  state.counters["functions"] = static_cast<double>(room.made.transfer.basis.columns());
  state.counters["coefficients_per_vertex"] =
      static_cast<double>(room.matrix().coefficients()) / static_cast<double>(room.direct.size());
  state.counters["matrix_bytes"] = static_cast<double>(room.matrix().bytes());
}

/// Project, bounce three times, reconstruct at all vertices. `bytes_per_second`: matrix and basis, read once per bounce.
void relit_frame(benchmark::State& state) {
  const Room& made = room(state.range(0));
  Task task({.seed = 1, .threads = static_cast<int>(state.range(1)), .cancel = {}, .on_progress = {}});
  constexpr int bounces = 3;
  for (auto _ : state) {
    const Relit relit =
        relight(made.made.transfer, made.direct, made.reflectance, {.planned = bounces, .most = bounces, .residual = 1e-9}, task);
    benchmark::DoNotOptimize(relit.irradiance.data());
  }
  const auto bytes = static_cast<std::int64_t>(made.matrix().bytes() + made.made.transfer.basis.bytes());
  state.SetBytesProcessed(bounces * bytes * static_cast<std::int64_t>(state.iterations()));
  state.counters["frames_per_second"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  count_room(state, made);
}
BENCHMARK(relit_frame)
    ->ArgsProduct({{10, 20}, {1, 2}})
    ->ArgNames({"thousandths", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The projection alone. `bytes_per_second`: the basis, read once.
void projection(benchmark::State& state) {
  const Room& made = room(20);
  Task task({.seed = 1, .threads = static_cast<int>(state.range(0)), .cancel = {}, .on_progress = {}});
  const SpectralBasis& basis = made.made.transfer.basis;
  std::vector<Rgb4> light(basis.columns()), indirect(basis.slots());
  for (auto _ : state) {
    basis.project_reflected(made.reflectance, made.direct, indirect, light, task);
    benchmark::DoNotOptimize(light.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(basis.bytes()) * static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(projection)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(benchmark::kMillisecond);

/// The product alone and Eigen's of the same matrix in 32-bit floats, in turn, each on one thread; and a copy of as many bytes.
void product_over_eigen(benchmark::State& state) {
  const Room& made = room(state.range(0));
  const TransferMatrix& matrix = made.matrix();
  const auto rows = static_cast<Eigen::Index>(matrix.rows()), columns = static_cast<Eigen::Index>(matrix.columns());
  Eigen::SparseMatrix<float, Eigen::RowMajor> sparse(rows, columns);
  std::vector<Eigen::Triplet<float>> entries;
  std::vector<double> dense(matrix.columns());
  for (Eigen::Index r = 0; r < rows; ++r) {
    std::fill(dense.begin(), dense.end(), 0.0);
    matrix.add_row_to(static_cast<std::size_t>(r), 1.0F, dense);
    for (Eigen::Index c = 0; c < columns; ++c)
      if (const double value = dense[static_cast<std::size_t>(c)]; value != 0.0)
        entries.emplace_back(r, c, static_cast<float>(value));
  }
  sparse.setFromTriplets(entries.begin(), entries.end());
  sparse.makeCompressed();
  Eigen::Matrix<float, Eigen::Dynamic, 3> light(columns, 3), answer(rows, 3);
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> light_by_row, answer_by_row(rows, 3);
  for (Eigen::Index c = 0; c < columns; ++c) {
    const Rgb value = made.light[static_cast<std::size_t>(c)];
    light.row(c) << value.r, value.g, value.b;
  }
  light_by_row = light;
  std::vector<Rgb4> out(matrix.rows());
  std::vector<unsigned char> from(matrix.bytes(), 1), to(matrix.bytes(), 0);
  Task task({.seed = 1, .threads = 1, .cancel = {}, .on_progress = {}});
  const auto timed = [](const auto& work) {
    const double start = wall_seconds();
    work();
    benchmark::ClobberMemory();
    return wall_seconds() - start;
  };
  std::vector<double> ratios, by_row_ratios, seconds, copies;
  for (auto _ : state) {
    const double own = timed([&] { matrix.multiply(made.light, out, task); });
    const double eigen = timed([&] { answer.noalias() = sparse * light; });
    const double by_row = timed([&] { answer_by_row.noalias() = sparse * light_by_row; });
    const double again = timed([&] { matrix.multiply(made.light, out, task); });
    copies.push_back(timed([&] { std::memcpy(to.data(), from.data(), from.size()); }));
    seconds.push_back(0.5 * (own + again));
    ratios.push_back(eigen / seconds.back());
    by_row_ratios.push_back(by_row / seconds.back());
    state.SetIterationTime(seconds.back());
  }
  for (Eigen::Index r = 0; r < rows; r += 97)
    if (std::fabs(out[static_cast<std::size_t>(r)].r - answer(r, 0)) > 1e-3F * std::fabs(answer(r, 0)) + 1e-3F)
      state.SkipWithError("the products differ");
  state.counters["eigen_over_own"] = median(ratios);
  state.counters["eigen_by_row_over_own"] = median(by_row_ratios);
  state.counters["bytes_per_second"] = static_cast<double>(matrix.bytes()) / median(seconds);
  state.counters["copied_bytes_per_second"] = 2.0 * static_cast<double>(matrix.bytes()) / median(copies);
  count_room(state, made);
}
BENCHMARK(product_over_eigen)->Arg(10)->Arg(20)->ArgName("thousandths")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gibench::micro
