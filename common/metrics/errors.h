/// Errors of a method's values against a reference that is itself uncertain, with intervals. Names carry their
/// constants. The squared error is mean (x−A)(x−B) over the two reference halves, so that the reference's noise
/// does not count against the method; the noise floor is ¼ mean (A−B)².
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/image/exposure.h"
#include "common/metrics/error_value.h"
#include "common/metrics/replicas.h"

namespace gibench {

/// The metrics of linear values (metric_table.h). Channels are averaged. InputError for fewer than two replicates or a value
/// that is not finite. Squared errors are taken over independent parts of the reference and are unbiased, also where the error
/// is smaller than the reference's noise (a negative estimate is given as 0); metrics with weights need three replicates, and
/// what their noise leaves uncertain is in their intervals (weighted_metrics.h); max contains that noise, and the low end of its
/// interval allows for it. Only rmse and max are there where the mean of r is not positive. Intervals cover the reference's noise
/// and the choice of points; with it a method's own noise as far as that is independent between points.
ErrorTable value_errors(std::span<const Rgb> values, const Replicas& reference);

/// The same of a method that was run with several seeds, a vector of values each: the mean over them, squares before roots.
/// Intervals cover the choice of the seed too (seeded_estimate.h).
ErrorTable value_errors(std::span<const std::vector<Rgb>> values, const Replicas& reference);

/// value_errors of the pixels, and the metrics of pictures (picture_errors.h) at the exposure and over its range.
ErrorTable image_errors(int width, int height, std::span<const Rgb> pixels, const Replicas& reference, const Exposure& exposure);
ErrorTable image_errors(int width, int height, std::span<const std::vector<Rgb>> pixels, const Replicas& reference,
                        const Exposure& exposure);

/// The metrics of value_errors against a reference that is taken as exact.
std::map<std::string, double> exact_value_errors(std::span<const Rgb> values, std::span<const Rgb> reference);

}  // namespace gibench
