#include "app/storage/best_scores.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace app {
namespace {

using nlohmann::json;

const std::string file = "scores.json";
constexpr const char* version_key = "angry-balls-scores";
constexpr int version = 1;

bool is_identity(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// The integer, if it is one from 0 to the greatest int.
std::optional<int> whole_number(const json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > std::uint64_t{std::numeric_limits<int>::max()}) return std::nullopt;
  return static_cast<int>(number);
}

}  // namespace

BestScores::BestScores(Store& store) : store_(store) { merge_stored(); }

std::optional<int> BestScores::of(const std::string& identity) const {
  const auto found = best_.find(identity);
  return found == best_.end() ? std::nullopt : std::optional(found->second);
}

bool BestScores::record(const std::string& identity, int score) {
  if (const auto best = of(identity); best && score <= *best) return false;
  best_[identity] = score;
  // Another window may have saved since: the better of both stays.
  if (merge_stored()) {
    if (!store_.save(file, text()))
      trouble_ = Trouble::not_kept;
    else if (trouble_ == Trouble::not_kept)
      trouble_ = Trouble::none;
  }
  return true;
}

/// False when what is stored can be neither read nor moved away: nothing may be saved over it.
bool BestScores::merge_stored() {
  const auto stored = store_.load(file);
  bool usable = stored.ok();
  if (usable && stored.value()) {
    if (const auto scores = parse(*stored.value())) {
      for (const auto& [identity, score] : *scores) {
        const auto mine = best_.try_emplace(identity, score).first;
        mine->second = std::max(mine->second, score);
      }
    } else {
      usable = store_.set_aside(file).ok();
      trouble_ = Trouble::set_aside;
    }
  }
  if (!usable) trouble_ = Trouble::not_kept;
  return usable;
}

/// All of it, or nothing if any of it is not as text() writes it.
std::optional<BestScores::Scores> BestScores::parse(const std::string& text) {
  const json whole = json::parse(text, nullptr, false);
  if (!whole.is_object() || whole.size() != 2 || !whole.contains(version_key) ||
      !whole.contains("best") || whole_number(whole[version_key]) != version ||
      !whole["best"].is_object())
    return std::nullopt;
  Scores scores;
  for (const auto& [identity, value] : whole["best"].items()) {
    const auto score = whole_number(value);
    if (!score || !is_identity(identity)) return std::nullopt;
    scores[identity] = *score;
  }
  return scores;
}

std::string BestScores::text() const {
  return json{{version_key, version}, {"best", best_}}.dump(2) + '\n';
}

}  // namespace app
