#pragma once

#include <SDL.h>
#include <memory>
#include <stdexcept>

namespace platform {

struct Destroy {
  void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
  void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
  void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
template <class T>
using Owned = std::unique_ptr<T, Destroy>;

/// Owner of an object that SDL has just made; throws SDL's message if it could not.
template <class T>
Owned<T> owned(T* made) {
  if (!made) throw std::runtime_error(SDL_GetError());
  return Owned<T>(made);
}

}  // namespace platform
