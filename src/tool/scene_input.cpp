#include "tool/scene_input.hpp"

#include <cstdio>

#include "carom/display_text.hpp"
#include "carom/scene_file.hpp"
#include "files/files.hpp"
#include "tool/busy.hpp"
#include "tool/exit_status.hpp"

namespace tool {

carom::Result<carom::Scene> read_scene_file(const std::string& path) {
  const Busy busy("reading " + shown_name(path));
  const auto bytes = files::read_text(path);
  if (!bytes) return bytes.errors();
  return carom::read_scene(bytes.value());
}

std::string shown_name(const std::string& path) {
  return path == "-" ? "<standard input>" : carom::display_text(path);
}

int report(const carom::Errors& errors, const std::string& path) {
  for (const carom::Error& error : errors)
    std::fprintf(stderr, "%s\n", carom::to_string(error, shown_name(path)).c_str());
  return wrong_input;
}

int report_output(const carom::Errors& errors, const std::string& path) {
  return report(errors, path == "-" ? "<standard output>" : path);
}

}  // namespace tool
