#include "replay/replay_text.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "carom/arithmetic.hpp"
#include "carom/scene_file.hpp"
#include "replay/agreed.hpp"
#include "replay/packed_text.hpp"
#include "replay/written_forms.hpp"

namespace replay {

namespace {

constexpr std::string_view what = "a replay";

// Numbers of moves take three bytes each in the payload, and packing makes less of them: the counts
// of steps, and drags and places on the grid, zigzag (0, -1, 1, -2, … as 0, 1, 2, 3, …).
constexpr int number_bytes = 3;
constexpr std::int64_t number_end = std::int64_t{1} << 8 * number_bytes;
static_assert(max_move_steps < number_end);

bool on_grid(double number) {
  const double multiple = number / text_grid;  // exact, by a power of two
  return std::abs(multiple) < number_end / 2.0 && multiple == std::trunc(multiple);
}

std::uint64_t to_zigzag(double number) {
  const auto multiple = static_cast<std::int64_t>(number / text_grid);
  return static_cast<std::uint64_t>(multiple < 0 ? -2 * multiple - 1 : 2 * multiple);
}

double from_zigzag(std::uint64_t code) {
  const auto half = static_cast<std::int64_t>(code / 2);
  return static_cast<double>(code % 2 == 0 ? half : -half - 1) * text_grid;
}

// The game, as a number. Billiards with options of its own is a third one, followed by them. In
// version 2 there is no third one: the options and all that was agreed on follow in any case.
enum class Form : std::uint64_t { billiards, angry_balls, billiards_with_options };
constexpr std::uint64_t second_begins = 1;  // bits of the options
constexpr std::uint64_t keep_turn = 2;

Form form_of(const Replay& replay) {
  if (replay.level) return Form::angry_balls;
  if (form_version(replay) == 2) return Form::billiards;
  return replay.options == games::billiards::Options{} ? Form::billiards
                                                       : Form::billiards_with_options;
}

constexpr std::size_t short_hash_bytes = 1;
static_assert(short_hash_mask == (1 << 8 * short_hash_bytes) - 1);

carom::Error damaged(std::string problem) { return damaged_text(std::move(problem), what); }

// The payload, which docs/formats.md describes.
class Writer {
 public:
  std::string write(const Replay& replay) {
    whole(physics_version);
    whole(rules_version);
    whole(static_cast<std::uint64_t>(form_of(replay)));
    const bool second_version = form_version(replay) == 2;
    if (second_version || form_of(replay) == Form::billiards_with_options)
      whole((replay.options.first_player == 1 ? second_begins : 0) |
            (replay.options.keep_turn ? keep_turn : 0));
    if (second_version)
      for (const Agreed& item : agreed()) whole(item.get(replay));
    whole(static_cast<std::uint64_t>(replay.score[0]));
    if (replay.level) {
      const std::string level = carom::write_scene(*replay.level);
      whole(level.size());
      bytes_ += level;
    } else {
      whole(static_cast<std::uint64_t>(replay.score[1]));
    }
    whole(replay.moves.size());
    std::vector<std::uint64_t> numbers;
    std::vector<double> others;  // not on the grid
    for (const Move& move : replay.moves) {
      unsigned form = static_cast<unsigned>(move.command.index()) % 2;
      if (const carom::Vec2* const vector = vector_of(move.command)) {
        for (const auto& [number, bit] : {std::pair{vector->x, 2U}, {vector->y, 4U}}) {
          if (on_grid(number)) {
            numbers.push_back(to_zigzag(number));
          } else {
            others.push_back(number);
            form |= bit;
          }
        }
      }
      little_endian(form, 1);
    }
    for (const Move& move : replay.moves)
      if (command_names[move.command.index()].moves) numbers.push_back(move.steps);
    for (int byte = 0; byte < number_bytes; ++byte)
      for (const std::uint64_t number : numbers) little_endian(number >> 8 * byte, 1);
    for (const double number : others) little_endian(std::bit_cast<std::uint64_t>(number), 8);
    for (const Move& move : replay.moves)
      little_endian(move.hash, &move == &replay.moves.back() ? 8 : short_hash_bytes);
    return std::move(bytes_);
  }

 private:
  // LEB128: seven bits a byte, the lowest first.
  void whole(std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) bytes_ += static_cast<char>(number | 0x80);
    bytes_ += static_cast<char>(number);
  }

  void little_endian(std::uint64_t number, std::size_t count) {
    for (std::size_t byte = 0; byte < count; ++byte)
      bytes_ += static_cast<char>(number >> 8 * byte & 0xff);
  }

  std::string bytes_;
};

// After a mistake everything reads as zero; whether there was one is asked at the end.
class Reader {
 public:
  Reader(std::string_view bytes, char version) : bytes_(bytes), version_(version) {}

  carom::Result<Replay> read() {
    if (const std::uint64_t physics = whole(); !wrong_ && physics != physics_version)
      return carom::Error{.problem = made_by("physics", physics, physics_version)};
    if (const std::uint64_t rules = whole(); !wrong_ && rules != rules_version)
      return carom::Error{.problem = made_by("rules", rules, rules_version)};

    Replay replay{.short_hashes = true};
    const auto form = static_cast<Form>(whole());
    const bool second_version = version_ == 2;
    const std::uint64_t options =
        second_version || form == Form::billiards_with_options ? whole() : 0;
    if (form > (second_version ? Form::angry_balls : Form::billiards_with_options) ||
        options > (second_begins | keep_turn))
      wrong_ = true;
    replay.options = {.first_player = (options & second_begins) != 0 ? 1 : 0,
                      .keep_turn = (options & keep_turn) != 0};
    if (second_version)
      for (const Agreed& item : agreed()) wrong_ = !item.set(replay, whole()) || wrong_;
    const bool is_level = form == Form::angry_balls;
    replay.score[0] = points();
    if (is_level) {
      auto level = games::angry_balls::read_level(take(whole()));
      if (wrong_) return damaged("it ends too early");
      if (!level) return level.errors();
      replay.level = std::move(level).value();
    } else {
      replay.score[1] = points();
    }
    const std::uint64_t moves = whole();
    if (moves > max_moves)
      return carom::Error{.problem = {carom::MessageCode::has_moves, {std::to_string(moves)}},
                          .expected = {carom::MessageCode::at_most, {std::to_string(max_moves)}}};
    const auto count = static_cast<std::size_t>(moves);
    const std::string_view forms = take(count);
    if (wrong_) return damaged("it ends too early");
    replay.moves.resize(count);
    std::vector<double*> on_grid;
    std::vector<double*> others;
    std::vector<std::uint64_t*> steps;
    for (std::size_t i = 0; i < count; ++i) {
      Move& move = replay.moves[i];
      const auto bits = static_cast<unsigned char>(forms[i]);
      if (bits > 7) wrong_ = true;
      move.command = command_names[(is_level ? 2 : 0) + bits % 2].command;
      if (carom::Vec2* const vector = vector_of(move.command)) {
        (bits & 2U ? others : on_grid).push_back(&vector->x);
        (bits & 4U ? others : on_grid).push_back(&vector->y);
      }
      if (command_names[move.command.index()].moves) steps.push_back(&move.steps);
    }
    std::vector<std::uint64_t> numbers(on_grid.size() + steps.size());
    for (int byte = 0; byte < number_bytes; ++byte)
      for (std::uint64_t& number : numbers) number |= little_endian(1) << 8 * byte;
    auto next = numbers.begin();
    for (double* const number : on_grid) *number = from_zigzag(*next++);
    for (std::uint64_t* const number : steps) *number = *next++;
    for (double* const number : others) *number = std::bit_cast<double>(little_endian(8));
    for (Move& move : replay.moves)
      move.hash = little_endian(&move == &replay.moves.back() ? 8 : short_hash_bytes);
    if (wrong_ || at_ != bytes_.size()) return damaged("its content makes no sense");
    return replay;
  }

 private:
  std::string_view take(std::uint64_t count) {
    if (wrong_ || count > bytes_.size() - at_) {
      wrong_ = true;
      return {};
    }
    at_ += static_cast<std::size_t>(count);
    return bytes_.substr(at_ - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
  }

  std::uint64_t whole() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::string_view byte = take(1);
      if (byte.empty()) return 0;
      const auto bits = static_cast<std::uint64_t>(static_cast<unsigned char>(byte[0]));
      number |= (bits & 0x7f) << shift;
      if (bits < 0x80) return number;
    }
    wrong_ = true;
    return 0;
  }

  std::int64_t points() {
    const std::uint64_t number = whole();
    if (number <= std::uint64_t{max_score}) return static_cast<std::int64_t>(number);
    wrong_ = true;
    return 0;
  }

  std::uint64_t little_endian(std::size_t count) {
    std::uint64_t number = 0;
    int shift = 0;
    for (const char byte : take(count)) {
      number |= static_cast<std::uint64_t>(static_cast<unsigned char>(byte)) << shift;
      shift += 8;
    }
    return number;
  }

  std::string_view bytes_;
  char version_;
  std::size_t at_ = 0;
  bool wrong_ = false;
};

}  // namespace

std::string write_text(const Replay& replay) {
  const carom::ExactArithmetic exact;
  return pack(static_cast<char>(form_version(replay)), Writer().write(replay));
}

carom::Result<Replay> read_text(std::string_view text) {
  const carom::ExactArithmetic exact;
  const char version = packed_version(text) == 2 ? 2 : 1;
  const auto payload = unpack(text, version, what);
  if (!payload) return payload.errors();
  auto replay = Reader(payload.value(), version).read();
  if (!replay) return replay;
  carom::Errors errors = check(replay.value());
  if (!errors.empty()) return errors;
  // Every replay has one payload; the packing of it depends on zlib's version and is left out.
  if (form_version(replay.value()) != version || Writer().write(replay.value()) != payload.value())
    return damaged("it is not written as it should be");
  return replay;
}

}  // namespace replay
