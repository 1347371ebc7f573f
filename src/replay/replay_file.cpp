#include "replay/replay_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/fnv1a.hpp"
#include "carom/scene_file.hpp"
#include "carom/trace.hpp"
#include "json/json.hpp"
#include "json/number_text.hpp"
#include "replay/agreed.hpp"
#include "replay/replay_text.hpp"
#include "replay/written_forms.hpp"

namespace replay {

using enum carom::MessageCode;

namespace {

using Json = nlohmann::json;

constexpr std::size_t max_depth = 16;  // of arrays and objects; a replay with a level needs 5
constexpr std::string_view white_space = " \t\n\r";
constexpr std::string_view any_hash = "16 hexadecimal digits, lower case, in double quotes";
constexpr std::string_view any_replay = R"(a replay: {"angry-balls-replay": 1, …})";

// The keys, in the order in which they are written.
constexpr std::string_view replay_keys[] = {"angry-balls-replay",
                                            "physics",
                                            "rules",
                                            "game",
                                            "first-player",
                                            "keep-turn",
                                            "reds",
                                            "touch-red",
                                            "alone",
                                            "computer-1",
                                            "computer-2",
                                            "seed",
                                            "best-of",
                                            "won-1",
                                            "won-2",
                                            "duel",
                                            "score",
                                            "level",
                                            "moves",
                                            "checksum"};
constexpr std::string_view move_keys[] = {"command", "x", "y", "steps", "hash"};
constexpr std::string_view game_names[] = {"billiards", "angry-balls"};  // in the order of Kind

std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string list(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::optional<std::uint64_t> read_hash(std::string_view text) {
  if (text.size() != 16 || text.find_first_not_of("0123456789abcdef") != std::string_view::npos)
    return std::nullopt;
  std::uint64_t hash = 0;
  std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  return hash;
}

// Null if the key is none of version 2.
const Agreed* agreed_on(std::string_view key) {
  const auto found = std::ranges::find(agreed(), key, &Agreed::key);
  return found == agreed().end() ? nullptr : &*found;
}

// The fault of a version; empty if there is none.
carom::Message version_problem(std::string_view key, std::uint64_t version) {
  const auto problem = [&](std::string_view what, int own) {
    return version == static_cast<std::uint64_t>(own) ? carom::Message()
                                                      : made_by(what, version, own);
  };
  if (key == "physics") return problem("physics", physics_version);
  if (key == "rules") return problem("rules", rules_version);
  return version == 1 ? carom::Message() : problem("version", 2);
}

// The level as its own file says it, two columns further in.
std::string indented(std::string_view text) {
  std::string out;
  while (text.ends_with('\n')) text.remove_suffix(1);
  for (const char c : text) {
    out += c;
    if (c == '\n') out += "  ";
  }
  return out;
}

// A file of it up to the checksum.
std::string content(const Replay& replay) {
  std::string out = "{";
  const auto begin = [&](std::string_view key) {
    out.append(out.size() == 1 ? "\n  " : ",\n  ").append(in_quotes(key)).append(": ");
  };
  const auto number = [&](std::string_view key, int value) {
    begin(key);
    carom::append_number(out, value);
  };
  number("angry-balls-replay", form_version(replay));
  number("physics", physics_version);
  number("rules", rules_version);
  begin("game");
  out += in_quotes(game_names[static_cast<std::size_t>(replay.kind())]);
  if (replay.options.first_player != 0) number("first-player", replay.options.first_player + 1);
  if (replay.options.keep_turn) {
    begin("keep-turn");
    out += "true";
  }
  for (const Agreed& item : agreed()) {
    if (item.get(replay) == item.usual) continue;
    begin(item.key);
    if (item.truth)
      out += "true";
    else
      carom::append_number(out, item.get(replay));
  }
  begin("score");
  out += '[' + std::to_string(replay.score[0]);
  if (replay.kind() == Kind::billiards) out += ", " + std::to_string(replay.score[1]);
  out += ']';
  if (replay.level) {
    begin("level");
    out += indented(carom::write_scene(*replay.level));
  }
  begin("moves");
  out += '[';
  for (const Move& move : replay.moves) {
    out += &move == replay.moves.data() ? "\n    " : ",\n    ";
    const CommandName& name = command_names[move.command.index()];
    out.append("{\"command\": ").append(in_quotes(name.name));
    if (const carom::Vec2* const place = vector_of(move.command)) {
      out += ", \"x\": ";
      carom::append_number(out, place->x);
      out += ", \"y\": ";
      carom::append_number(out, place->y);
    }
    if (name.moves) {
      out += ", \"steps\": ";
      carom::append_number(out, move.steps);
    }
    out.append(", \"hash\": ").append(in_quotes(carom::hash_text(move.hash))).append("}");
  }
  out += replay.moves.empty() ? "]" : "\n  ]";
  return out;
}

// Pins down what no state hash does: a level's name, a wait while nothing moves.
std::uint64_t checksum(std::string_view content) {
  carom::Fnv1a hash;
  hash.add(content);
  return hash.hash();
}

// Counts the bytes that the parser has taken.
class Cursor {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Cursor(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
  reference operator*() const { return *at_; }
  Cursor& operator++() {
    ++at_;
    ++*taken_;
    return *this;
  }
  Cursor operator++(int) {
    Cursor before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Cursor& a, const Cursor& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  std::size_t* taken_;
};

// Reads by the events of nlohmann's parser and stops at the first error. No document is built, so
// memory is in proportion to what is accepted.
class Reader {
 public:
  explicit Reader(std::string_view json) : json_(json) {}

  carom::Result<Replay> read() {
    if (json_.size() > max_bytes)
      return carom::Error{.problem = {is_larger_than_bytes, {std::to_string(max_bytes)}},
                          .expected = "a replay"};
    // nlohmann's parser takes a zero byte for the end.
    if (const std::size_t zero = json_.find('\0'); zero != std::string_view::npos)
      return at_offset(zero, {.problem = {is_not_json_found, {"the byte 0x00"}}});
    const bool whole = Json::sax_parse(Cursor(json_.data(), &taken_),
                                       Cursor(json_.data() + json_.size(), &taken_), this);
    if (whole) finish();
    if (!errors_.empty()) return std::move(errors_);
    return std::move(replay_);
  }

  // nlohmann's SAX interface; returning false stops the parser.
  bool null() { return scalar({}); }
  bool boolean(bool truth) { return scalar({.truth = truth}); }
  bool number_integer(Json::number_integer_t) { return scalar({.number = number()}); }
  bool number_unsigned(Json::number_unsigned_t whole) {
    return scalar({.number = number(), .whole = whole});
  }
  // The parser's own number may have suffered from the locale.
  bool number_float(Json::number_float_t, const std::string&) {
    return scalar({.number = number()});
  }
  bool string(const std::string& text) { return scalar({.text = text}); }
  bool binary(const Json::binary_t&) { return false; }

  bool start_object(std::size_t) {
    ++depth_;
    if (depth_ > max_depth) return refuse(is_nested_too_deeply, {at_most_brackets, {"16"}});
    switch (place_) {
      case Place::start:
        place_ = Place::replay;
        return true;
      case Place::moves:
        if (replay_.moves.size() == max_moves) {
          key_.clear();
          return refuse({has_more_elements, {std::to_string(max_moves)}},
                        {at_most, {std::to_string(max_moves)}}, "/moves");
        }
        place_ = Place::move;
        move_ = {};
        seen_in_move_ = 0;
        return true;
      case Place::replay:
        if (key_ == "level") {
          place_ = Place::level;
          level_begin_ = taken_ - 1;
          return true;
        }
        break;
      case Place::level:
        return true;
      case Place::score:
      case Place::move:
        break;
    }
    return wrong_kind(is_object);
  }

  bool end_object() {
    --depth_;
    switch (place_) {
      case Place::move:
        key_.clear();
        if (!end_move()) return false;
        place_ = Place::moves;
        return true;
      case Place::level:
        if (depth_ == 1) {
          place_ = Place::replay;
          return end_level();
        }
        return true;
      default:
        return true;
    }
  }

  bool start_array(std::size_t) {
    ++depth_;
    if (depth_ > max_depth) return refuse(is_nested_too_deeply, {at_most_brackets, {"16"}});
    if (place_ == Place::level) return true;
    if (place_ == Place::replay && key_ == "score") {
      place_ = Place::score;
      return true;
    }
    if (place_ == Place::replay && key_ == "moves") {
      place_ = Place::moves;
      return true;
    }
    return wrong_kind(is_array);
  }

  bool end_array() {
    --depth_;
    if (place_ == Place::score || place_ == Place::moves) place_ = Place::replay;
    return true;
  }

  bool key(const std::string& name) {
    if (place_ == Place::level) return true;
    const bool in_move = place_ == Place::move;
    const std::span<const std::string_view> keys =
        in_move ? std::span<const std::string_view>(move_keys) : replay_keys;
    const auto found = std::ranges::find(keys, name);
    key_ = name;
    if (found == keys.end()) {
      key_ = printable(name);
      return refuse(is_unknown_key, {one_of, {list(keys)}});
    }
    unsigned& seen = in_move ? seen_in_move_ : seen_;
    const unsigned bit = 1U << (found - keys.begin());
    if (seen & bit) return refuse(is_given_twice, each_key_once);
    seen |= bit;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const Json::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow) return refuse(is_too_large_a_number, "a number");
    const std::size_t offset = std::min(std::max(position, std::size_t{1}) - 1, json_.size());
    errors_ = {at_offset(
        offset,
        {.problem = json_.find_first_not_of(white_space) == std::string_view::npos ? is_empty
                                                                                   : is_not_json,
         .expected = std::string(any_replay)})};
    return false;
  }

 private:
  enum class Place : std::uint8_t { start, replay, score, level, moves, move };

  // A value that is neither object nor array; of null nothing is known.
  struct Scalar {
    std::optional<double> number{};
    std::optional<std::uint64_t> whole{};
    std::optional<std::string_view> text{};
    std::optional<bool> truth{};
  };

  // The number that the parser has just taken, and one byte behind it.
  double number() const {
    std::size_t end = taken_;
    while (end > 0 && !is_of_number(json_[end - 1])) --end;
    std::size_t begin = end;
    while (begin > 0 && is_of_number(json_[begin - 1])) --begin;
    return carom::read_number(json_.substr(begin, end - begin));
  }
  static bool is_of_number(char c) {
    return std::string_view("+-.0123456789eE").find(c) != std::string_view::npos;
  }

  static std::string printable(std::string_view text) {
    std::string shown;
    for (const char c : text.substr(0, 40))
      shown += static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '/' || c == '~' ? '?' : c;
    return shown;
  }

  std::string pointer() const {
    std::string text;
    if (place_ == Place::moves || place_ == Place::move)
      text = "/moves/" + std::to_string(replay_.moves.size());
    else if (place_ == Place::score)
      return "/score/" + std::to_string(scores_);
    else if (place_ == Place::level)
      return "/level";
    if (place_ != Place::moves && !key_.empty()) text += "/" + key_;
    return text;
  }

  bool refuse(carom::Message problem, carom::Message expected) {
    return refuse(std::move(problem), std::move(expected), pointer());
  }
  bool refuse(carom::Message problem, carom::Message expected, std::string at) {
    errors_ = carom::locate(json_, {{.pointer = std::move(at),
                                     .problem = std::move(problem),
                                     .expected = std::move(expected)}});
    return false;
  }

  // Line and column as Error counts them.
  carom::Error at_offset(std::size_t offset, carom::Error error) const {
    const std::string_view before = json_.substr(0, offset);
    const std::size_t line_break = before.rfind('\n');
    error.line = 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
    error.column = line_break == std::string_view::npos ? offset + 1 : offset - line_break;
    return error;
  }

  // For an object, array, null or boolean where none belongs.
  bool wrong_kind(carom::Message problem) { return refuse(std::move(problem), expectation()); }

  carom::Message expectation() const {
    if (place_ == Place::start) return std::string(any_replay);
    if (place_ == Place::score)
      return "the points made, a whole number from 0 to " + std::to_string(max_score);
    if (place_ == Place::moves) return R"(an object such as {"command": "next", "hash": "…"})";
    if (place_ == Place::move) {
      if (key_ == "command") return R"("shoot", "place", "throw" or "next")";
      if (key_ == "steps") return {whole_number_from_to, {"0", std::to_string(max_move_steps)}};
      if (key_ == "hash") return std::string(any_hash);
      return "a number (px)";
    }
    if (key_ == "game") return R"("billiards" or "angry-balls")";
    if (key_ == "first-player") return "1 or 2";
    if (const Agreed* const item = agreed_on(key_)) return std::string(item->expected);
    if (key_ == "keep-turn") return "true or false";
    if (key_ == "score") return "an array of the points made, in billiards by each player";
    if (key_ == "level") return "a level, an object";
    if (key_ == "checksum") return std::string(any_hash);
    if (key_ == "moves") return "an array of what the players did";
    return "a version, a whole number";
  }

  bool scalar(const Scalar& value) {
    switch (place_) {
      case Place::level:
        return true;
      case Place::score:
        return score(value);
      case Place::replay:
        return member(value);
      case Place::move:
        return move_member(value);
      default:
        return wrong_value(value);
    }
  }

  bool wrong_value(const Scalar& value) {
    std::string found = "null";
    if (value.truth) {
      found = *value.truth ? "true" : "false";
    } else if (value.text) {
      found = in_quotes(printable(*value.text));
    } else if (value.number) {
      found.clear();
      carom::append_number(found, *value.number);
    }
    return refuse({is, {std::move(found)}}, expectation());
  }

  bool score(const Scalar& value) {
    if (scores_ == 2) return refuse(is_third_score, "one score, in billiards two");
    if (!value.whole || *value.whole > std::uint64_t{max_score}) return wrong_value(value);
    replay_.score[scores_++] = static_cast<std::int64_t>(*value.whole);
    return true;
  }

  bool member(const Scalar& value) {
    if (key_ == "game") {
      const auto* name = std::ranges::find(game_names, value.text.value_or(""));
      if (name == std::end(game_names)) return wrong_value(value);
      kind_ = Kind{static_cast<std::uint8_t>(name - game_names)};
      return true;
    }
    if (key_ == "checksum") {
      checksum_ = read_hash(value.text.value_or(""));
      return checksum_ || wrong_value(value);
    }
    if (key_ == "first-player") {
      const std::uint64_t player = value.whole.value_or(0);
      if (player < 1 || player > 2) return wrong_value(value);
      replay_.options.first_player = static_cast<int>(player) - 1;
      return true;
    }
    if (key_ == "keep-turn") {
      if (!value.truth) return wrong_value(value);
      replay_.options.keep_turn = *value.truth;
      return true;
    }
    if (const Agreed* const item = agreed_on(key_)) {
      const auto given = item->truth && value.truth
                             ? std::optional(std::uint64_t{*value.truth ? 1U : 0U})
                             : value.whole;
      const bool fits = given && item->truth == value.truth.has_value();
      return (fits && item->set(replay_, *given)) || wrong_value(value);
    }
    if (key_ == "score" || key_ == "level" || key_ == "moves" || !value.whole)
      return wrong_value(value);
    if (key_ == "angry-balls-replay") version_ = *value.whole;
    carom::Message problem = version_problem(key_, *value.whole);
    return problem.empty() || refuse(std::move(problem), {});
  }

  bool move_member(const Scalar& value) {
    if (key_ == "command") {
      const auto* name =
          std::ranges::find(command_names, value.text.value_or(""), &CommandName::name);
      if (name == std::end(command_names)) return wrong_value(value);
      move_.command = name->command;
    } else if (key_ == "steps") {
      if (!value.whole || *value.whole > max_move_steps) return wrong_value(value);
      move_.steps = *value.whole;
    } else if (key_ == "hash") {
      const auto hash = read_hash(value.text.value_or(""));
      if (!hash) return wrong_value(value);
      move_.hash = *hash;
    } else {
      if (!value.number) return wrong_value(value);
      (key_ == "x" ? place_of_move_.x : place_of_move_.y) = *value.number;
    }
    return true;
  }

  static unsigned move_bit(std::string_view key) {
    return 1U << (std::ranges::find(move_keys, key) - std::begin(move_keys));
  }

  bool end_move() {
    const std::string at = "/moves/" + std::to_string(replay_.moves.size());
    const auto missing = [&](std::string_view key) {
      key_ = key;
      return refuse(is_missing, expectation(), at + "/" + std::string(key));
    };
    const auto given = [&](std::string_view key) { return (seen_in_move_ & move_bit(key)) != 0; };
    for (const std::string_view key : {"command", "hash"})
      if (!given(key)) return missing(key);
    const CommandName& name = command_names[move_.command.index()];
    carom::Vec2* const place = vector_of(move_.command);
    for (const auto& [key, wanted] : {std::pair<std::string_view, bool>{"x", place != nullptr},
                                      {"y", place != nullptr},
                                      {"steps", name.moves}}) {
      if (given(key) == wanted) continue;
      if (wanted) return missing(key);
      return refuse(is_given, "no " + std::string(key) + " with " + in_quotes(name.name),
                    at + "/" + std::string(key));
    }
    if (place) *place = place_of_move_;
    replay_.moves.push_back(move_);
    return true;
  }

  bool end_level() {
    const std::string_view text = json_.substr(level_begin_, taken_ - level_begin_);
    auto level = games::angry_balls::read_level(text);
    if (level) {
      replay_.level = std::move(level).value();
      return true;
    }
    const carom::Error begin = at_offset(level_begin_, {});
    errors_ = level.errors();
    for (carom::Error& error : errors_) {
      error.pointer.insert(0, "/level");
      if (error.line == 1) error.column += begin.column - 1;
      if (error.line > 0) error.line += begin.line - 1;
    }
    return false;
  }

  void finish() {
    place_ = Place::replay;
    for (const std::string_view key : replay_keys) {
      const auto bit = 1U << (std::ranges::find(replay_keys, key) - std::begin(replay_keys));
      const bool of_billiards = kind_ == Kind::billiards;
      key_ = key;
      if (key == "level" && of_billiards) {
        if (seen_ & bit) refuse(is_given, R"(no level in "billiards")");
      } else if (key == "first-player" || key == "keep-turn" || agreed_on(key)) {
        if ((seen_ & bit) && !of_billiards)
          refuse(is_given, "no " + std::string(key) + R"( in "angry-balls")");
      } else if (!(seen_ & bit)) {
        refuse(is_missing, expectation());
      } else if (key == "score" && scores_ != (of_billiards ? 2 : 1)) {
        refuse({has_elements, {std::to_string(scores_)}},
               of_billiards ? "the points of both players" : "the points of the one player");
      }
      if (!errors_.empty()) return;
    }
    errors_ = carom::locate(json_, check(replay_));
    if (errors_.empty() && version_ != static_cast<std::uint64_t>(form_version(replay_)))
      refuse({is, {std::to_string(version_)}}, {version, {std::to_string(form_version(replay_))}},
             "/angry-balls-replay");
    if (errors_.empty() && checksums_count && checksum_ != checksum(content(replay_)))
      refuse(is_not_the_replays, "the replay as it was written", "/checksum");
  }

  std::string_view json_;
  std::size_t taken_ = 0;  // bytes, by the parser
  std::size_t depth_ = 0;
  Place place_ = Place::start;
  std::string key_;    // the last in the replay or move, fit to be printed
  unsigned seen_ = 0;  // keys of the replay, a bit for each
  unsigned seen_in_move_ = 0;
  std::uint64_t version_ = 1;
  std::size_t scores_ = 0;
  std::size_t level_begin_ = 0;
  Kind kind_ = Kind::billiards;
  std::optional<std::uint64_t> checksum_;
  Move move_;
  carom::Vec2 place_of_move_;
  Replay replay_;
  carom::Errors errors_;
};

}  // namespace

carom::Result<Replay> read_replay(std::string_view bytes) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  const std::size_t mark = bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  const std::size_t begin = bytes.find_first_not_of(white_space, mark);
  const bool is_json = begin == std::string_view::npos || bytes[begin] == '{';
  return is_json ? read_json(bytes) : read_text(bytes);
}

carom::Result<Replay> read_json(std::string_view json) {
  const carom::ExactArithmetic exact;
  return Reader(json).read();
}

std::string write_json(const Replay& replay) {
  const carom::ExactArithmetic exact;
  std::string out = content(replay);
  const std::string sum = carom::hash_text(checksum(out));
  return out.append(",\n  \"checksum\": ").append(in_quotes(sum)).append("\n}\n");
}

}  // namespace replay
