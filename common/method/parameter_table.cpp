#include "common/method/parameter_table.h"

#include <array>
#include <charconv>

namespace gibench {

double as_written(float value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = 0.0;
  std::from_chars(text.data(), end, number);
  return number;
}

}  // namespace gibench
