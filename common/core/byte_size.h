/// Numbers of bytes as people read them.
#pragma once

#include <string>

namespace gibench {

/// Decimal units, three digits: "512 B", "19.2 MB", "1.50 GB".
std::string byte_size(double bytes);

}  // namespace gibench
