// On a telephone, whatever the density of its pixels, every button is large enough for a finger and
// every text for an eye.

#include "app/every_screen.hpp"

namespace {

using app::Box;

class FingerTargets
    : public testing::TestWithParam<std::tuple<std::pair<int, int>, int, app::Language>> {};

TEST_P(FingerTargets, AreLargeEnough) {
  const auto [size, density, language] = GetParam();
  const float least = app::finger_target * static_cast<float>(density);
  every_screen::Walk walk(
      {.language = language,
       .width = size.first,
       .height = size.second,
       .density = density,
       .touch = true},
      [&, density = density](const every_screen::Shown& shown) {
        for (const Box& button : shown.buttons()) {
          EXPECT_GE(button.area.w, least) << '"' << button.text << "\" of " << shown.where;
          EXPECT_GE(button.area.h, least) << '"' << button.text << "\" of " << shown.where;
        }
        const app::DrawList& list = shown.draw();
        for (std::size_t i = list.covered; i < list.boxes.size(); ++i)
          if (list.boxes[i].kind != Box::Kind::button) {
            EXPECT_GE(list.boxes[i].text_size, 12 * density)
                << '"' << list.boxes[i].text << "\" of " << shown.where;
          }
      });
  walk.all();
}

INSTANTIATE_TEST_SUITE_P(
    OnTelephones, FingerTargets,
    testing::Combine(testing::Values(std::pair{390, 844}, std::pair{844, 390}, std::pair{640, 360}),
                     testing::Values(1, 3), testing::ValuesIn(app::all_languages())),
    [](const auto& test) {
      return std::to_string(std::get<0>(test.param).first) + "_at_" +
             std::to_string(std::get<1>(test.param)) + "_" +
             std::string(app::code_of(std::get<2>(test.param)));
    });

}  // namespace
