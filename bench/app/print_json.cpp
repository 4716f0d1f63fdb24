#include "bench/app/print_json.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace gibench {

void print_json(const nlohmann::ordered_json& json) {
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace gibench
