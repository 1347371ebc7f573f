#include "app/play/stillness.hpp"

namespace app {

bool Stillness::changed() const {
  if (ahead_->balls_left() != in_play_) return true;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (ahead_->in_play(i) && carom::length(ahead_->ball(i).position - places_[i]) >= least)
      return true;
  return false;
}

void Stillness::look(const carom::World& now) {
  if (still_) return;
  if (!ahead_) {
    ahead_ = now;
    steps_ = 0;
    in_play_ = now.balls_left();
    places_.clear();
    for (std::size_t i = 0; i < now.size(); ++i) places_.push_back(now.ball(i).position);
  }
  for (int i = 0; i < slice && steps_ < horizon; ++i, ++steps_) {
    ahead_->step();
    if (changed()) {
      ahead_.reset();
      return;
    }
  }
  still_ = steps_ >= horizon;
}

}  // namespace app
