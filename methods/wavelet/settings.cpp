#include "methods/wavelet/settings.h"

#include "common/core/error.h"
#include "common/method/parameter_table.h"

namespace gibench::wavelet {

namespace {

const ParameterTable<Settings>& table() {
  static const ParameterTable<Settings> made{
      parameter("leaves", &Settings::leaves, 1, 4e6,
                "leaves wanted in the quadtrees of all elements: an element's depth follows from its size"),
      parameter("cuts", &Settings::cuts,
                "faces are cut where other faces stand on them, so that no leaf lies on both sides of a wall"),
      parameter("exposure_rays", &Settings::exposure_rays, 0, 64,
                "rays from each of a leaf's 16 points; one that meets black backs alone lies inside geometry; 0: none does"),
      parameter("kernel", &Settings::kernel, {{"polygons", KernelForm::polygons}, {"samples", KernelForm::samples}},
                "form factors in closed form times sampled visibility; or samples with 1/r² and the text's oracle on them"),
      parameter("sender_threshold", &Settings::sender_threshold, 0.0, 1.0,
                "a sender is refined while a wavelet on it could have a larger coefficient"),
      parameter("receiver_threshold", &Settings::receiver_threshold, 0.0, 1.0,
                "a receiver is refined while a wavelet on it could have a larger coefficient"),
      parameter("rays", &Settings::rays, 1, 256,
                "rays of a pair of leaves, at least 2 with kernel=samples; up to four times as many of larger nodes"),
      parameter("closure_rays", &Settings::closure_rays, 0, 65536,
                "rays of a leaf that tell whether scene and leaf are closed in, so that it gets exactly what its surroundings "
                "send; 0: none is"),
      parameter("compression", &Settings::compression, 0.0, 1.0, "links without a larger coefficient are left out"),
      parameter("precision", &Settings::precision, {{"16", Precision::bits16}, {"32", Precision::bits32}},
                "bits of a coefficient of the direct operator; 16: in units of 1/32767 of the largest of its row"),
      parameter(
          "memory_budget", &Settings::memory_budget, 1.0, 1e6,
          "MB for the operator while it is made; both thresholds are doubled until it suffices; the global operator has as much"),
      parameter(
          "mode", &Settings::mode, {{"solve", Mode::solve}, {"global", Mode::global}, {"gathered", Mode::gathered}},
          "bounces by the direct operator whenever lights change; all of them in one operator, albedos as prepared; or that, "
          "and then one more gather by the direct operator"),
      parameter(
          "series_threshold", &Settings::series_threshold, 0.0, 1.0,
          "modes global and gathered: links of a power without a larger coefficient are left out, and the series ends with them"),
      parameter("powers", &Settings::powers, 1, 100000, "modes global and gathered: most powers of the direct operator"),
      parameter("bounces", &Settings::bounces, 1, 100000, "most bounces that are computed"),
      parameter("residual", &Settings::residual, 1e-9, 1.0,
                "the bounces end when those left out hold less, share of the solution"),
      parameter("direct_points", &Settings::direct_points, 1, 16, "points of a leaf at which its direct light is taken"),
      parameter("direct_samples", &Settings::direct_samples, 1, 65536, "light samples at such a point"),
  };
  return made;
}

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

std::vector<Preset> presets() {
  return {{"paper",
           "the text's algorithm: samples of the kernel and the oracle on them, no cuts where faces meet, the gathered global "
           "operator",
           {{"kernel", "samples"},
            {"cuts", "false"},
            {"exposure_rays", "0"},
            {"closure_rays", "0"},
            {"receiver_threshold", "0.01"},
            {"sender_threshold", "0.02"},
            {"mode", "gathered"},
            {"series_threshold", "1e-4"}}}};
}

Settings settings_from(const Parameters& parameters) {
  const Settings settings = table().read(parameters);
  if (settings.kernel == KernelForm::samples && settings.rays < 2)
    throw InputError("parameters", "kernel=samples compares samples of a pair, and rays=1 takes a single one",
                     "set rays=2 or more");
  return settings;
}

}  // namespace gibench::wavelet
