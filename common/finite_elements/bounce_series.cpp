#include "common/finite_elements/bounce_series.h"

#include <fmt/format.h>

#include <cmath>

namespace gibench {

double progress_of(double residual, double wanted) {
  const double fallen = residual > 0.0 ? std::log(std::min(1.0, residual)) / std::log(wanted) : 1.0;
  return std::clamp(fallen, 0.0, 1.0);
}

void BounceSeries::add(double ratio, double residual) {
  add();
  ratio_ = ratio;
  residual_ = residual;
  settled_ = residual < bound_.residual;
}

double BounceSeries::progress() const {
  return std::clamp(std::max(static_cast<double>(bounces_) / last(), progress_of(residual_, bound_.residual)), 0.0, 1.0);
}

std::string BounceSeries::message() const {
  if (settled_) return {};
  if (bound_.planned && *bound_.planned <= bound_.most) return fmt::format("all {} bounces of the plan computed", last());
  if (!succeeded()) return fmt::format("the bounces do not fade (ratio {:.6f}): the scene absorbs no light", ratio_);
  return fmt::format("{} bounces computed, relative residual {:.2e}; raise the parameter bounces", bounces_, residual_);
}

}  // namespace gibench
