#include "app/storage/saved_replays.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

#include "replay/player.hpp"
#include "replay/replay_file.hpp"

namespace app {
namespace {

const std::string folder = "replays/";
const std::string ending = ".angry-replay";
const std::string earlier_ending = ".json";  // of earlier versions, and of files put there by hand
constexpr std::string_view stem = "replay-";
constexpr std::size_t digits = 4;

/// 12 for "replay-0012"; 0 for names of another form.
unsigned number_of(std::string_view name) {
  unsigned number = 0;
  if (!name.starts_with(stem)) return 0;
  name.remove_prefix(stem.size());
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : 0;
}

std::string numbered(unsigned number) {
  std::string text = std::to_string(number);
  text.insert(0, digits - std::min(digits, text.size()), '0');
  return std::string(stem) + text;
}

std::string without_ending(const std::string& file) {
  const std::string& end = file.ends_with(ending) ? ending : earlier_ending;
  return file.substr(folder.size(), file.size() - folder.size() - end.size());
}

}  // namespace

std::vector<std::string> SavedReplays::names() const {
  std::vector<std::string> names;
  for (const std::string& file : store_.list(folder)) {
    if (!file.ends_with(ending) && !file.ends_with(earlier_ending)) continue;
    std::string name = without_ending(file);
    // Two files may differ by their endings only; ".angry-replay" comes first.
    if (std::ranges::find(names, name) != names.end()) name = file.substr(folder.size());
    names.push_back(std::move(name));
  }
  return names;
}

carom::Result<replay::Replay> SavedReplays::load(const std::string& name) const {
  for (const std::string& end : {ending, earlier_ending, std::string()}) {
    const auto stored = store_.load(folder + name + end);
    if (!stored) return stored.errors();
    if (stored.value()) return replay::read_replay(*stored.value());
  }
  return carom::Error{.pointer = name, .problem = carom::MessageCode::is_gone};
}

carom::Result<std::string> SavedReplays::save(const replay::Replay& replay) {
  const auto full = replay.short_hashes ? replay::with_full_hashes(replay)
                                        : carom::Result<replay::Replay>(replay);
  if (!full) return full.errors();
  const std::string text = replay::write_json(full.value());
  if (text.size() > replay::max_bytes)  // it could not be read back
    return carom::Error{
        .problem = {carom::MessageCode::is_larger_than_bytes, {std::to_string(replay::max_bytes)}}};
  unsigned number = 0;
  for (const std::string& name : names()) number = std::max(number, number_of(name));
  // Another window may be quicker and take the name.
  for (int tries = 0; tries < 100; ++tries) {
    const std::string name = numbered(++number);
    const auto saved = store_.save_new(folder + name + ending, text);
    if (!saved) return saved.errors();
    if (saved.value()) return name;
  }
  return carom::Error{.pointer = folder, .problem = "has no free name"};
}

}  // namespace app
