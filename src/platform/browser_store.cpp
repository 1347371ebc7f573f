#include "platform/browser_store.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <emscripten.h>
#include <memory>
#include <optional>

// A script may be refused its storage, and every access then throws. What these give back is to be
// freed.
// clang-format off
// `size` gets the number of bytes: a text may have NUL in it.
EM_JS(char*, browser_store_load, (const char* key, std::int32_t* size), {
  try {
    const text = localStorage.getItem("angry-balls/" + UTF8ToString(key));
    if (text === null) return 0;
    HEAP32[size >> 2] = lengthBytesUTF8(text);
    return allocateUTF8(text);
  } catch (error) {
    return -1;
  }
})
// Empty: it is saved; else why not.
EM_JS(char*, browser_store_save, (const char* key, const char* text, std::int32_t size), {
  try {
    // A copy: what threads share is not decoded.
    const utf8 = new TextDecoder("utf-8", { ignoreBOM: true });
    localStorage.setItem("angry-balls/" + UTF8ToString(key),
      utf8.decode(HEAPU8.slice(text, text + size)));
    return allocateUTF8("");
  } catch (error) {
    return allocateUTF8(String(error.name));
  }
})
EM_JS(int, browser_store_remove, (const char* key), {
  try {
    localStorage.removeItem("angry-balls/" + UTF8ToString(key));
    return 1;
  } catch (error) {
    return 0;
  }
})
// As it is: the text there may not be UTF-8 at all. 0: there is something under the new name.
EM_JS(int, browser_store_move, (const char* from, const char* to), {
  const start = "angry-balls/";
  try {
    const text = localStorage.getItem(start + UTF8ToString(from));
    if (text === null) return 1;
    if (localStorage.getItem(start + UTF8ToString(to)) !== null) return 0;
    localStorage.setItem(start + UTF8ToString(to), text);
    localStorage.removeItem(start + UTF8ToString(from));
    return 1;
  } catch (error) {
    return -1;
  }
})
// A name a line.
EM_JS(char*, browser_store_list, (const char* folder), {
  const start = "angry-balls/" + UTF8ToString(folder);
  try {
    const endings = [".json", ".angry-level", ".angry-replay"];
    const listed = (key) => endings.some((ending) => key.endsWith(ending));
    const names = Object.keys(localStorage).filter(
      (key) => key.startsWith(start) && listed(key) && !key.includes("\n"));
    return allocateUTF8(names.map((key) => key.slice("angry-balls/".length) + "\n").join(""));
  } catch (error) {
    return allocateUTF8("");
  }
})
// clang-format on

namespace platform {
namespace {

struct Free {
  void operator()(char* text) const { std::free(text); }
};
using Text = std::unique_ptr<char, Free>;

carom::Error trouble(const std::string& name, std::string problem) {
  return {.pointer = name, .problem = std::move(problem)};
}

}  // namespace

carom::Result<std::optional<std::string>> BrowserStore::load(const std::string& name) {
  std::int32_t size = 0;
  char* const found = browser_store_load(name.c_str(), &size);
  if (reinterpret_cast<std::intptr_t>(found) == -1)
    return trouble(name, "cannot be read: the browser allows no storage");
  const Text text(found);
  if (!text) return std::optional<std::string>();
  std::string loaded(text.get(), static_cast<std::size_t>(size));
  if (loaded.size() > max_text) return trouble(name, "is larger than 16 MiB");
  return std::optional(std::move(loaded));
}

carom::Status BrowserStore::save(const std::string& name, const std::string& text) {
  const Text problem(
      browser_store_save(name.c_str(), text.data(), static_cast<std::int32_t>(text.size())));
  if (*problem != '\0') return trouble(name, std::string("cannot be kept: ") + problem.get());
  return carom::Done{};
}

carom::Result<bool> BrowserStore::save_new(const std::string& name, const std::string& text) {
  const auto there = load(name);
  if (!there) return there.errors();
  if (there.value()) return false;
  if (const auto saved = save(name, text); !saved) return saved.errors();
  return true;
}

carom::Status BrowserStore::remove(const std::string& name) {
  if (browser_store_remove(name.c_str()) == 0) return trouble(name, "cannot be removed");
  return carom::Done{};
}

carom::Status BrowserStore::set_aside(const std::string& name) {
  std::string aside = name + ".broken";
  for (int i = 2;; ++i) {
    const int moved = browser_store_move(name.c_str(), aside.c_str());
    if (moved > 0) return carom::Done{};
    if (moved < 0) return trouble(name, "cannot be kept under another name");
    aside = name + ".broken-" + std::to_string(i);
  }
}

std::vector<std::string> BrowserStore::list(const std::string& folder) {
  const Text lines(browser_store_list(folder.c_str()));
  std::vector<std::string> names;
  std::string_view rest = lines.get();
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    names.emplace_back(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace platform
