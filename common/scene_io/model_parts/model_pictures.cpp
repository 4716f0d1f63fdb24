#include "common/scene_io/model_parts/model_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

}  // namespace

void PictureUse::add(const UvTriangle& triangle, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  triangles.push_back(triangle);
  areas.push_back(0.5 * glm::length(glm::cross(b - a, c - a)));
}

PictureTexels read_picture_beside(const fs::path& folder, const std::string& name) {
  std::string relative = name;
  std::replace(relative.begin(), relative.end(), '\\', '/');
  fs::path file = folder / relative;
  std::error_code ignored;  // of a name that no file can have
  if (!fs::is_regular_file(file, ignored)) file = folder / fs::path(relative).filename();
  if (!fs::is_regular_file(file, ignored)) throw InputError((folder / relative).string(), "does not exist");
  return read_texels(file);
}

ModelPictures::ModelPictures(fs::path folder)
    : reader_([beside = std::move(folder)](const std::string& name) { return read_picture_beside(beside, name); }) {}

const TexelSums& ModelPictures::sums(const std::string& name) {
  if (!last_ || name != last_name_) {
    last_.reset();
    last_.emplace(reader_(name));
    last_name_ = name;
  }
  return *last_;
}

std::optional<Rgb> ModelPictures::mean(const std::string& name, const PictureUse& use, PictureWrap wrap,
                                       MaterialRemarks& remarks) {
  try {
    const TexelSums& picture = sums(name);
    const bool is_used = !use.triangles.empty();
    const PictureMean mean = is_used ? mean_over_triangles(picture, use.triangles, use.areas, wrap) : mean_of_picture(picture);
    remarks.add("the picture " + in_quotes(name) + " is replaced by its mean" +
                (is_used ? "" : ", that of the whole, because the surface has no texture points"));
    for (const std::string& remark : picture.picture().remarks) remarks.add("the picture " + in_quotes(name) + ": " + remark);
    constexpr double opaque = 0.999;  // an edge of single texels is no hole
    if (mean.opacity < opaque)
      remarks.add(
          fmt::format("the picture leaves {:.2g} of the surface transparent, which is taken for opaque", 1.0 - mean.opacity));
    return mean.colour;
  } catch (const InputError& error) {
    remarks.add("a picture is not used (" + std::string(error.what()) + ")");
    return std::nullopt;
  }
}

}  // namespace gibench
