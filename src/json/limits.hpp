#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "json/json.hpp"

namespace json {

/// Limits of a document. A parser without limits takes memory for whatever a stranger wrote, and
/// what walks through a deep document overflows the stack.
struct Limits {
  std::size_t depth = 16;        ///< arrays and objects within each other
  std::size_t values = 100'000;  ///< in all: keys, elements
};

/// Only counts, by nlohmann's SAX interface; returning false stops the parser.
class LimitCheck {
 public:
  using Json = nlohmann::json;
  explicit LimitCheck(Limits limits) : left_(limits) {}

  bool null() { return count(); }
  bool boolean(bool) { return count(); }
  bool number_integer(Json::number_integer_t) { return count(); }
  bool number_unsigned(Json::number_unsigned_t) { return count(); }
  bool number_float(Json::number_float_t, const std::string&) { return count(); }
  bool string(const std::string&) { return count(); }
  bool binary(const Json::binary_t&) { return false; }
  bool key(const std::string&) { return count(); }
  bool start_object(std::size_t) { return open(); }
  bool start_array(std::size_t) { return open(); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) { return false; }

 private:
  bool count() { return left_.values-- > 0; }
  bool open() { return left_.depth-- > 0 && count(); }
  bool close() {
    ++left_.depth;
    return true;
  }

  Limits left_;
};

/// The document; discarded (is_discarded()) if it is no JSON or beyond the limits.
template <class Json = nlohmann::json>
Json parse(std::string_view text, Limits limits = {}) {
  LimitCheck check(limits);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &check))
    return Json(nlohmann::detail::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

}  // namespace json
