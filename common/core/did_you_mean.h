/// The suggestion of a known name that is near to one that is not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gibench {

/// `did you mean "floor"? ` where a known name is near to `unknown`, letter case aside, else nothing.
std::string did_you_mean(std::string_view unknown, const std::vector<std::string>& known);

}  // namespace gibench
