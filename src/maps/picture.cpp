#include "maps/picture.hpp"

#include <png.h>

#include <stdexcept>

#include "io/atomic_file.hpp"

namespace stillmap {

void Picture::save(const std::string& path) const {
  write_atomically(path, [&](const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width_);
    image.height = static_cast<png_uint_32>(height_);
    image.format = PNG_FORMAT_RGB;
    const int as_they_are = 0;
    if (png_image_write_to_file(&image, file.c_str(), as_they_are, pixels_.data(), 0, nullptr) == 0)
      throw std::runtime_error(path + ": cannot be written: " + image.message);
  });
}

}  // namespace stillmap
