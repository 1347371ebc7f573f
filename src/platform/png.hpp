#pragma once

#include <filesystem>

#include "app/graphics/raster.hpp"
#include "carom/result.hpp"

namespace platform {

carom::Status write_png(const std::filesystem::path& path, const app::Image& image);

}  // namespace platform
