#include <SDL.h>
#include <cstdlib>
#include <cstring>
#include <emscripten.h>
#include <memory>
#include <string>
#include <utility>

#include "platform/browser_gamepads.hpp"
#include "platform/browser_store.hpp"
#include "platform/sdl_platform.hpp"

// The page's script (web/page.js) starts this and calls the functions named web_….

// clang-format off
EM_JS(char*, page_language, (), { return allocateUTF8(navigator.language || ""); })
EM_JS(char*, page_address, (), { return allocateUTF8(location.href.split("#")[0]); })
EM_JS(bool, page_reduces_motion, (), {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
})
EM_JS(bool, page_is_touched, (), { return matchMedia("(pointer: coarse)").matches; })
EM_JS(void, page_copy, (const char* text), { Module.copy(UTF8ToString(text)); })
EM_JS(void, page_ask_for_paste, (), { Module.askForPaste(); })
EM_JS(void, page_choose_file, (), { Module.chooseFile(); })
EM_JS(void, page_show_licences, (), { Module.showLicences(); })
EM_JS(char*, page_ask_text, (const char* what, const char* text), {
  const answer = prompt(UTF8ToString(what), UTF8ToString(text));
  return answer === null ? 0 : allocateUTF8(answer);
})
EM_JS(void, page_ready, (), { Module.ready(); })
EM_JS(void, page_give_texts, (), { Module.giveTexts(); })
EM_JS(void, page_fetch_texts, (const char* code), { Module.fetchTexts(UTF8ToString(code)); })
// clang-format on

namespace {

/// The page's clipboard, which cannot be read at once.
class PageClipboard final : public app::Clipboard {
 public:
  std::optional<std::string> text() override {
    if (pasted_) return std::exchange(pasted_, {});
    page_ask_for_paste();
    return std::nullopt;
  }
  bool set_text(const std::string& text) override {
    page_copy(text.c_str());
    return true;  // the page tells the player if it did not work
  }
  void paste(std::string text) { pasted_ = std::move(text); }
  void forget() { pasted_.reset(); }

 private:
  std::optional<std::string> pasted_;
};

/// Takes over a text that an EM_JS function gives.
std::string taken(char* text) {
  const std::unique_ptr<char, decltype(&std::free)> owned(text, std::free);
  return owned.get();
}

void fetch_texts(app::Language language) {
  page_fetch_texts(std::string(app::language_codes[static_cast<std::size_t>(language)]).c_str());
}

std::optional<std::string> ask_text(const std::string& what, const std::string& text) {
  char* const answer = page_ask_text(what.c_str(), text.c_str());
  return answer ? std::optional(taken(answer)) : std::nullopt;
}

// They live as long as the page does.
platform::BrowserStore store;
PageClipboard clipboard;
std::unique_ptr<platform::GameWindow> window;
std::unique_ptr<platform::BrowserGamepads> gamepads;

void frame() {
  gamepads->poll();
  window->iterate();
}

}  // namespace

extern "C" {

/// Memory for the texts below, which free it.
EMSCRIPTEN_KEEPALIVE char* web_allocate(std::size_t size) {
  return static_cast<char*>(std::malloc(size));
}

EMSCRIPTEN_KEEPALIVE void web_open_link(char* text, std::size_t size) {
  if (window) window->app().open_link({text, size});
  std::free(text);
}

/// `text`: the file's name, a zero, and its bytes.
EMSCRIPTEN_KEEPALIVE void web_open_file(char* text, std::size_t size) {
  const std::string name(text, strnlen(text, size));
  const std::size_t begin = std::min(name.size() + 1, size);
  if (window) window->app().open_file(name, std::string(text + begin, size - begin));
  std::free(text);
}

EMSCRIPTEN_KEEPALIVE void web_paste(char* text, std::size_t size) {
  clipboard.paste(std::string(text, size));
  std::free(text);
  if (window) window->app().event(app::KeyPressed{app::Key::paste});
  clipboard.forget();  // where nothing takes it, it is not to come later
}

/// The browser has taken a touch away, which SDL tells as a finger that was lifted: no shot.
EMSCRIPTEN_KEEPALIVE void web_cancel() {
  if (window) window->app().event(app::PointerCancelled{});
}

/// The browser's back button. False where there is nothing in the game to go back to.
EMSCRIPTEN_KEEPALIVE bool web_back() { return window && window->app().back(); }

/// `text`: a language's code, a zero, and its texts.
EMSCRIPTEN_KEEPALIVE void web_texts(char* text, std::size_t size) {
  const std::string code(text, strnlen(text, size));
  const std::size_t begin = std::min(code.size() + 1, size);
  std::string file(text + begin, size - begin);
  std::free(text);
  const app::Language language = app::language_of_locale(code);
  if (window)
    window->app().take_texts(language, std::move(file));
  else
    app::load_texts(language, std::move(file));
}

/// There is nothing to go back to.
EMSCRIPTEN_KEEPALIVE bool web_at_start() { return !window || window->app().screen().is_first(); }

/// Unseen the game stands still; a page that is hidden gets no frames anyway, but not every browser
/// is sure of it.
EMSCRIPTEN_KEEPALIVE void web_shown(bool shown) {
  if (shown)
    emscripten_resume_main_loop();
  else
    emscripten_pause_main_loop();
}

}  // extern "C"

int main() {
  // Keys elsewhere on the page are the browser's: else Tab would go nowhere there.
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  page_give_texts();
  auto opened =
      platform::open_window({.language = {app::language_of_locale(taken(page_language()))},
                             .least_width = 1,  // the page is as large as it is
                             .least_height = 1,
                             .store = store,
                             .clipboard = &clipboard,
                             .levels = app::kept_levels(store),
                             .host = {.link_prefix = taken(page_address()),
                                      .reduced_motion = page_reduces_motion(),
                                      .touch = page_is_touched(),
                                      .can_quit = false,
                                      .choose_file = page_choose_file,
                                      .ask_text = ask_text,
                                      .licences = {},
                                      .show_licences = page_show_licences,
                                      .fetch_texts = fetch_texts}});
  if (!opened) return 1;  // the page says that there is no WebGL
  window = std::move(opened).value();
  page_ready();
  gamepads = std::make_unique<platform::BrowserGamepads>();
  emscripten_set_main_loop(frame, 0, false);
  return 0;
}
