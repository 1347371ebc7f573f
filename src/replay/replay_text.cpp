#include "replay/replay_text.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>
#include <zlib.h>

#include "carom/scene_file.hpp"
#include "replay/written_forms.hpp"

namespace replay {

namespace {

constexpr char format_version = 1;
constexpr std::size_t header_bytes = 5;  // the version and a CRC-32
constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::size_t max_text = max_bytes / 3 * 4 + 4;

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

// The game, as a number. Billiards with options of its own is a third one, followed by them.
enum class Form : std::uint64_t { billiards, angry_balls, billiards_with_options };
constexpr std::uint64_t second_begins = 1;  // bits of the options
constexpr std::uint64_t keep_turn = 2;

Form form_of(const Replay& replay) {
  if (replay.level) return Form::angry_balls;
  return replay.options == games::billiards::Options{} ? Form::billiards
                                                       : Form::billiards_with_options;
}

constexpr std::size_t short_hash_bytes = 1;
static_assert(short_hash_mask == (1 << 8 * short_hash_bytes) - 1);

carom::Error damaged(std::string what) {
  return {.problem = "is damaged: " + std::move(what),
          .expected = "the text of a replay, whole and unchanged"};
}

// base64url (RFC 4648, section 5) without padding.
std::string to_base64url(std::string_view bytes) {
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char byte : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(byte);
    for (count += 8; count >= 6; count -= 6) text += digits[bits >> (count - 6) & 63];
  }
  if (count > 0) text += digits[bits << (6 - count) & 63];
  return text;
}

// Refuses what to_base64url() does not write, spare bits that are not zero included.
std::optional<std::string> from_base64url(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  if (count >= 6 || (bits & ((1U << count) - 1)) != 0) return std::nullopt;
  return bytes;
}

// zlib's raw deflate. What it gives may change with zlib's version; what inflate makes of it may
// not.
std::string deflated(std::string payload) {
  z_stream stream{};
  // Only a lack of memory could make these fail.
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL,
               Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, static_cast<uLong>(payload.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(payload.data());
  stream.avail_in = static_cast<uInt>(payload.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// None unless the bytes are one whole stream of at most max_bytes. Never holds more than that.
std::optional<std::string> inflated(std::string packed) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return std::nullopt;
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string payload;
  std::array<Bytef, 1 << 14> buffer;
  int state = Z_OK;
  while (state == Z_OK && payload.size() <= max_bytes) {
    stream.next_out = buffer.data();
    stream.avail_out = static_cast<uInt>(buffer.size());
    state = inflate(&stream, Z_NO_FLUSH);
    payload.append(reinterpret_cast<const char*>(buffer.data()), buffer.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || stream.avail_in > 0 || payload.size() > max_bytes)
    return std::nullopt;
  return payload;
}

std::uint32_t checksum(std::string_view version, std::string_view packed) {
  uLong crc = crc32(0, nullptr, 0);
  for (const std::string_view part : {version, packed})
    crc = crc32(crc, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
  return static_cast<std::uint32_t>(crc);
}

// The payload, which docs/formats.md describes.
class Writer {
 public:
  std::string write(const Replay& replay) {
    whole(physics_version);
    whole(rules_version);
    whole(static_cast<std::uint64_t>(form_of(replay)));
    if (form_of(replay) == Form::billiards_with_options)
      whole((replay.options.first_player == 1 ? second_begins : 0) |
            (replay.options.keep_turn ? keep_turn : 0));
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
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  carom::Result<Replay> read() {
    if (const std::uint64_t physics = whole(); !wrong_ && physics != physics_version)
      return carom::Error{.problem = made_by("physics", physics, physics_version)};
    if (const std::uint64_t rules = whole(); !wrong_ && rules != rules_version)
      return carom::Error{.problem = made_by("rules", rules, rules_version)};

    Replay replay{.short_hashes = true};
    const auto form = static_cast<Form>(whole());
    const std::uint64_t options = form == Form::billiards_with_options ? whole() : 0;
    if (form > Form::billiards_with_options || options > (second_begins | keep_turn)) wrong_ = true;
    replay.options = {.first_player = (options & second_begins) != 0 ? 1 : 0,
                      .keep_turn = (options & keep_turn) != 0};
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
    const std::uint64_t count = whole();
    if (count > max_moves)
      return carom::Error{.problem = "has " + std::to_string(count) + " moves",
                          .expected = "at most " + std::to_string(max_moves)};
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

  int points() {
    const std::uint64_t number = whole();
    if (number <= std::numeric_limits<int>::max()) return static_cast<int>(number);
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
  std::size_t at_ = 0;
  bool wrong_ = false;
};

}  // namespace

std::string write_text(const Replay& replay) {
  const std::string version(1, format_version);
  const std::string packed = deflated(Writer().write(replay));
  const std::uint32_t crc = checksum(version, packed);
  std::string bytes = version;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(crc >> shift);
  return to_base64url(bytes + packed);
}

carom::Result<Replay> read_text(std::string_view text) {
  if (text.size() > max_text)
    return carom::Error{.problem = "is longer than " + std::to_string(max_text) + " characters",
                        .expected = "the text of a replay"};
  const std::size_t foreign = text.find_first_not_of(digits);
  if (foreign != std::string_view::npos)
    return carom::Error{.problem = "is no text of a replay: its character " +
                                   std::to_string(foreign + 1) + " does not belong there",
                        .expected = "letters, digits, - and _ only"};
  auto bytes = from_base64url(text);
  if (!bytes || bytes->size() < header_bytes) return damaged("it is not whole");
  if (bytes->front() != format_version)
    return carom::Error{.problem = "is version " +
                                   std::to_string(static_cast<unsigned char>(bytes->front())) +
                                   " of the text of a replay",
                        .expected = "version 1"};
  std::uint32_t crc = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
    crc |= static_cast<std::uint32_t>(static_cast<unsigned char>((*bytes)[1 + byte])) << 8 * byte;
  std::string packed = bytes->substr(header_bytes);
  if (checksums_count && checksum(bytes->substr(0, 1), packed) != crc)
    return damaged("its checksum is wrong");
  const auto payload = inflated(std::move(packed));
  if (!payload)
    return damaged("it cannot be unpacked, or not into " + std::to_string(max_bytes) + " bytes");

  auto replay = Reader(*payload).read();
  if (!replay) return replay;
  carom::Errors errors = check(replay.value());
  if (!errors.empty()) return errors;
  // Every replay has one payload; the packing of it depends on zlib's version and is left out.
  if (Writer().write(replay.value()) != *payload)
    return damaged("it is not written as it should be");
  return replay;
}

}  // namespace replay
