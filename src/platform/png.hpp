#pragma once

#include <filesystem>

#include "carom/result.hpp"
#include "platform/raster.hpp"

namespace platform {

carom::Status write_png(const std::filesystem::path& path, const Image& image);

}  // namespace platform
