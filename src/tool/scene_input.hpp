#pragma once

#include <string>

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace tool {

/// Reads a scene file; "-" is standard input.
carom::Result<carom::Scene> read_scene_file(const std::string& path);

/// A file's name for messages.
std::string shown_name(const std::string& path);

/// Prints errors of a file to standard error and returns wrong_input.
int report(const carom::Errors& errors, const std::string& path);

}  // namespace tool
