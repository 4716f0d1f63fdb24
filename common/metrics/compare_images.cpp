#include "common/metrics/compare_images.h"

#include "common/core/error.h"
#include "common/image/tone_mapping.h"
#include "common/metrics/automatic_exposure.h"
#include "common/metrics/errors.h"
#include "common/metrics/metric_table.h"

namespace gibench {

namespace {

std::string size_of(const Image& image) { return std::to_string(image.width) + " x " + std::to_string(image.height); }

void check_finite(const Image& image, const std::string& name) {
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (!is_finite(image.pixels[i])) {
      const std::size_t width = static_cast<std::size_t>(image.width);
      throw InputError(name, "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ") is not finite",
                       "give pictures of finite values");
    }
}

void check_comparable(const ImageFile& reference, const std::string& reference_name, const ImageFile& test,
                      const std::string& test_name, const ComparisonOptions& options) {
  if (reference.image.width != test.image.width || reference.image.height != test.image.height)
    throw InputError(
        test_name,
        "is " + size_of(test.image) + " pixels, but the reference " + reference_name + " is " + size_of(reference.image),
        "give two pictures of one size");
  if (reference.high_dynamic_range != test.high_dynamic_range)
    throw InputError(test_name, "one picture holds linear floating-point values and the other sRGB levels",
                     "give two EXR or HDR files, or two PNG or JPEG files");
  if (!reference.high_dynamic_range && options.exposures)
    throw InputError("--exposures", "the pictures hold sRGB levels, which have no exposure",
                     "leave the option out, or give EXR files");
  check_finite(reference.image, reference_name);
  check_finite(test.image, test_name);
}

FlipStatistics flip_of(const ImageFile& reference, const ImageFile& test, const ComparisonOptions& options) {
  const Image &r = reference.image, &x = test.image;
  if (!reference.high_dynamic_range)
    return flip_statistics(flip_map(r.width, r.height, r.pixels, x.pixels, options.pixels_per_degree));
  const ExposureRange range = options.exposures ? *options.exposures : automatic_exposures(r.pixels);
  return flip_statistics(hdr_flip_map(r.width, r.height, r.pixels, x.pixels, range, ToneMapper::aces, options.pixels_per_degree));
}

}  // namespace

ImageComparison compare_images(const ImageFile& reference, const std::string& reference_name, const ImageFile& test,
                               const std::string& test_name, const ComparisonOptions& options) {
  check_comparable(reference, reference_name, test, test_name, options);
  ImageComparison comparison;
  comparison.values = exact_value_errors(test.image.pixels, reference.image.pixels);
  const float exposure = reference.high_dynamic_range ? automatic_exposure(reference.image.pixels).value : 0.0F;
  const std::vector<Rgb> shown = display_values(test.image.pixels, exposure);
  const std::vector<Rgb> shown_reference = display_values(reference.image.pixels, exposure);
  for (const Metric& metric : all_metrics()) {
    const auto* of_pictures = picture_metric(metric);
    if (!of_pictures || !of_pictures->of_displayed) continue;
    if (const auto value = of_pictures->of_displayed(reference.image.width, reference.image.height, shown, shown_reference))
      comparison.values[metric.name] = *value;
  }
  comparison.flip_name = reference.high_dynamic_range ? "hdr_flip" : "flip";
  comparison.flip = flip_of(reference, test, options);
  return comparison;
}

}  // namespace gibench
