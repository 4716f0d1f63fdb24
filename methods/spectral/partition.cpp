#include "methods/spectral/partition.h"

#include <metis.h>

#include <algorithm>
#include <cmath>

#include "common/core/error.h"

namespace gibench::spectral {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// Numbers the connected pieces of the vertices that share a label; `count` is how many there are.
struct Pieces {
  std::vector<std::uint32_t> of_vertex;
  std::uint32_t count = 0;
};

Pieces connected_pieces(const SurfaceGraph& graph, const std::vector<std::uint32_t>& label) {
  Pieces pieces{std::vector<std::uint32_t>(graph.size(), none)};
  std::vector<std::uint32_t> front;
  for (std::uint32_t start = 0; start < graph.size(); ++start) {
    if (pieces.of_vertex[start] != none) continue;
    pieces.of_vertex[start] = pieces.count;
    front.assign(1, start);
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t other : graph.neighbours(v)) {
        if (pieces.of_vertex[other] != none || label[other] != label[v]) continue;
        pieces.of_vertex[other] = pieces.count;
        front.push_back(other);
      }
    }
    ++pieces.count;
  }
  return pieces;
}

std::vector<std::vector<std::uint32_t>> members_of(const Pieces& pieces) {
  std::vector<std::vector<std::uint32_t>> members(pieces.count);
  for (std::uint32_t v = 0; v < pieces.of_vertex.size(); ++v) members[pieces.of_vertex[v]].push_back(v);
  return members;
}

/// The part (0, 1, …) of every vertex of one connected piece.
std::vector<idx_t> cut_piece(const SurfaceGraph& graph, const std::vector<std::uint32_t>& members, idx_t parts,
                             std::vector<std::uint32_t>& local) {
  for (std::uint32_t i = 0; i < members.size(); ++i) local[members[i]] = i;
  std::vector<idx_t> begin{0}, neighbours;
  for (const std::uint32_t v : members) {
    for (const std::uint32_t other : graph.neighbours(v)) neighbours.push_back(static_cast<idx_t>(local[other]));
    begin.push_back(static_cast<idx_t>(neighbours.size()));
  }
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_CONTIG] = 1;
  std::vector<idx_t> part(members.size(), 0);
  auto vertices = static_cast<idx_t>(members.size());
  idx_t constraints = 1, cut = 0;
  const int status = METIS_PartGraphKway(&vertices, &constraints, begin.data(), neighbours.data(), nullptr, nullptr, nullptr,
                                         &parts, nullptr, nullptr, options.data(), &cut, part.data());
  if (status != METIS_OK) throw WorkError("METIS could not partition the sampling mesh");
  return part;
}

}  // namespace

Partition partition_mesh(const SurfaceGraph& graph, std::uint32_t part_vertices) {
  std::vector<std::uint32_t> label(graph.size(), 0), local(graph.size());
  std::uint32_t labels = 0;
  for (const std::vector<std::uint32_t>& members : members_of(connected_pieces(graph, label))) {
    const auto parts = static_cast<std::uint32_t>(std::lround(static_cast<double>(members.size()) / part_vertices));
    if (parts > 1) {
      const std::vector<idx_t> part = cut_piece(graph, members, static_cast<idx_t>(parts), local);
      for (std::size_t i = 0; i < members.size(); ++i) label[members[i]] = labels + static_cast<std::uint32_t>(part[i]);
    } else {
      for (const std::uint32_t v : members) label[v] = labels;
    }
    labels += std::max(1U, parts);
  }
  Partition partition;
  partition.part_begin.push_back(0);
  for (const std::vector<std::uint32_t>& members : members_of(connected_pieces(graph, label))) {
    partition.order.insert(partition.order.end(), members.begin(), members.end());
    partition.part_begin.push_back(static_cast<std::uint32_t>(partition.order.size()));
  }
  return partition;
}

std::vector<std::uint32_t> share_out(const Partition& partition, std::uint32_t total) {
  std::vector<std::uint32_t> functions;
  const double a_vertex = static_cast<double>(total) / static_cast<double>(std::max<std::size_t>(1, partition.order.size()));
  for (std::size_t part = 0; part < partition.parts(); ++part) {
    const std::uint32_t size = partition.part_size(part);
    const double share = std::round(a_vertex * size);
    functions.push_back(static_cast<std::uint32_t>(std::clamp(share, 1.0, static_cast<double>(size))));
  }
  return functions;
}

}  // namespace gibench::spectral
