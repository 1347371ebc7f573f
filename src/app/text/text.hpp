#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "app/text/names.hpp"  // made of the files in po/

/// Every word the player reads.
namespace app {

/// The device of the last input; the mouse goes with the keys.
enum class InputDevice : std::uint8_t { mouse, finger, pad };

inline std::array<Language, language_codes.size()> all_languages() {
  std::array<Language, language_codes.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Language>(i);
  return all;
}
/// "en"
inline std::string_view code_of(Language language) {
  return language_codes[static_cast<std::size_t>(language)];
}
/// As the language says it itself: "Français".
inline std::string_view name_of(Language language) {
  return language_names[static_cast<std::size_t>(language)];
}

/// Of a POSIX locale's name such as "fr_CA.UTF-8", or a browser's such as "fr-CA"; English if there
/// are no texts in that language.
Language language_of_locale(std::string_view locale);

/// Takes the texts of a language from a file that po/compile.py made, in place of those it had.
/// False, and nothing changes, if it was made for another version of the program.
bool load_texts(Language language, std::string file);
/// Is true if there are texts; a language without any is spoken in English.
bool has_texts(Language language);

/// The language of a start.
struct StartLanguage {
  // Implicit: most starts just have one.
  StartLanguage(Language of, bool by_player = false) : language(of), asked(by_player) {}  // NOLINT

  Language language;
  bool asked;  ///< by the player, at this start; otherwise it is the system's
};

/// The texts of one language. Copies speak alike: what is changed in one holds in all of them, so
/// screens keep theirs, and a change of language needs no new screen.
class Words {
 public:
  explicit Words(Language language) : voice_(std::make_shared<Voice>(Voice{language, {}, {}})) {}
  // No moving: there are always words.
  Words(const Words&) = default;
  Words& operator=(const Words&) = default;
  ~Words() = default;

  void speak(Language language) { voice_->language = language; }
  Language language() const { return voice_->language; }
  /// Texts tell what to do by this hand.
  void take_hand(InputDevice hand) { voice_->hand = hand; }
  InputDevice hand() const { return voice_->hand; }
  /// The names for player(); an empty one means "Player 1", "Player 2".
  void name_players(std::array<std::string, 2> names) { voice_->names = std::move(names); }

  /// The text, with {0}, {1}, … replaced by the values given.
  std::string operator()(Text text, std::initializer_list<std::string_view> values = {}) const;
  /// A text with plural forms: the one for `n`, which {0} stands for.
  std::string count(Text text, int n) const;
  /// Thousands set apart as the language does.
  std::string number(std::int64_t value) const;
  /// With one digit behind the point or comma.
  std::string tenths(double value) const;
  /// A shipped level's name in the language; others are left as they are.
  std::string level_name(std::string_view name) const;
  /// A name that anybody may have given, fit to stand among other words and within quotes, which it
  /// cannot end: short, and without what parts the pieces of a line.
  std::string foreign_name(std::string_view name) const;
  /// The name of player 0 or 1: "Player 1" for a person without one, "Computer 4" for a computer.
  std::string player(int player) const;
  /// The same, of a game in which computers of these levels play; 0: a person.
  Words with_computers(std::array<int, 2> levels) const {
    Words words = *this;
    words.computers_ = levels;
    return words;
  }
  /// "Club": how well a computer of the level plays, 1 to 10.
  std::string computer_rank(int level) const;

 private:
  struct Voice {
    Language language;
    std::array<std::string, 2> names;
    InputDevice hand{};
  };
  std::shared_ptr<Voice> voice_;
  std::array<int, 2> computers_{};
};

}  // namespace app
