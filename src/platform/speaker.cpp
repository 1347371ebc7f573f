#include "platform/speaker.hpp"

#include <SDL.h>

namespace platform {
namespace {

constexpr Uint64 patience = 10'000;  ///< ms of silence before the device is given back
#ifdef __EMSCRIPTEN__
// Events of a page's sound that wait their turn still reach SDL after it has freed the device.
constexpr bool closes = false;
#else
constexpr bool closes = true;
#endif
constexpr Uint16 samples = 512;  ///< 11 ms: what is seen and heard is felt as one

}  // namespace

Speaker::~Speaker() { close(); }

void Speaker::play(std::span<const app::SoundEvent> sounds, int volume) {
  if (sounds.empty() && device_ == 0) return;
  if (device_ == 0 && !open()) return;
  SDL_LockAudioDevice(device_);
  mixer_.set_volume(volume);
  mixer_.play(sounds);
  const bool idle = mixer_.idle();
  SDL_UnlockAudioDevice(device_);
  if (!idle)
    last_heard_ = SDL_GetTicks64();
  else if (closes && SDL_GetTicks64() - last_heard_ > patience)
    close();
}

bool Speaker::open() {
  if (missing_) return false;
  SDL_AudioSpec wanted{};
  wanted.freq = app::Mixer::rate;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = 2;
  wanted.samples = samples;
  wanted.callback = fill;
  wanted.userdata = this;
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) == 0)
    device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
  missing_ = device_ == 0;
  if (!missing_) SDL_PauseAudioDevice(device_, 0);
  return !missing_;
}

void Speaker::close() {
  if (device_ != 0) SDL_CloseAudioDevice(device_);
  device_ = 0;
}

void Speaker::fill(void* speaker, unsigned char* bytes, int size) {
  static_cast<Speaker*>(speaker)->mixer_.mix(
      {reinterpret_cast<float*>(bytes), static_cast<std::size_t>(size) / sizeof(float)});
}

}  // namespace platform
