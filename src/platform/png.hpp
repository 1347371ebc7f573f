#pragma once

#include <filesystem>

#include "app/raster.hpp"
#include "carom/result.hpp"

namespace platform {

carom::Status write_png(const std::filesystem::path& path, const app::Image& image);

}  // namespace platform
