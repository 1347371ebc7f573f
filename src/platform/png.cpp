#include "platform/png.hpp"

#include <string>

#include "files/files.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace platform {

carom::Status write_png(const std::filesystem::path& path, const app::Image& image) {
  std::string bytes;
  const auto append = [](void* out, void* data, int size) {
    static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(),
                             image.width * 4) == 0)
    return carom::Error{.pointer = path.string(), .problem = "cannot be encoded", .expected = {}};
  carom::Status written = files::write(path, bytes);
  if (written) return written;
  carom::Errors errors = written.errors();
  for (carom::Error& error : errors) error.pointer = path.string();
  return errors;
}

}  // namespace platform
