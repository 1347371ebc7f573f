#include "app/storage/saved_replays.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "replay/player.hpp"
#include "replay/replay_file.hpp"

namespace app {
namespace {

const std::string folder = "replays/";
const std::string ending = ".json";
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

std::string file_of(const std::string& name) {
  std::string file = folder;
  return file.append(name).append(ending);
}

}  // namespace

std::vector<std::string> SavedReplays::names() const {
  std::vector<std::string> names;
  for (const std::string& file : store_.list(folder))
    names.push_back(file.substr(folder.size(), file.size() - folder.size() - ending.size()));
  return names;
}

carom::Result<replay::Replay> SavedReplays::load(const std::string& name) const {
  const auto stored = store_.load(file_of(name));
  if (!stored) return stored.errors();
  if (!stored.value()) return carom::Error{.pointer = name, .problem = carom::MessageCode::is_gone};
  return replay::read_replay(*stored.value());
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
    const auto saved = store_.save_new(file_of(name), text);
    if (!saved) return saved.errors();
    if (saved.value()) return name;
  }
  return carom::Error{.pointer = folder, .problem = "has no free name"};
}

}  // namespace app
