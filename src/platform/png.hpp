#pragma once

#include <filesystem>
#include <string>

#include "app/graphics/raster.hpp"
#include "carom/result.hpp"
#include "files/output.hpp"

namespace platform {

/// Where a picture is to be written: nowhere yet, a device, a pipe, or in the place of an empty
/// file or of another PNG picture. Any other file is refused, because a script that somebody else
/// wrote must not overwrite what it likes. opened() of it tells.
class PngFile {
 public:
  explicit PngFile(const std::filesystem::path& path);

  carom::Status opened() const;
  carom::Status write(const app::Image& image);

 private:
  carom::Status named(carom::Status status) const;

  std::string path_;
  bool replaces_other_ = false;
  files::Output output_;
};

carom::Status write_png(const std::filesystem::path& path, const app::Image& image);

}  // namespace platform
