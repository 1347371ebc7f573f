#include <cstddef>
#include <cstdint>
#include <string>

#include "replay/text_of.hpp"
#include "replay_properties.hpp"

// A text as it is, or, after the letter P, a payload to be packed: a mutation of packed bytes
// seldom unpacks.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with('P')) text = recorded::text_of(text.substr(1));
  const auto read = replay::read_text(text);
  if (read)
    fuzz::check_replay(read.value());
  else
    fuzz::require(!read.errors().empty(), "a refusal says why");
  return 0;
}
