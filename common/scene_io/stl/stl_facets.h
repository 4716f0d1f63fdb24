/// The facets of an STL file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/core/vec.h"
#include "common/scene_io/text/model_place.h"

namespace gibench {

/// One `solid`: its corners, and for each facet the end of its own.
struct StlSolid {
  std::string name;
  std::vector<Vec3d> corners;
  std::vector<std::uint32_t> facet_ends;
};

/// All solids, and what is to be told of the file.
struct StlFacets {
  std::vector<StlSolid> solids;
  std::vector<std::string> warnings;
};

/// Reads the bytes of a file. Refuses one that is cut short, and a wrong number by its line.
StlFacets parse_stl(std::string_view bytes, const ModelPlace& place);

}  // namespace gibench
