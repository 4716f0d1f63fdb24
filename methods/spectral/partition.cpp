#include "methods/spectral/partition.h"

#include <metis.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/error.h"
#include "common/finite_elements/grouped.h"

namespace gibench::spectral {

namespace {

/// The part (0, 1, …) of every vertex of one connected piece.
std::vector<idx_t> cut_piece(const SurfaceGraph& graph, std::span<const std::uint32_t> members, idx_t parts,
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
  const Pieces whole = connected_pieces(graph, label);
  const Grouped pieces(whole.of_node, whole.count);
  for (std::size_t piece = 0; piece < pieces.groups(); ++piece) {
    const std::span<const std::uint32_t> members = pieces.of(piece);
    const auto parts = static_cast<std::uint32_t>(std::lround(static_cast<double>(members.size()) / part_vertices));
    if (parts > 1) {
      const std::vector<idx_t> part = cut_piece(graph, members, static_cast<idx_t>(parts), local);
      for (std::size_t i = 0; i < members.size(); ++i) label[members[i]] = labels + static_cast<std::uint32_t>(part[i]);
    } else {
      for (const std::uint32_t v : members) label[v] = labels;
    }
    labels += std::max(1U, parts);
  }
  const Pieces cut = connected_pieces(graph, label);
  Grouped parts(cut.of_node, cut.count);
  return {std::move(parts.items), std::move(parts.begin)};
}

namespace {

/// `counted(node)`: whether its part gets functions for it.
template <class Counted>
std::vector<std::uint32_t> share_out_by(const Partition& partition, std::uint32_t total, const Counted& counted) {
  std::vector<std::uint32_t> nodes, functions;
  for (std::size_t part = 0; part < partition.parts(); ++part)
    nodes.push_back(static_cast<std::uint32_t>(std::count_if(partition.order.begin() + partition.part_begin[part],
                                                             partition.order.begin() + partition.part_begin[part + 1], counted)));
  const auto all = std::accumulate(nodes.begin(), nodes.end(), std::size_t{0});
  const double a_node = static_cast<double>(total) / static_cast<double>(std::max<std::size_t>(1, all));
  for (const std::uint32_t own : nodes)
    functions.push_back(
        static_cast<std::uint32_t>(std::clamp(std::round(a_node * own), 1.0, std::max(1.0, static_cast<double>(own)))));
  return functions;
}

}  // namespace

std::vector<std::uint32_t> share_out(const Partition& partition, std::uint32_t total) {
  return share_out_by(partition, total, [](std::uint32_t) { return true; });
}

std::vector<std::uint32_t> share_out(const Partition& partition, std::uint32_t total, const Nodes& nodes) {
  return share_out_by(partition, total, [&](std::uint32_t node) { return nodes[node].reached; });
}

}  // namespace gibench::spectral
