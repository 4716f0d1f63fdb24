#include "common/image/plugin/png_decoding.h"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstdint>
#include <cstring>

namespace gibench {

namespace {

/// Keeps what a jump over libpng must not lose: setjmp() restores no variable of the function that calls it.
class PngReader {
 public:
  PngReader(std::string_view bytes, std::int64_t most_samples) : rest_(bytes), most_samples_(most_samples) {}
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// Whether all went well; else message() says what did not.
  bool read() {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, failed, ignored);
    if (png_ == nullptr) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): how libpng reports an error
    info_ = png_create_info_struct(png_);
    png_set_read_fn(png_, this, take);
    png_read_info(png_, info_);
    read_pixels();
    return true;
  }

  const std::string& message() const { return message_; }

  void give(DecodedImage& image) const {
    image.width = static_cast<int>(width_);
    image.height = static_cast<int>(height_);
    const bool has_alpha = channels_ % 2 == 0;
    image.channels = channels_ < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
    if (has_alpha) image.channels.emplace_back("A");
    image.integer_samples = true;
    const std::size_t count = std::size_t{width_} * height_ * channels_;
    image.samples.resize(count);
    for (std::size_t i = 0; i < count; ++i) image.samples[i] = sample(i);
    image.colour_profile = profile_;
  }

 private:
  [[noreturn]] static void failed(png_structp png, png_const_charp message) {
    static_cast<PngReader*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  static void ignored(png_structp, png_const_charp) {}

  static void take(png_structp png, png_bytep to, std::size_t count) {
    std::string_view& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest_;
    if (count > rest.size()) png_error(png, "the file is truncated");
    std::memcpy(to, rest.data(), count);
    rest.remove_prefix(count);
  }

  void read_pixels() {
    width_ = png_get_image_width(png_, info_);
    height_ = png_get_image_height(png_, info_);
    png_charp name = nullptr;
    png_bytep profile = nullptr;
    png_uint_32 size = 0;
    int compression = 0;
    if (png_get_iCCP(png_, info_, &name, &compression, &profile, &size) != 0)
      profile_.assign(reinterpret_cast<const char*>(profile), size);
    png_set_expand(png_);  // 8 bits at least, palettes as colours, transparent colours as alpha
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    channels_ = png_get_channels(png_, info_);
    bytes_a_sample_ = png_get_bit_depth(png_, info_) == 16 ? 2 : 1;
    if (std::int64_t{width_} * height_ > most_samples_ / channels_) png_error(png_, "more pixels than a picture has");
    const std::size_t bytes_a_row = png_get_rowbytes(png_, info_);
    pixels_.resize(bytes_a_row * height_);
    rows_.resize(height_);
    for (std::size_t y = 0; y < rows_.size(); ++y) rows_[y] = pixels_.data() + y * bytes_a_row;
    png_read_image(png_, rows_.data());
  }

  float sample(std::size_t i) const {
    if (bytes_a_sample_ == 1) return static_cast<float>(pixels_[i]) / 255.0F;
    std::uint16_t level = 0;
    std::memcpy(&level, pixels_.data() + 2 * i, 2);
    return static_cast<float>(level) / 65535.0F;
  }

  std::string_view rest_;
  std::int64_t most_samples_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string message_ = "libpng cannot start";
  std::uint32_t width_ = 0, height_ = 0;
  unsigned channels_ = 0, bytes_a_sample_ = 1;
  std::string profile_;
  std::vector<png_byte> pixels_;
  std::vector<png_bytep> rows_;
};

}  // namespace

std::string decode_png(std::string_view bytes, std::int64_t most_samples, DecodedImage& image) {
  PngReader reader(bytes, most_samples);
  if (!reader.read()) return reader.message();
  reader.give(image);
  return {};
}

}  // namespace gibench
