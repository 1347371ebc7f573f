#include "platform/null_platform.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "licences/licences.hpp"
#include "platform/png.hpp"

namespace platform {
namespace {

using std::chrono::nanoseconds;
constexpr nanoseconds frame{16'666'667};

}  // namespace

NullPlatform::NullPlatform(app::StartLanguage language, int width, int height,
                           std::vector<app::Level> levels)
    : NullPlatform(language, width, height, std::move(levels), memory_) {}

NullPlatform::NullPlatform(app::StartLanguage language, int width, int height,
                           std::vector<app::Level> levels, app::Store& store)
    : store_(store),
      app_(language, width, height, store_, clipboard_, std::move(levels),
           {.licences = licences::text}),
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
    } else if (const auto* down = std::get_if<PointerDown>(&line.action)) {
      app_.event(app::PointerMoved{down->at});
      app_.event(app::PointerPressed{down->at});
    } else if (const auto* up = std::get_if<PointerUp>(&line.action)) {
      app_.event(app::PointerMoved{up->at});
      app_.event(app::PointerReleased{up->at});
    } else if (const auto* wheel = std::get_if<Wheel>(&line.action)) {
      app_.event(app::WheelTurned{wheel->notches});
    } else if (const auto* press = std::get_if<Press>(&line.action)) {
      app_.event(press->key);
      app_.event(app::KeyReleased{press->key.key});
    } else if (const auto* hold = std::get_if<Hold>(&line.action)) {
      app_.event(app::KeyPressed{hold->key});
    } else if (const auto* let_go = std::get_if<LetGo>(&line.action)) {
      app_.event(app::KeyReleased{let_go->key});
    } else if (const auto* type = std::get_if<Type>(&line.action)) {
      app_.event(app::TextTyped{type->text});
    } else if (const auto* touch = std::get_if<Touch>(&line.action)) {
      app_.event(touch->finger);
    } else if (const auto* pad = std::get_if<PadPress>(&line.action)) {
      app_.event(app::PadPressed{pad->button});
      app_.event(app::PadReleased{pad->button});
    } else if (const auto* input = std::get_if<PadInput>(&line.action)) {
      app_.event(input->input);
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
  for (; time > nanoseconds{0}; time -= frame) {
    app_.iterate(std::min(time, frame));
    std::ranges::copy(app_.take_sounds(), std::back_inserter(sounds_));
  }
}

void NullPlatform::click(app::Point at, app::PointerButton button) {
  app_.event(app::PointerMoved{at});
  app_.event(app::PointerPressed{at, button});
  app_.event(app::PointerReleased{at, button});
}

app::Image NullPlatform::picture() {
  app::Image image(width_, height_, app::rgb(0x000000));
  const app::DrawList& list = app_.draw();
  rasterize(list, app_.atlas(), image);
  return image;
}

carom::Status NullPlatform::screenshot(const std::filesystem::path& path) {
  return write_png(path, picture());
}

}  // namespace platform
