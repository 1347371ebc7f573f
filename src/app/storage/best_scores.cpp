#include "app/storage/best_scores.hpp"

#include <algorithm>

#include "json/limits.hpp"
#include "replay/replay.hpp"

namespace app {
namespace {

using Json = nlohmann::json;

const std::string file = "scores.json";
constexpr const char* version_key = "angry-balls-scores";
constexpr int version = 1;
/// More levels than anybody wins; their file is a tenth of what a store reads.
constexpr std::size_t most_scores = 30'000;

bool is_identity(const std::string& text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// The integer, if it is one from 0 to the greatest score.
std::optional<std::int64_t> whole_number(const Json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > std::uint64_t{replay::max_score}) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

}  // namespace

BestScores::BestScores(Store& store) : store_(store) {
  const auto lock = store_.lock();
  // The file set aside may hold scores of value: they are written anew.
  if (merge_stored() && trouble_ == Trouble::set_aside && !best_.empty()) save();
}

std::optional<std::int64_t> BestScores::of(const std::string& identity) const {
  const auto found = best_.find(identity);
  return found == best_.end() ? std::nullopt : std::optional(found->second);
}

bool BestScores::record(const std::string& identity, std::int64_t score) {
  score = std::clamp(score, std::int64_t{0}, replay::max_score);
  if (const auto best = of(identity); best && score <= *best) return false;
  best_[identity] = score;
  const auto lock = store_.lock();
  // Another window may have saved since: the better of both stays.
  if (!lock)
    trouble_ = Trouble::not_kept;
  else if (merge_stored())
    save();
  return true;
}

void BestScores::save() {
  // Nothing is written that could not be read back.
  if (best_.size() > most_scores || !store_.save(file, text_of(best_)))
    trouble_ = Trouble::not_kept;
  else if (trouble_ == Trouble::not_kept)
    trouble_ = Trouble::none;
}

/// False when what is stored can be neither read nor moved away: nothing may be saved over it.
bool BestScores::merge_stored() {
  const auto stored = store_.load(file);
  bool usable = stored.ok();
  if (usable && stored.value()) {
    const Parsed parsed = parse(*stored.value());
    for (const auto& [identity, score] : parsed.scores) {
      const auto mine = best_.try_emplace(identity, score).first;
      mine->second = std::max(mine->second, score);
    }
    if (!parsed.whole) {
      usable = store_.set_aside(file).ok();
      trouble_ = Trouble::set_aside;
    }
  }
  if (!usable) trouble_ = Trouble::not_kept;
  return usable;
}

/// A wrong entry costs no other. Of another version nothing is taken.
BestScores::Parsed BestScores::parse(const std::string& text) {
  const Json whole = json::parse(text, {.depth = 2, .values = 3 * most_scores});
  if (!whole.is_object() || !whole.contains(version_key) ||
      whole_number(whole[version_key]) != version || !whole.contains("best") ||
      !whole["best"].is_object())
    return {};
  Parsed parsed{{}, whole.size() == 2};
  for (const auto& [identity, value] : whole["best"].items()) {
    const auto score = whole_number(value);
    if (score && is_identity(identity))
      parsed.scores[identity] = *score;
    else
      parsed.whole = false;
  }
  return parsed;
}

std::string BestScores::text_of(const Scores& scores) {
  return Json{{version_key, version}, {"best", scores}}.dump(2) + '\n';
}

}  // namespace app
