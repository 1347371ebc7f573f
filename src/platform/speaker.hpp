#pragma once

#include <cstdint>
#include <span>

#include "app/audio/mixer.hpp"

namespace platform {

/// The loudspeaker of the desktop or browser. Opened with the first sound; on the desktop closed
/// when nothing was heard for a while, so that silence costs nothing. Without one there is silence
/// and no error. SDL must be there as long as it lives.
class Speaker {
 public:
  Speaker() = default;
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  /// Once a frame: plays what is new. `volume`: per cent.
  void play(std::span<const app::SoundEvent> sounds, int volume);

 private:
  bool open();
  void close();
  static void fill(void* speaker, unsigned char* bytes, int size);

  app::Mixer mixer_;  ///< while the device is open, its thread's but for a lock
  unsigned device_ = 0;
  bool missing_ = false;          ///< there is none, or it was refused
  std::uint64_t last_heard_ = 0;  ///< ms
};

}  // namespace platform
