#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "app/storage/store.hpp"

namespace app {

/// The best score of every level won, by the level's identity (level.hpp), kept in a Store.
class BestScores {
 public:
  enum class Trouble : std::uint8_t {
    none,
    set_aside,  ///< what was stored was no list of scores; it is kept under another name
    not_kept,   ///< the store does not work: scores last until the program ends
  };

  /// The store must outlive this.
  explicit BestScores(Store& store);

  std::optional<int> of(const std::string& identity) const;
  /// Takes over and saves a score that is better than the best so far; tells whether it is.
  bool record(const std::string& identity, int score);
  Trouble trouble() const { return trouble_; }

 private:
  using Scores = std::map<std::string, int>;
  static std::optional<Scores> parse(const std::string& text);
  std::string text() const;
  bool merge_stored();

  Store& store_;
  Scores best_;
  Trouble trouble_ = Trouble::none;
};

}  // namespace app
