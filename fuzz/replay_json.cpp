#include <cstddef>
#include <cstdint>

#include "replay_properties.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = replay::read_json({reinterpret_cast<const char*>(data), size});
  if (read)
    fuzz::check_replay(read.value());
  else
    fuzz::require(!read.errors().empty(), "a refusal says why");
  return 0;
}
