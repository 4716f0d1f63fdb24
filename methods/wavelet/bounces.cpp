#include "methods/wavelet/bounces.h"

#include <cmath>
#include <vector>

#include "common/method/series_termination.h"

namespace gibench::wavelet {

namespace {

/// The functions are orthonormal: this is the root of the integral of the square.
double norm(std::span<const Rgb> coefficients) {
  double sum = 0.0;
  for (const Rgb& c : coefficients) sum += static_cast<double>(c.r * c.r + c.g * c.g + c.b * c.b);
  return std::sqrt(sum);
}

/// W, through all surfaces: only the roots' smooth functions have an integral.
double power(const Elements& elements, std::span<const Rgb> irradiance) {
  double sum = 0.0;
  for (const Element& element : elements.elements()) {
    const Node& root = elements.nodes()[element.root];
    sum += static_cast<double>(luminance(irradiance[root.group * child_count]) * std::sqrt(root.area));
  }
  return sum;
}

/// Light that leaves, by the light that arrives.
void reflect(const Elements& elements, std::span<const Rgb> reflectance, std::span<Rgb> light) {
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] *= reflectance[elements.nodes()[elements.groups()[i / child_count].node].element];
}

}  // namespace

IndirectLight bounce(const Elements& elements, const TransportOperator& transport, std::span<const Rgb> direct,
                     std::span<const Rgb> reflectance, const BounceBound& bound, Task& task) {
  IndirectLight light;
  light.irradiance.resize(direct.size());
  Coefficients<Rgb> term(direct.begin(), direct.end()), next(direct.size());
  BounceSeries series(bound);
  double previous = 0.0;
  while (series.goes_on() && !task.cancelled()) {
    reflect(elements, reflectance, term);
    transport.apply(elements, term, next, task);
    term.swap(next);
    for (std::size_t i = 0; i < term.size(); ++i) light.irradiance[i] += term[i];
    const double size = norm(term), whole = norm(light.irradiance);
    const double ratio = previous > 0.0 ? size / previous : fading_ratio;
    previous = size;
    series.add(ratio, whole > 0.0 ? size / whole * ratio / share_lost(ratio) : 0.0);
  }
  light.bounces = series.bounces();
  light.residual = series.residual();
  light.termination = termination_of(series);
  light.message = series.message();
  return light;
}

IndirectLight all_bounces(const Elements& elements, const TransportOperator& transport, const GlobalOperator& global,
                          bool gathered, std::span<const Rgb> direct, std::span<const Rgb> reflectance, Task& task) {
  IndirectLight light;
  light.irradiance.resize(direct.size());
  light.bounces = static_cast<int>(global.powers().size()) + (gathered ? 1 : 0);
  if (!global.empty()) global.apply(elements, direct, light.irradiance, task);
  if (!gathered) return light;
  Coefficients<Rgb> leaving = light.irradiance;
  for (std::size_t i = 0; i < leaving.size(); ++i) leaving[i] += direct[i];
  reflect(elements, reflectance, leaving);
  transport.apply(elements, leaving, light.irradiance, task);
  return light;
}

double lost_to_compression(const Elements& elements, const TransportOperator& transport, const GlobalOperator& global,
                           bool gathered, std::span<const Rgb> reflectance, const BounceBound& bound, Task& task) {
  const std::vector<Rgb> ones(elements.leaves().size(), Rgb(1.0F));
  const Coefficients<Rgb> direct = coefficients_of<Rgb>(elements, ones);
  const double whole = power(elements, bounce(elements, transport, direct, reflectance, bound, task).irradiance);
  const double part = power(elements, all_bounces(elements, transport, global, gathered, direct, reflectance, task).irradiance);
  return whole > 0.0 ? 1.0 - part / whole : 0.0;
}

}  // namespace gibench::wavelet
