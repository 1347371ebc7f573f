#include "platform/sdl_platform.hpp"

#include <SDL.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "app/view/icon.hpp"
#include "files/files.hpp"
#include "platform/painter.hpp"
#include "platform/sdl_input.hpp"
#include "platform/speaker.hpp"

namespace platform {
namespace {

using std::chrono::nanoseconds;
using std::chrono::steady_clock;

constexpr int idle_wait_ms = 1000;
/// Without vertical synchronisation, or unseen, a frame is still not drawn more often than this.
constexpr nanoseconds least_frame = std::chrono::milliseconds{4};

/// SDL for as long as it lives.
struct Library {
  Library() {
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    // A finger is a finger, and the mouse no finger.
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
    SDL_SetHint(SDL_HINT_MOUSE_TOUCH_EVENTS, "0");
    // By it a desktop finds the name and the icon: packaging/*.desktop.
    SDL_SetHint(SDL_HINT_APP_NAME, "Angry Balls");
    for (const char* const id : {"SDL_VIDEO_X11_WMCLASS", "SDL_VIDEO_WAYLAND_WMCLASS"})
      SDL_setenv(id, "io.github.angry_balls.angry_balls", 0);
    if (SDL_Init(SDL_INIT_VIDEO) != 0) throw std::runtime_error(SDL_GetError());
    // SDL may settle for a driver that shows nothing: a game that nobody sees.
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    if (!std::getenv("SDL_VIDEODRIVER") && (driver == "dummy" || driver == "offscreen")) {
      SDL_Quit();
      throw std::runtime_error("no video driver found a display");
    }
    // Without gamepads one can still play.
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  ~Library() { SDL_Quit(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// The clipboard of the desktop.
class DesktopClipboard final : public app::Clipboard {
 public:
  std::optional<std::string> text() override {
    const std::unique_ptr<char, decltype(&SDL_free)> text(SDL_GetClipboardText(), SDL_free);
    return text ? text.get() : std::string();
  }
  bool set_text(const std::string& text) override {
    return SDL_SetClipboardText(text.c_str()) == 0;
  }
};

#ifndef __EMSCRIPTEN__
/// Gives the window its icon, for desktops that find none by the desktop file.
void set_icon(SDL_Window* window) {
  app::Image icon = app::draw_icon(64);
  const Owned<SDL_Surface> surface(SDL_CreateRGBSurfaceWithFormatFrom(
      icon.pixels.data(), icon.width, icon.height, 32,
      icon.width * static_cast<int>(sizeof(app::Color)), SDL_PIXELFORMAT_RGBA32));
  if (surface) SDL_SetWindowIcon(window, surface.get());
}
#endif

/// Signs that lie on other keys with every keyboard's layout.
std::optional<app::Key> typed_key(std::string_view typed) {
  if (typed == "+" || typed == "=") return app::Key::plus;
  if (typed == "-") return app::Key::minus;
  if (typed == ".") return app::Key::period;
  return std::nullopt;
}

app::HostEnvironment with_random_numbers(app::HostEnvironment host) {
  host.random = [] {
    std::random_device source;
    return std::uint64_t{source()} << 32U | source();
  };
  return host;
}

class SdlWindow final : public GameWindow {
 public:
  explicit SdlWindow(WindowSetup setup)
      : window_(owned(SDL_CreateWindow("Angry Balls", SDL_WINDOWPOS_CENTERED,
                                       SDL_WINDOWPOS_CENTERED, setup.width, setup.height,
                                       SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI))),
        painter_(window_.get()),
        app_(setup.language, setup.width, setup.height, setup.store,
             setup.clipboard ? *setup.clipboard : desktop_clipboard_, std::move(setup.levels),
             with_random_numbers(std::move(setup.host))) {
#ifndef __EMSCRIPTEN__
    set_icon(window_.get());
#endif
    SDL_SetWindowMinimumSize(window_.get(), setup.least_width, setup.least_height);
    measure();
    app_.name_keys(label_of);
    app_.teach_beginners();
  }

  app::App& app() override {
    stale_ = true;  // whoever asks for it may change what is to be seen
    return app_;
  }

  bool iterate() override {
    const bool idle = !stale_ && !app_.animating();
    for (SDL_Event event; SDL_PollEvent(&event) != 0;) stale_ |= handle(event);
    const auto now = steady_clock::now();
    // Time that passed while nothing moved is not the game's.
    if (idle)
      app_.rest(now - last_);
    else
      app_.iterate(now - last_);
    last_ = now;
    speaker_.play(app_.take_sounds(), app_.volume());
    stale_ |= app_.animating();
    if (stale_ && !closed_) {
      show();
      stale_ = app_.animating();
    }
    return !closed_ && !app_.quit_requested();
  }

  void wait() override {
    if (!stale_ && !app_.animating()) {
      SDL_WaitEventTimeout(nullptr, idle_wait_ms);
      return;
    }
    const auto spent = steady_clock::now() - last_;
    if (spent < least_frame)
      SDL_Delay(static_cast<Uint32>(
          std::chrono::ceil<std::chrono::milliseconds>(least_frame - spent).count()));
  }

 private:
  /// Takes over the window's size in pixels, which may be finer than its points.
  void measure() {
    int points_wide = 1, points_high = 1, width = 1, height = 1;
    SDL_GetWindowSize(window_.get(), &points_wide, &points_high);
    SDL_GetRendererOutputSize(painter_.renderer(), &width, &height);
    if (width <= 0 || height <= 0 || points_wide <= 0 || points_high <= 0) return;  // minimised
    across_ = static_cast<float>(width) / static_cast<float>(points_wide);
    down_ = static_cast<float>(height) / static_cast<float>(points_high);
    app_.event(app::Resized{width, height, across_});
  }

  app::Point pixel(int x, int y) const {
    return {static_cast<float>(x) * across_, static_cast<float>(y) * down_};
  }

  /// True if the picture may have changed.
  bool handle(const SDL_Event& event) {
    switch (event.type) {
      case SDL_QUIT:
        closed_ = true;
        return false;
      case SDL_WINDOWEVENT:
        painter_.frame_lost();
        if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) measure();
        // Time that passed while nobody saw the game is not its own either.
        if (event.window.event == SDL_WINDOWEVENT_SHOWN) last_ = steady_clock::now();
        return true;
      case SDL_DROPFILE:
        return open_dropped(event.drop.file);
      case SDL_RENDER_TARGETS_RESET:
      case SDL_RENDER_DEVICE_RESET:
        painter_.forget();
        return true;
      case SDL_MOUSEMOTION:
        app_.event(app::PointerMoved{pixel(event.motion.x, event.motion.y)});
        return true;
      case SDL_MOUSEBUTTONDOWN:
      case SDL_MOUSEBUTTONUP:
        return handle(event.button);
      case SDL_MOUSEWHEEL:
        app_.event(app::WheelTurned{event.wheel.preciseY});
        return true;
      case SDL_KEYDOWN:
        return handle(event.key);
      case SDL_KEYUP: {
        SDL_Keysym released = event.key.keysym;
        released.mod = KMOD_NONE;  // a key is let go, whatever else is held by now
        if (const auto key = key_of(released)) app_.event(app::KeyReleased{*key});
        return true;
      }
      case SDL_TEXTINPUT: {
        const std::string_view text = event.text.text;
        app_.event(app::TextTyped{event.text.text});
        press(typed_key(text));
        return true;
      }
      case SDL_FINGERDOWN:
        return handle(event.tfinger, app::Finger::Phase::down);
      case SDL_FINGERMOTION:
        return handle(event.tfinger, app::Finger::Phase::moved);
      case SDL_FINGERUP:
        return handle(event.tfinger, app::Finger::Phase::up);
      case SDL_KEYMAPCHANGED:
        return true;
      default: {
        const auto pad = gamepads_.event(event);
        if (pad) app_.event(*pad);
        return pad.has_value();
      }
    }
  }

  bool handle(const SDL_TouchFingerEvent& touch, app::Finger::Phase phase) {
    int width = 1, height = 1;
    SDL_GetRendererOutputSize(painter_.renderer(), &width, &height);
    app_.event(
        app::Finger{touch.fingerId,
                    phase,
                    {touch.x * static_cast<float>(width), touch.y * static_cast<float>(height)}});
    return true;
  }

  bool handle(const SDL_MouseButtonEvent& click) {
    if (click.button != SDL_BUTTON_LEFT && click.button != SDL_BUTTON_RIGHT) return false;
    const auto button =
        click.button == SDL_BUTTON_LEFT ? app::PointerButton::left : app::PointerButton::right;
    const app::Point at = pixel(click.x, click.y);
    if (click.type == SDL_MOUSEBUTTONDOWN)
      app_.event(app::PointerPressed{at, button});
    else
      app_.event(app::PointerReleased{at, button});
    return true;
  }

  bool handle(const SDL_KeyboardEvent& press) {
    if (press.keysym.sym == SDLK_F11 && press.repeat == 0) {
      const bool full = (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
                        SDL_WINDOW_FULLSCREEN_DESKTOP;
      SDL_SetWindowFullscreen(window_.get(), full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
      return true;
    }
    const auto key = key_of(press.keysym);
    // A key held down moves the focus on and changes a throw, and does nothing else again.
    constexpr std::array repeating{app::Key::tab,      app::Key::back_tab, app::Key::left,
                                   app::Key::right,    app::Key::up,       app::Key::down,
                                   app::Key::backspace};
    if (press.repeat != 0 && key && std::ranges::find(repeating, *key) == repeating.end())
      return false;
    return this->press(key, press.keysym.mod);
  }

  bool open_dropped(char* path) {
    const std::filesystem::path file(path);
    SDL_free(path);
    const auto bytes = files::read_text(file, files::max_small_file);
    if (bytes) app_.open_file(file.filename().string(), bytes.value());
    return bytes.ok();
  }

  bool press(std::optional<app::Key> key, int modifiers = KMOD_NONE) {
    if (key)
      app_.event(
          app::KeyPressed{*key, (modifiers & KMOD_SHIFT) != 0, (modifiers & KMOD_CTRL) != 0});
    return key.has_value();
  }

  void show() {
    if ((SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_MINIMIZED) != 0) return;
    const app::DrawList& list = app_.draw();
    if (const std::string title = app_.describe(); title != title_) {
      title_ = title;
      SDL_SetWindowTitle(window_.get(), title_.c_str());
    }
    painter_.show(list, app_.atlas());
  }

  Library sdl_;
  Owned<SDL_Window> window_;
  Painter painter_;
  DesktopClipboard desktop_clipboard_;
  Speaker speaker_;
  Gamepads gamepads_;
  app::App app_;
  steady_clock::time_point last_ = steady_clock::now();
  bool stale_ = true;  ///< the picture shown is not the app's
  std::string title_;
  float across_ = 1;  ///< pixels a point of the window
  float down_ = 1;
  bool closed_ = false;
};

}  // namespace

carom::Result<std::unique_ptr<GameWindow>> open_window(WindowSetup setup) {
  try {
    return std::unique_ptr<GameWindow>(std::make_unique<SdlWindow>(std::move(setup)));
  } catch (const std::runtime_error& error) {
    return carom::Error{.pointer = {}, .problem = error.what()};
  }
}

}  // namespace platform
