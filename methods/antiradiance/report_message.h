/// The message of a stage report, put together from several texts.
#pragma once

#include <string>

#include "common/method/stage_report.h"

namespace gibench::antiradiance {

/// Adds a text, with a semicolon before it where there is one already; nothing where it is empty.
inline void add_message(const std::string& text, StageReport& report) {
  if (!report.message.empty() && !text.empty()) report.message += "; ";
  report.message += text;
}

}  // namespace gibench::antiradiance
