#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "carom/world.hpp"
#include "require.hpp"

// A scene that is read is written, read as the same, written as the same bytes; and it can be
// played.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto scene = carom::read_scene({reinterpret_cast<const char*>(data), size});
  if (!scene) {
    fuzz::require(!scene.errors().empty(), "a refusal says why");
    for (const carom::Error& error : scene.errors()) carom::to_string(error);
    return 0;
  }
  const std::string written = carom::write_scene(scene.value());
  const auto again = carom::read_scene(written);
  fuzz::require(again.ok(), "what is written is read");
  fuzz::require(again.value() == scene.value(), "it is the same scene");
  fuzz::require(carom::write_scene(again.value()) == written, "it is written as the same bytes");

  auto world = carom::World::create(scene.value());
  fuzz::require(world.ok(), "a scene that is read can be played");
  if (world.value().size() > 100) return 0;
  std::string line;
  for (int step = 0; step < 10; ++step)
    carom::append_trace_line(line, world.value(), world.value().step());
  return 0;
}
