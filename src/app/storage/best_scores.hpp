#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "app/storage/store.hpp"

namespace app {

/// The best score of every level won, by the level's identity (level.hpp), saved in a Store.
class BestScores {
 public:
  enum class Trouble : std::uint8_t {
    none,
    set_aside,  ///< some of what was stored was no score; it is saved under another name
    not_kept,   ///< the store does not work: scores last until the program ends
  };

  /// The store must outlive this.
  explicit BestScores(Store& store);

  std::optional<std::int64_t> of(const std::string& identity) const;
  /// Takes over and saves a score that is better than the best so far; tells whether it is.
  bool record(const std::string& identity, std::int64_t score);
  Trouble trouble() const { return trouble_; }

 private:
  using Scores = std::map<std::string, std::int64_t>;
  /// The scores that a text holds, and whether they are all of it.
  struct Parsed {
    Scores scores;
    bool whole = false;
  };
  static Parsed parse(const std::string& text);
  static std::string text_of(const Scores& scores);
  bool merge_stored();
  void save();

  Store& store_;
  Scores best_;
  Trouble trouble_ = Trouble::none;
};

}  // namespace app
