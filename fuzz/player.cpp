#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "play.hpp"

namespace {

constexpr std::size_t bytes_an_action = 4;  ///< what, how long after the last, and two values
constexpr std::size_t most_actions = 100;

}  // namespace

// A player who does anything: every four bytes are something that he does, so that games are really
// played, where bytes taken as a script's text nearly always are none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  platform::Script script;
  std::chrono::milliseconds now{0};
  const std::size_t count = std::min(size / bytes_an_action, most_actions);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const byte = data + i * bytes_an_action;
    now += std::chrono::milliseconds{byte[1] * byte[1] / 16};
    const app::Point at{static_cast<float>(byte[2]) * 800 / 256,
                        static_cast<float>(byte[3]) * 600 / 256};
    const auto key = static_cast<app::Key>(byte[2] % (static_cast<int>(app::Key::z) + 1));
    script.push_back({.at = now, .action = platform::Print{}});
    auto& action = script.back().action;
    // The last values are fingers and a gamepad, so that the others keep what they mean.
    switch (byte[0] < 244 ? byte[0] % 10 : byte[0]) {
      case 0:
        action = platform::Click{at, app::PointerButton::left};
        break;
      case 1:
        action = platform::Click{at, app::PointerButton::right};
        break;
      case 2:
        action = platform::Move{at};
        break;
      case 3:
        action = platform::PointerDown{at};
        break;
      case 4:
        action = platform::PointerUp{at};
        break;
      case 5:
        action = platform::Wheel{static_cast<float>(byte[2]) / 16 - 8};
        break;
      case 6:
        action = platform::Press{{key, byte[3] % 2 != 0, byte[3] / 2 % 2 != 0}};
        break;
      case 7:
        action = platform::Hold{key};
        break;
      case 8:
        action = platform::LetGo{key};
        break;
      case 244:
      case 245:
      case 246:
      case 247:
        action = platform::Touch{{byte[0] % 2, static_cast<app::Finger::Phase>(byte[1] % 3), at}};
        break;
      case 248:
      case 249:
        action = platform::PadPress{static_cast<app::PadButton>(byte[2] % 12)};
        break;
      case 250:
        action = platform::PadInput{app::PadPressed{static_cast<app::PadButton>(byte[2] % 12)}};
        break;
      case 251:
        action = platform::PadInput{app::PadReleased{static_cast<app::PadButton>(byte[2] % 12)}};
        break;
      case 252:
      case 253:
        action = platform::PadInput{app::PadMoved{static_cast<app::PadAxis>(byte[2] % 6),
                                                  static_cast<float>(byte[3]) / 127.5f - 1}};
        break;
      case 254:
        action = platform::PadInput{app::PadUnplugged{}};
        break;
      default:
        action = platform::Type{std::string(1, static_cast<char>(' ' + byte[2] % 95))};
    }
  }
  fuzz::play(script);
  return 0;
}
