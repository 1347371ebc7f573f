#include "tool/scene_input.hpp"

#include <cstdio>
#include <utility>

#include "carom/scene_file.hpp"
#include "files/files.hpp"
#include "tool/exit_status.hpp"

namespace tool {

carom::Result<SceneInput> read_scene_file(const std::string& path) {
  auto bytes = files::read(path);
  if (!bytes) return bytes.errors();
  auto scene = carom::read_scene(bytes.value());
  if (!scene) return scene.errors();
  return SceneInput{std::move(bytes).value(), std::move(scene).value()};
}

std::string shown_name(const std::string& path) { return path == "-" ? "<standard input>" : path; }

int report(const carom::Errors& errors, const std::string& path) {
  for (const carom::Error& error : errors)
    std::fprintf(stderr, "%s\n", carom::to_string(error, shown_name(path)).c_str());
  return wrong_input;
}

}  // namespace tool
