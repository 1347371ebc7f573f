#include "search/proof_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "carom/arithmetic.hpp"
#include "json/limits.hpp"

namespace search {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* version_key = "angry-balls-proof";
constexpr int version = 1;
constexpr std::string_view proof_ending = ".proof.json";

/// With three decimals.
double rounded(double rate) { return std::round(rate * 1000) / 1000; }

Json rate_of(const Estimate& rate) {
  return {{"rate", rounded(rate.mean)}, {"low", rounded(rate.low)}, {"high", rounded(rate.high)}};
}

Json games_of(const LevelGames& games) {
  Json written{{"games", games.games}, {"won_in", games.won_in}};
  written.update(rate_of(games.rate()));
  return written;
}

Json document(const Proof& proof) {
  const carom::ExactArithmetic exact;
  Json throws = Json::array();
  for (const ProvenThrow& one : proof.throws)
    throws.push_back(
        {{"angle", one.aim.tenths / 10.0},
         {"speed", one.aim.speed},
         {"margin", {{"degrees", one.margin / 10.0}, {"speed", one.margin * margin_speed}}}});
  Json hands = Json::array();
  for (std::size_t i = 0; i < proof_hands.size(); ++i) {
    Json hand{{"px", static_cast<int>(proof_hands[i])}};
    hand.update(games_of(proof.hands[i]));
    hands.push_back(std::move(hand));
  }
  return {{version_key, version},
          {"level", proof.level},
          {"physics", proof.physics},
          {"rules", proof.rules},
          {"search", proof.search},
          {"seed", proof.seed},
          {"replay", proof.replay},
          {"throws", std::move(throws)},
          {"hands", std::move(hands)},
          {"random", games_of(proof.random)},
          {"difficulty", rate_of(proof.difficulty())},
          {"stars", {{"par", proof.stars.par}, {"gold", proof.stars.gold}}}};
}

/// Reads what is there; what is missing or of another type becomes 0 or empty, and shows when the
/// whole is compared.
class Reader {
 public:
  explicit Reader(const Json& whole) : whole_(whole) {}

  std::uint64_t number(const std::string& pointer) const {
    const Json* found = at(pointer);
    return found != nullptr && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
  }
  int small_number(const std::string& pointer) const {
    const std::uint64_t read = number(pointer);
    return read <= std::uint64_t{std::numeric_limits<int>::max()} ? static_cast<int>(read) : 0;
  }
  std::string text(const std::string& pointer) const {
    const Json* found = at(pointer);
    return found != nullptr && found->is_string() ? found->get<std::string>() : std::string();
  }
  double real(const std::string& pointer) const {
    const Json* found = at(pointer);
    return found != nullptr && found->is_number() ? found->get<double>() : 0;
  }
  std::size_t size(const std::string& pointer) const {
    const Json* found = at(pointer);
    return found != nullptr && found->is_array() ? found->size() : 0;
  }
  LevelGames games(const std::string& pointer) const {
    LevelGames read{.games = number(pointer + "/games")};
    for (std::size_t i = 0; i < size(pointer + "/won_in"); ++i)
      read.won_in.push_back(number(pointer + "/won_in/" + std::to_string(i)));
    return read;
  }

 private:
  const Json* at(const std::string& pointer) const {
    const Json::json_pointer place(pointer);
    return whole_.contains(place) ? &whole_.at(place) : nullptr;
  }

  const Json& whole_;
};

/// The first place where two documents differ.
std::optional<std::string> difference(const Json& a, const Json& b, const std::string& pointer) {
  if (a == b) return std::nullopt;
  if (a.is_object() && b.is_object()) {
    for (const auto& [key, value] : b.items()) {
      if (!a.contains(key)) return pointer + "/" + key;
      if (auto found = difference(a[key], value, pointer + "/" + key)) return found;
    }
    for (const auto& [key, value] : a.items())
      if (!b.contains(key)) return pointer + "/" + key;
  }
  if (a.is_array() && b.is_array() && a.size() == b.size())
    for (std::size_t i = 0; i < a.size(); ++i)
      if (auto found = difference(a[i], b[i], pointer + "/" + std::to_string(i))) return found;
  return pointer;
}

}  // namespace

std::string proof_name(std::string_view level) {
  const std::size_t slash = level.find_last_of('/');
  const std::size_t dot = level.find_last_of('.');
  const bool ends =
      dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash);
  return std::string(ends ? level.substr(0, dot) : level) + std::string(proof_ending);
}

std::string level_name(std::string_view proof) {
  if (!proof.ends_with(proof_ending)) return std::string(proof);
  return std::string(proof.substr(0, proof.size() - proof_ending.size())) + ".json";
}

bool lies_beside_levels(std::string_view name) {
  const std::size_t slash = name.find_last_of('/');
  if (slash != std::string_view::npos) name.remove_prefix(slash + 1);
  return name == "pack.json" || name.ends_with(proof_ending);
}

carom::Result<Proof> read_proof(std::string_view text) {
  const carom::ExactArithmetic exact;
  const Json whole = json::parse<Json>(text, {.depth = 4, .values = 10'000});
  if (!whole.is_object() || !whole.contains(version_key))
    return carom::Error{.problem = "is no proof of a level",
                        .expected = "a JSON object with \"angry-balls-proof\": 1"};
  const Reader read(whole);
  if (read.number("/hands/0/games") > most_proof_games)
    return carom::Error{.pointer = "/hands/0/games",
                        .problem = "is too large",
                        .expected = "at most " + std::to_string(most_proof_games)};
  Proof proof{.level = read.text("/level"),
              .physics = read.small_number("/physics"),
              .rules = read.small_number("/rules"),
              .search = read.small_number("/search"),
              .seed = read.number("/seed"),
              .games = read.number("/hands/0/games"),
              .replay = read.text("/replay")};
  for (std::size_t i = 0; i < read.size("/throws"); ++i) {
    const std::string pointer = "/throws/" + std::to_string(i);
    proof.throws.push_back({.aim = {.tenths = static_cast<int>(std::lround(std::clamp(
                                        10 * read.real(pointer + "/angle"), -1800.0, 1800.0))),
                                    .speed = read.small_number(pointer + "/speed")},
                            .margin = read.small_number(pointer + "/margin/speed") / margin_speed});
  }
  for (std::size_t i = 0; i < proof_hands.size(); ++i)
    proof.hands[i] = read.games("/hands/" + std::to_string(i));
  proof.random = read.games("/random");
  proof.stars = {.par = read.small_number("/stars/par"),
                 .gold = static_cast<std::int64_t>(read.number("/stars/gold"))};
  // Every number that follows from others, every key and every type is as it is written.
  if (const auto wrong = difference(whole, document(proof), ""))
    return carom::Error{.pointer = *wrong,
                        .problem = "is wrong or missing",
                        .expected = "a proof as carom prove writes it"};
  return proof;
}

std::string write_proof(const Proof& proof) { return document(proof).dump(2) + '\n'; }

}  // namespace search
