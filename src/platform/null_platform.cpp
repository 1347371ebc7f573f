#include "platform/null_platform.hpp"

#include <algorithm>
#include <utility>

#include "platform/png.hpp"

namespace platform {
namespace {

using std::chrono::nanoseconds;
constexpr nanoseconds frame{16'666'667};

}  // namespace

NullPlatform::NullPlatform(app::Language language, int width, int height,
                           std::vector<app::Level> levels)
    : NullPlatform(language, width, height, std::move(levels), memory_) {}

NullPlatform::NullPlatform(app::Language language, int width, int height,
                           std::vector<app::Level> levels, app::Store& store)
    : store_(store),
      app_(language, width, height, store_, clipboard_, std::move(levels)),
      width_(width),
      height_(height) {}

carom::Status NullPlatform::run(const Script& script, const Print& print) {
  nanoseconds now{};
  for (const ScriptLine& line : script) {
    pass(line.at - now);
    now = line.at;
    if (const auto* at = std::get_if<Click>(&line.action)) {
      click(at->at, at->button);
    } else if (const auto* move = std::get_if<Move>(&line.action)) {
      app_.event(app::PointerMoved{move->to});
    } else if (const auto* press = std::get_if<Press>(&line.action)) {
      app_.event(app::KeyPressed{press->key});
    } else if (const auto* shot = std::get_if<Screenshot>(&line.action)) {
      if (carom::Status written = screenshot(shot->file); !written) return written;
    } else if (print) {
      print(app_.describe());
    }
    if (app_.quit_requested()) break;
  }
  return carom::Done{};
}

void NullPlatform::pass(nanoseconds time) {
  for (; time > nanoseconds{0}; time -= frame) app_.iterate(std::min(time, frame));
}

void NullPlatform::click(app::Point at, app::PointerButton button) {
  app_.event(app::PointerMoved{at});
  app_.event(app::PointerPressed{at, button});
  app_.event(app::PointerReleased{at, button});
}

Image NullPlatform::picture() {
  const app::DrawList& list = app_.draw();
  return rasterize(list, app_.atlas(), width_, height_);
}

carom::Status NullPlatform::screenshot(const std::filesystem::path& path) {
  return write_png(path, picture());
}

}  // namespace platform
