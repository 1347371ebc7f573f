#include "app/storage/alone_best.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace app {
namespace {

using games::billiards::Options;
using games::billiards::Rack;
using nlohmann::json;

const std::string file = "alone.json";
constexpr const char* version_key = "angry-balls-alone";
constexpr int version = 1;
constexpr int most_shots = 1'000'000;

std::string kind_of(const Options& options) {
  return std::string(options.rack == Rack::quick ? "quick" : "classic") +
         (options.touch_red ? "-touch-red" : "");
}

/// None of what is stored is taken if any of it is wrong.
std::optional<std::map<std::string, std::vector<int>>> parse(const std::string& text) {
  const json whole = json::parse(text, nullptr, false);
  if (!whole.is_object() || whole.size() != 2 || !whole.contains(version_key) ||
      whole[version_key] != version || !whole.contains("shots") || !whole["shots"].is_object())
    return std::nullopt;
  std::map<std::string, std::vector<int>> lists;
  for (const auto& [kind, list] : whole["shots"].items()) {
    if (!list.is_array() || list.size() > AloneBest::most) return std::nullopt;
    for (const json& shots : list) {
      if (!shots.is_number_unsigned() || shots.get<std::uint64_t>() > std::uint64_t{most_shots})
        return std::nullopt;
      lists[kind].push_back(shots.get<int>());
    }
    std::ranges::sort(lists[kind]);
  }
  return lists;
}

}  // namespace

/// False when what is stored can be neither read nor moved away: nothing may be saved over it.
bool AloneBest::load() {
  const auto stored = store_.load(file);
  if (!stored.ok()) return false;
  if (!stored.value()) return true;
  if (auto lists = parse(*stored.value())) {
    lists_ = std::move(*lists);
    return true;
  }
  return store_.set_aside(file).ok();
}

const std::vector<int>& AloneBest::of(const Options& options) { return lists_[kind_of(options)]; }

std::size_t AloneBest::record(const Options& options, int shots) {
  const auto lock = store_.lock();
  const bool usable = lock && load();  // another window may have saved since
  std::vector<int>& list = lists_[kind_of(options)];
  const auto at = list.insert(std::ranges::upper_bound(list, shots), std::min(shots, most_shots));
  const auto place = static_cast<std::size_t>(at - list.begin()) + 1;
  if (list.size() > most) list.pop_back();
  if (usable)
    (void)store_.save(file, json{{version_key, version}, {"shots", lists_}}.dump(2) + '\n');
  return place <= most ? place : 0;
}

}  // namespace app
