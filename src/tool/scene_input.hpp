#pragma once

#include <string>

#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace tool {

/// Reads a scene file; "-" is standard input.
carom::Result<carom::Scene> read_scene_file(const std::string& path);

/// The name of a file that is read, fit to be printed.
std::string shown_name(const std::string& path);

/// Prints errors of a file that is read to standard error and returns wrong_input.
int report(const carom::Errors& errors, const std::string& path);

/// The same of a file that is written.
int report_output(const carom::Errors& errors, const std::string& path);

}  // namespace tool
