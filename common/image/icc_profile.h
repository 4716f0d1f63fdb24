/// ICC profiles that pictures carry. They are not applied: it is said which one that is.
#pragma once

#include <string>
#include <string_view>

namespace gibench {

/// The description that a profile gives of itself (ICC.1:2010, 9.2.41); empty where it cannot be read.
std::string description_of_profile(std::string_view profile);

}  // namespace gibench
