#include "carom/balls.hpp"

namespace carom {

namespace {

template <class Self, class Action>
void for_each_array(Self& balls, Action action) {
  action(balls.x);
  action(balls.y);
  action(balls.vx);
  action(balls.vy);
  action(balls.ax);
  action(balls.ay);
  action(balls.radius);
  action(balls.solidity);
  action(balls.id);
  action(balls.role);
}

}  // namespace

void Balls::reserve(std::size_t count) {
  for_each_array(*this, [&](auto& array) { array.reserve(count); });
}

void Balls::push_back(const Ball& ball) {
  x.push_back(ball.position.x);
  y.push_back(ball.position.y);
  vx.push_back(ball.velocity.x);
  vy.push_back(ball.velocity.y);
  ax.push_back(ball.acceleration.x);
  ay.push_back(ball.acceleration.y);
  radius.push_back(ball.radius);
  solidity.push_back(ball.solidity);
  id.push_back(ball.id);
  role.push_back(ball.role);
}

void Balls::swap_out(std::size_t i) {
  for_each_array(*this, [&](auto& array) {
    array[i] = array.back();
    array.pop_back();
  });
}

}  // namespace carom
