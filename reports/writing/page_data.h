/// The data files of the page: everything that it shows but the pictures' pixels.
#pragma once

#include <string>
#include <vector>

#include "reports/collect/study.h"
#include "reports/writing/page_images.h"

namespace gibench::report {

/// JavaScript that hands the study to the page: `gibench.study = {…};`, without what depends on the error that is shown.
/// `pictures` has one entry for each scene. `warnings` are what could not be read, a line each.
std::string page_data(const Study& study, const std::vector<std::vector<PagePicture>>& pictures,
                      const std::vector<std::string>& warnings);

/// JavaScript that adds what the page shows of one error: `gibench.study.errors[position] = {…};`. The page loads it when that
/// error is chosen, so that a study of 10 000 runs opens at once.
std::string error_data(const Study& study, const ErrorKey& key, std::size_t position);

/// JavaScript that hands the plot templates (name.vl.json files of a folder) to the page: `gibench.plots = {…};`.
std::string plot_templates(const std::filesystem::path& folder);

}  // namespace gibench::report
