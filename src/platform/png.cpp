#include "platform/png.hpp"

#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace platform {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

/// Is true if the file at `path` holds something that is not a PNG picture.
bool holds_other(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) || files::own_descriptor(path)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, signature.size()> bytes{};
  file.read(bytes.data(), bytes.size());
  const auto count = static_cast<std::size_t>(file.gcount());
  // One that cannot be read is somebody's, too.
  const bool empty = std::filesystem::file_size(path, error) == 0 && !error;
  return !empty && std::string_view(bytes.data(), count) != signature;
}

}  // namespace

PngFile::PngFile(const std::filesystem::path& path)
    : path_(path), replaces_other_(holds_other(path_)), output_(path_) {}

carom::Status PngFile::opened() const {
  if (replaces_other_)
    return carom::Error{.pointer = path_,
                        .problem = "is a file that is no PNG picture",
                        .expected = "a new name, or a picture that may be replaced"};
  return named(output_.opened());
}

carom::Status PngFile::write(const app::Image& image) {
  if (carom::Status status = opened(); !status) return status;
  std::string bytes;
  const auto append = [](void* out, void* data, int size) {
    static_cast<std::string*>(out)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.pixels.data(),
                             image.width * 4) == 0)
    return carom::Error{.pointer = path_, .problem = "cannot be encoded", .expected = {}};
  output_.write(bytes);
  return named(output_.commit());
}

carom::Status PngFile::named(carom::Status status) const {
  if (status) return status;
  carom::Errors errors = status.errors();
  for (carom::Error& error : errors) error.pointer = path_;
  return errors;
}

carom::Status write_png(const std::filesystem::path& path, const app::Image& image) {
  return PngFile(path).write(image);
}

}  // namespace platform
