#include "carom/scene_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utf8cpp/utf8/core.h>
#include <utility>

#include "carom/arithmetic.hpp"
#include "carom/internal/scene_check.hpp"
#include "carom/internal/scene_fields.hpp"
#include "json/json.hpp"
#include "json/number_text.hpp"

namespace carom {

namespace {

using Json = nlohmann::json;

constexpr std::size_t max_depth = 16;   // of arrays and objects; a scene needs 3
constexpr std::size_t max_quoted = 40;  // bytes of the file that a message repeats
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view white_space = " \t\n\r";
constexpr std::string_view any_scene = R"(a scene in UTF-8: {"carom": 1, …})";
constexpr std::string_view any_number = "a number in the form of JSON, such as 12, -0.5 or 1e3";
constexpr std::string_view any_value =
    "a number such as 12 or -0.5, a text in double quotes, an object or an array";

std::string shortened(std::string_view text) {
  if (text.size() <= max_quoted) return std::string(text);
  // Not within a character.
  const char* const end = utf8::find_invalid(text.data(), text.data() + max_quoted);
  return std::string(text.data(), end) + "…";
}

std::string hex(unsigned char byte) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  return {digits[byte >> 4], digits[byte & 15]};
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

// A key as a part of a JSON pointer (RFC 6901), fit to be printed.
std::string pointer_part(std::string_view key) {
  std::string part;
  for (const char c : key)
    if (c == '~')
      part += "~0";
    else if (c == '/')
      part += "~1";
    else if (is_control(c))
      part += "\\u00" + hex(static_cast<unsigned char>(c));
    else
      part += c;
  return shortened(part);
}

// Calls f with a pointer and with all above it, the longest first; not with "", the whole.
template <class F>
void for_each_above(std::string pointer, F f) {
  for (; !pointer.empty(); pointer.resize(pointer.rfind('/'))) f(pointer);
}

enum class Kind : std::uint8_t { null, boolean, number, huge_number, text, object, array };

struct Value {
  Kind kind;
  std::size_t offset;     // of its first byte
  std::string_view raw;   // as it stands in the file; of an object or array the bracket only
  std::string_view text;  // the meaning of a text
};

// Stands for a number that could not be read: check() draws no conclusions from it.
constexpr double unread = std::numeric_limits<double>::quiet_NaN();

double number_in(const Value& value) {
  return value.kind == Kind::number ? read_number(value.raw) : unread;
}

// The index of a text among names, or their number if it is none of them.
std::size_t index_in(std::span<const std::string_view> names, const Value& value) {
  if (value.kind != Kind::text) return names.size();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), value.text) -
                                  names.begin());
}

Message describe(const Value& value) {
  if (value.kind == Kind::object) return MessageCode::is_object;
  if (value.kind == Kind::array) return MessageCode::is_array;
  return {MessageCode::is, {shortened(value.raw)}};
}

// The kind of the members of an object, or of the elements of an array.
enum class Place : std::uint8_t {
  skipped,
  scene,
  edges,
  holes,
  hole,
  obstacles,
  obstacle,
  balls,
  ball,
};

// Follows nlohmann's parser, which tells no positions, through the bytes: each of its events is the
// next token, and up to the end of that token the bytes are known to be valid JSON.
class Walker {
 public:
  explicit Walker(std::string_view bytes)
      : bytes_(bytes), cursor_(bytes.starts_with(byte_order_mark) ? byte_order_mark.size() : 0) {}

  /// False when it was stopped or met a syntax error.
  bool walk() { return Json::sax_parse(bytes_.begin(), bytes_.end(), this); }

  // nlohmann's SAX interface; returning false stops the parser.
  bool null() { return value(Kind::null); }
  bool boolean(bool) { return value(Kind::boolean); }
  bool number_integer(Json::number_integer_t) { return value(Kind::number); }
  bool number_unsigned(Json::number_unsigned_t) { return value(Kind::number); }
  bool number_float(Json::number_float_t, const std::string&) { return value(Kind::number); }
  bool string(const std::string& text) { return value(Kind::text, text); }
  bool binary(const Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return value(Kind::object); }
  bool start_array(std::size_t) { return value(Kind::array); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool key(const std::string& name) {
    next_token();
    pointer_.resize(containers_.back().pointer_size);
    pointer_ += '/';
    pointer_ += pointer_part(name);
    after_key_ = true;
    on_key(name);
    return true;
  }
  bool parse_error(std::size_t bytes_read, const std::string&, const Json::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow)
      value(Kind::huge_number);
    else
      on_syntax_error(bytes_read, error.what());
    return false;
  }

 protected:
  struct Container {
    bool array;
    Place place;
    std::size_t offset;        // of its bracket
    std::size_t pointer_size;  // of its own pointer within pointer_
    std::size_t count = 0;     // values seen in it
    std::uint32_t seen = 0;    // keys seen, a bit for each of its fields
  };

  ~Walker() = default;

  virtual Place on_value(const Value& value) = 0;
  virtual void on_key(const std::string&) {}
  virtual void on_end() {}
  virtual void on_syntax_error(std::size_t, std::string_view) {}
  virtual void on_too_deep() {}

  // From `from` to the next byte that is no white space, or the end.
  std::size_t skip_space(std::size_t from) const {
    return std::min(bytes_.find_first_not_of(white_space, from), bytes_.size());
  }

  // The next token, which must be a valid one that is no comma or colon.
  std::string_view next_token() {
    token_ = std::min(bytes_.find_first_not_of(" \t\n\r,:", cursor_), bytes_.size());
    cursor_ = token_ + 1;
    if (bytes_[token_] == '"') {
      while (cursor_ < bytes_.size() && bytes_[cursor_] != '"')
        cursor_ += bytes_[cursor_] == '\\' ? 2 : 1;
      cursor_ = std::min(cursor_ + 1, bytes_.size());
    } else if (std::string_view("{}[]").find(bytes_[token_]) == std::string_view::npos) {
      constexpr std::string_view ends("\0 \t\n\r,:{}[]\"", 11);
      cursor_ = std::min(bytes_.find_first_of(ends, cursor_), bytes_.size());
    }
    return bytes_.substr(token_, cursor_ - token_);
  }

  std::string_view bytes_;
  std::size_t cursor_;                 // behind the last token
  std::size_t token_ = 0;              // the last token
  std::string pointer_;                // of the last value or key
  std::vector<Container> containers_;  // that are open, the innermost last
  bool started_ = false;               // a value has been seen
  bool after_key_ = false;             // the last token was a key
  bool stopped_ = false;

 private:
  bool value(Kind kind, std::string_view text = {}) {
    const std::string_view raw = next_token();
    if (!containers_.empty()) {
      Container& parent = containers_.back();
      if (parent.array) {
        pointer_.resize(parent.pointer_size);
        pointer_ += '/';
        append_number(pointer_, parent.count);
      }
      ++parent.count;
    }
    started_ = true;
    after_key_ = false;
    const Place place = on_value({kind, token_, raw, text});
    if (kind == Kind::object || kind == Kind::array) {
      containers_.push_back({kind == Kind::array, place, token_, pointer_.size()});
      if (containers_.size() > max_depth) {
        on_too_deep();
        stopped_ = true;
      }
    }
    return !stopped_;
  }

  bool end() {
    next_token();
    on_end();
    pointer_.resize(containers_.back().pointer_size);
    containers_.pop_back();
    return true;
  }
};

// Finds where values stand.
class Locator final : public Walker {
 public:
  Locator(std::string_view bytes, std::map<std::string, std::size_t>& offsets)
      : Walker(bytes), offsets_(offsets) {}

 private:
  Place on_value(const Value& value) override {
    if (const auto found = offsets_.find(pointer_); found != offsets_.end())
      found->second = value.offset;
    return Place::skipped;
  }

  std::map<std::string, std::size_t>& offsets_;
};

struct Located {
  Error error;
  std::size_t offset;
};

// Where the values that errors point to stand, or what is above them where the file does not say
// them.
std::vector<Located> find_offsets(std::string_view bytes, Errors errors) {
  std::map<std::string, std::size_t> offsets;  // 0: the file does not say it
  for (const Error& error : errors)
    for_each_above(error.pointer, [&](const auto& pointer) { offsets[pointer] = 0; });
  Locator(bytes, offsets).walk();
  std::vector<Located> located;
  for (Error& error : errors) {
    std::size_t offset = 0;
    for_each_above(error.pointer, [&](const auto& pointer) {
      if (offset == 0) offset = offsets[pointer];
    });
    located.push_back({std::move(error), offset});
  }
  return located;
}

// In the order of the file, with lines and columns.
Errors in_file_order(std::string_view bytes, std::vector<Located> errors) {
  std::stable_sort(errors.begin(), errors.end(),
                   [](const Located& a, const Located& b) { return a.offset < b.offset; });
  Errors list;
  std::size_t line = 1;
  std::size_t line_begin = 0;
  std::size_t counted = 0;  // bytes whose line breaks are counted
  for (Located& e : errors) {
    for (; counted < e.offset; ++counted)
      if (bytes[counted] == '\n') {
        ++line;
        line_begin = counted + 1;
      }
    e.error.line = line;
    e.error.column = e.offset - line_begin + 1;
    list.push_back(std::move(e.error));
  }
  return list;
}

class Reader final : public Walker {
 public:
  explicit Reader(std::string_view bytes) : Walker(bytes) {}

  Result<Scene> read() {
    bool whole = walk();
    if (whole && skip_space(cursor_) < bytes_.size()) {  // nlohmann's parser stops at a zero byte
      on_syntax_error(bytes_.size() + 1, "");
      whole = false;
    }
    if (whole && more_ == 0) check_values();
    if (errors_.empty()) return std::move(scene_);
    Errors list = in_file_order(bytes_, std::move(errors_));
    if (more_ > 0) list.push_back(more_errors(more_));
    return list;
  }

 private:
  // Where the value of the last key goes; without a name nowhere.
  struct Target {
    std::string_view name;
    double* number = nullptr;
    Edge* edge = nullptr;
    const Range* range = nullptr;
    std::string* text = nullptr;
    MessageCode expected = MessageCode::text;
  };

  void report(std::size_t offset, std::string pointer, Message problem, Message expected) {
    if (errors_.size() == max_errors)
      ++more_;
    else
      errors_.push_back({{std::move(pointer), std::move(problem), std::move(expected)}, offset});
  }

  void refuse(const Value& value, Message expected) {
    report(value.offset, pointer_, describe(value), std::move(expected));
  }

  // Calls f with the fields of an object that is being read, and the object.
  template <class F>
  void with_fields(Place place, F f) {
    switch (place) {
      case Place::scene:
        return f(scene_fields, scene_);
      case Place::edges:
        return f(edges_fields, scene_.edges);
      case Place::hole:
        return f(hole_fields, scene_.holes.back());
      case Place::obstacle:
        return f(obstacle_fields, scene_.obstacles.back());
      case Place::ball:
        return f(ball_fields, scene_.balls.back());
      case Place::skipped:
      case Place::holes:
      case Place::obstacles:
      case Place::balls:
        return;
    }
  }

  Place on_value(const Value& value) override {
    if (containers_.empty()) {
      if (value.kind == Kind::object) return Place::scene;
      refuse(value, any_scene);
      return Place::skipped;
    }
    switch (containers_.back().place) {
      case Place::holes:
        return element(value, scene_.holes, max_fixtures, Place::hole, R"({"x": 10, "y": 10})");
      case Place::obstacles:
        return element(value, scene_.obstacles, max_fixtures, Place::obstacle, R"({"x": 500})");
      case Place::balls:
        return element(value, scene_.balls, max_balls, Place::ball, R"({"x": 200, "y": 200})");
      default:
        return member(value);
    }
  }

  template <class T>
  Place element(const Value& value, std::vector<T>& list, std::size_t most, Place place,
                std::string_view example) {
    if (list.size() == most) {
      pointer_.resize(containers_.back().pointer_size);
      report(value.offset, pointer_, {MessageCode::has_more_elements, {std::to_string(most)}},
             {MessageCode::at_most, {std::to_string(most)}});
      stopped_ = true;
      return Place::skipped;
    }
    list.emplace_back();
    if (value.kind == Kind::object) return place;
    refuse(value, {MessageCode::object_such_as, {std::string(example)}});
    with_fields(place, [](const auto& fields, auto& object) {
      for (const auto& field : fields)
        if (field.number) field.number(object) = unread;
    });
    return Place::skipped;
  }

  Place member(const Value& value) {
    if (target_.name.empty()) return Place::skipped;
    const Target target = std::exchange(target_, {});
    const auto refuse_it = [&] {
      refuse(value, target.range ? expectation(*target.range) : Message(target.expected));
      return Place::skipped;
    };

    if (target.number) {
      *target.number = number_in(value);
      if (value.kind != Kind::number) return refuse_it();
    } else if (target.edge) {
      const auto name = index_in(edge_names, value);
      *target.edge = name < std::size(edge_names) ? Edge{static_cast<std::uint8_t>(name)}
                                                  : Edge::open;  // which nothing conflicts with
      if (name == std::size(edge_names)) return refuse_it();
    } else if (target.name == "role") {
      const auto name = index_in(role_names, value);
      if (name == std::size(role_names)) return refuse_it();
      Ball& ball = scene_.balls.back();
      ball.role = Role{static_cast<std::uint8_t>(name)};
      constexpr auto radius_seen = std::uint32_t{1} << index_of(ball_fields, "radius");
      if (!(containers_.back().seen & radius_seen)) ball.radius = radius_left_out(ball.role);
    } else if (target.text) {
      if (value.kind != Kind::text) return refuse_it();
      *target.text = value.text;
    } else if (target.name == "$schema") {
      if (value.kind != Kind::text) return refuse_it();
    } else if (target.name == "carom") {
      const double version = number_in(value);
      if (version > format_version) return refuse_newer(value, target.expected);
      if (version != format_version) return refuse_it();
    } else if (target.name == "throws") {
      const double throws = number_in(value);
      if (!(throws >= 1 && throws <= max_throws && throws == static_cast<int>(throws)))
        return refuse_it();
      scene_.throws = static_cast<int>(throws);
    } else if (target.name == "edges") {
      if (value.kind != Kind::object) {
        scene_.edges = {Edge::open, Edge::open, Edge::open, Edge::open};
        return refuse_it();
      }
      return Place::edges;
    } else {  // a list
      if (value.kind != Kind::array) return refuse_it();
      return target.name == "holes"       ? Place::holes
             : target.name == "obstacles" ? Place::obstacles
                                          : Place::balls;
    }
    return Place::skipped;
  }

  // This is the only error: anything else may be right in that version.
  Place refuse_newer(const Value& value, MessageCode expected) {
    errors_.clear();
    more_ = 0;
    stopped_ = true;
    report(value.offset, pointer_, {MessageCode::is_newer, {shortened(value.raw)}}, expected);
    return Place::skipped;
  }

  void on_key(const std::string& name) override {
    target_ = {};
    Container& container = containers_.back();
    with_fields(container.place, [&](const auto& fields, auto& object) {
      const std::size_t index = index_of(fields, name);
      if (index == std::size(fields)) {
        std::string keys;
        for (const auto& field : fields)
          keys += (keys.empty() ? "" : ", ") + std::string(field.name);
        return report(token_, pointer_, MessageCode::is_unknown_key, {MessageCode::one_of, {keys}});
      }
      const auto bit = std::uint32_t{1} << index;
      if (container.seen & bit)
        return report(token_, pointer_, MessageCode::is_given_twice, MessageCode::each_key_once);
      container.seen |= bit;
      const auto& field = fields[index];
      target_.name = field.name;
      target_.expected = field.expected;
      if (field.number) {
        target_.number = &field.number(object);
        target_.range = &field.range;
      }
      if (field.edge) target_.edge = &(object.*field.edge);
      if (field.text) target_.text = &(object.*field.text);
    });
  }

  void on_end() override {
    const Container& container = containers_.back();
    pointer_.resize(container.pointer_size);
    with_fields(container.place, [&](const auto& fields, auto& object) {
      for (std::size_t i = 0; i < std::size(fields); ++i) {
        const auto& field = fields[i];
        if (!field.required || container.seen >> i & 1) continue;
        report(container.offset, pointer_ + "/" + std::string(field.name), MessageCode::is_missing,
               expectation(field));
        if (field.number) field.number(object) = unread;
      }
    });
  }

  void on_too_deep() override {
    report(token_, pointer_, MessageCode::is_nested_too_deeply,
           {MessageCode::at_most_levels, {std::to_string(max_depth)}});
  }

  // `bytes_read` includes the byte that made the parser stop, which may be the one past the end.
  void on_syntax_error(std::size_t bytes_read, std::string_view what) override {
    std::size_t at = skip_space(cursor_);
    const auto skip = [&](char c) {
      if (at == bytes_.size() || bytes_[at] != c) return false;
      at = skip_space(at + 1);
      return true;
    };
    std::string_view expected;
    if (bytes_read <= cursor_) {
      // The last token began like a value and went on like none, as 08 does.
      at = token_;
      expected = any_value;
      while (!errors_.empty() && errors_.back().offset == at) errors_.pop_back();
    } else if (after_key_) {
      expected = skip(':') ? any_value : "a colon between key and value";
    } else if (containers_.empty()) {
      expected = started_ ? "the end of the file" : any_scene;
    } else {
      const Container& container = containers_.back();
      pointer_.resize(container.pointer_size);
      const bool comma = container.count > 0 && skip(',');
      if (container.array)
        expected = comma                 ? "another element, or no comma before"
                   : container.count > 0 ? "a comma or ]"
                                         : "an element or ]";
      else
        expected = comma                 ? "another key in double quotes, or no comma before"
                   : container.count > 0 ? "a comma or }"
                                         : "a key in double quotes or }";
    }

    if (expected == any_value && at < bytes_.size() &&
        std::string_view("+-.0123456789").find(bytes_[at]) != std::string_view::npos)
      expected = any_number;

    if (at == bytes_.size() && !started_) return report(at, {}, MessageCode::is_empty, expected);
    if (what.find("invalid string") == std::string_view::npos)
      report(at, pointer_, {MessageCode::is_not_json_found, {found(at)}}, expected);
    else
      bad_text(at, std::min(bytes_read - 1, bytes_.size()),
               what.find("UTF-8") != std::string_view::npos);
  }

  // For a text that begins at `begin` and goes wrong at `at`.
  void bad_text(std::size_t begin, std::size_t at, bool in_encoding) {
    using enum MessageCode;
    if (in_encoding)
      report(at, pointer_, is_not_json_utf8, "the file saved as UTF-8");
    else if (at == bytes_.size() || bytes_[at] == '\n' || bytes_[at] == '\r')
      report(begin, pointer_, is_not_json_open_text, "a closing double quote");
    else if (is_control(bytes_[at]))
      report(at, pointer_, {is_not_json_control, {found(at)}},
             R"(\t for a tab, \n for a line break)");
    else
      report(at, pointer_, is_not_json_escape,
             R"(\\ for a backslash; or \", \/, \b, \f, \n, \r, \t, \u and 4 hexadecimal digits)");
  }

  // The text at an offset, for a message; it may be anything, even no valid text.
  std::string found(std::size_t at) {
    if (at == bytes_.size()) return "the end of the file";
    const std::string_view rest = bytes_.substr(at);
    if (rest.starts_with('"')) {
      cursor_ = at;
      return shortened(next_token());
    }
    if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with('#'))
      return "a comment";
    if (rest.starts_with('\'')) return "a single quote";
    const auto word =
        rest.substr(0, rest.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-._"));
    if (!word.empty()) return shortened(word);
    const char c = rest.front();
    const auto byte = static_cast<unsigned char>(c);
    if (is_control(c) || byte >= 0x80) return "the byte 0x" + hex(byte);
    return std::string("'") + c + "'";
  }

  // Adds what check() finds, unless it only follows from what could not be read.
  void check_values() {
    std::set<std::string> refused;
    std::set<std::string> above_refused;  // and the refused themselves
    for (const Located& e : errors_) {
      refused.insert(e.error.pointer);
      for_each_above(e.error.pointer, [&](const auto& pointer) { above_refused.insert(pointer); });
    }
    Errors found;
    check(scene_, [&](Error error) {
      bool follows = above_refused.contains(error.pointer);
      for_each_above(error.pointer,
                     [&](const auto& pointer) { follows = follows || refused.contains(pointer); });
      if (follows) return;
      if (errors_.size() + found.size() == max_errors)
        ++more_;
      else
        found.push_back(std::move(error));
    });
    if (found.empty()) return;
    for (Located& located : find_offsets(bytes_, std::move(found)))
      errors_.push_back(std::move(located));
  }

  Scene scene_;
  Target target_;
  std::vector<Located> errors_;
  std::size_t more_ = 0;  // errors that found no room in errors_
};

template <class Name>
std::string quoted(std::span<const std::string_view> names, Name name) {
  return '"' + std::string(names[static_cast<std::size_t>(name)]) + '"';
}

// Appends the numbers and edges of an object as `"key": value`, with commas between. Left out is
// what is not required and as in `defaults`.
template <class T, std::size_t count>
void append_members(std::string& out, const Field<T> (&fields)[count], const T& object,
                    const T& defaults) {
  std::string_view separator;
  for (const Field<T>& field : fields) {
    const bool differs = field.number ? field.value(object) != field.value(defaults)
                                      : field.edge && object.*field.edge != defaults.*field.edge;
    if (!field.required && !differs) continue;
    out.append(separator).append("\"").append(field.name).append("\": ");
    separator = ", ";
    if (field.number)
      append_number(out, field.value(object));
    else
      out += quoted(edge_names, object.*field.edge);
  }
}

// Appends an array, an element a line.
template <class T, class F>
void append_list(std::string& out, const std::vector<T>& list, F append_element) {
  out += '[';
  for (const T& element : list) {
    out += &element == list.data() ? "\n    {" : ",\n    {";
    append_element(element);
    out += '}';
  }
  out += list.empty() ? "]" : "\n  ]";
}

}  // namespace

Result<Scene> read_scene(std::string_view json) {
  const ExactArithmetic exact;
  return Reader(json).read();
}

Errors locate(std::string_view json, Errors errors) {
  return in_file_order(json, find_offsets(json, std::move(errors)));
}

// A default is left out, unless the format requires it.
std::string write_scene(const Scene& scene) {
  const ExactArithmetic exact;
  const Scene defaults;
  std::string out;
  const auto begin = [&](std::string_view key) {
    out.append(out.empty() ? "{\n  \"" : ",\n  \"").append(key).append("\": ");
  };
  for (const Field<Scene>& field : scene_fields) {
    if (field.number) {
      if (!field.required && field.value(scene) == field.value(defaults)) continue;
      begin(field.name);
      append_number(out, field.value(scene));
    } else if (field.name == "carom") {
      begin(field.name);
      append_number(out, format_version);
    } else if (field.text && !(scene.*field.text).empty()) {
      begin(field.name);
      out += Json(scene.*field.text).dump(-1, ' ', false, Json::error_handler_t::replace);
    } else if (field.name == "edges" && scene.edges != defaults.edges) {
      begin(field.name);
      out += '{';
      append_members(out, edges_fields, scene.edges, defaults.edges);
      out += '}';
    } else if (field.name == "throws" && scene.throws != defaults.throws) {
      begin(field.name);
      append_number(out, scene.throws);
    } else if (field.name == "holes" && !scene.holes.empty()) {
      begin(field.name);
      append_list(out, scene.holes,
                  [&](const Hole& hole) { append_members(out, hole_fields, hole, Hole{}); });
    } else if (field.name == "obstacles" && !scene.obstacles.empty()) {
      begin(field.name);
      append_list(out, scene.obstacles, [&](const Obstacle& obstacle) {
        append_members(out, obstacle_fields, obstacle, Obstacle{});
      });
    } else if (field.name == "balls") {
      begin(field.name);
      append_list(out, scene.balls, [&](const Ball& ball) {
        append_members(out, ball_fields, ball, Ball{.radius = radius_left_out(ball.role)});
        if (ball.role != Role::neutral) out += ", \"role\": " + quoted(role_names, ball.role);
      });
    }
  }
  return out + "\n}\n";
}

}  // namespace carom
