#pragma once

#include <string>
#include <string_view>

#include "carom/public.hpp"
#include "carom/result.hpp"
#include "carom/scene.hpp"

namespace CAROM_PUBLIC carom {

/// Reads a scene or level in the JSON form of docs/formats.md. Refuses whatever is not
/// exactly that, with every error found, each with line, column and pointer; nothing is half-read.
Result<Scene> read_scene(std::string_view json);

/// Gives errors found in a scene that was read from `json` the line and column of what their
/// pointers name, in the order of the file.
Errors locate(std::string_view json, Errors errors);

/// Writes a sound scene so that read_scene gives it back bit by bit; same scene, same bytes. Ids
/// and accelerations are not part of a file, and a file knows no -0.0: it is read and written as 0.
std::string write_scene(const Scene& scene);

}  // namespace carom
