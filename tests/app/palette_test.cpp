#include "app/graphics/palette.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>

#include "platform/null_platform.hpp"

namespace {

using app::Color;
using app::Colours;
using app::Palette;

constexpr std::array everything{Colours::standard, Colours::red_green, Colours::blue_yellow,
                                Colours::high_contrast};

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

// Machado, Oliveira and Fernandes 2009, severity 1, on linear RGB.
constexpr Matrix normal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix protanopia{{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia{{{0.367322, 0.860646, -0.227968},
                               {0.280085, 0.672501, 0.047413},
                               {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix tritanopia{{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}};
constexpr Matrix greyscale{
    {{0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}, {0.2126, 0.7152, 0.0722}}};

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Rgb seen(Color color, const Matrix& eye) {
  const Rgb in{linear(color.r), linear(color.g), linear(color.b)};
  Rgb out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[i] += eye[i][j] * in[j];
    out[i] = std::clamp(out[i], 0.0, 1.0);
  }
  return out;
}

double luminance(const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// WCAG's contrast, from 1 to 21.
double contrast(Color a, Color b, const Matrix& eye = normal) {
  const double one = luminance(seen(a, eye)) + 0.05;
  const double other = luminance(seen(b, eye)) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

/// CIE 1976, in L*a*b*; 2.3 can just be told apart.
double difference(Color a, Color b, const Matrix& eye) {
  const auto lab = [&](Color color) {
    const Rgb c = seen(color, eye);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
    const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
    return Rgb{116 * y - 16, 500 * (x - y), 200 * (y - z)};
  };
  const Rgb one = lab(a);
  const Rgb other = lab(b);
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

/// The least difference between two colours that mean different things.
double least_difference(const Palette& p, const Matrix& eye) {
  return std::min(
      {difference(p.ball, p.felt, eye), difference(p.ball, p.felt_lit, eye),
       difference(p.ball, app::palette::ivory, eye), difference(p.accents[0], p.accents[1], eye),
       difference(p.allowed, p.refused, eye), difference(p.strength[0], p.strength[2], eye)});
}

TEST(Palette, MeaningsAreFarApartForTheEyesItIsMadeFor) {
  EXPECT_GT(least_difference(Palette::of(Colours::standard), normal), 40);
  EXPECT_GT(least_difference(Palette::of(Colours::red_green), protanopia), 40);
  EXPECT_GT(least_difference(Palette::of(Colours::red_green), deuteranopia), 40);
  EXPECT_GT(least_difference(Palette::of(Colours::blue_yellow), tritanopia), 40);
  EXPECT_GT(least_difference(Palette::of(Colours::high_contrast), greyscale), 15);
}

// Otherwise it would not be worth choosing.
TEST(Palette, IsBetterThanTheStandardForTheEyesItIsMadeFor) {
  const double standard = least_difference(Palette::of(Colours::standard), deuteranopia);
  EXPECT_GT(least_difference(Palette::of(Colours::red_green), deuteranopia), standard);
  EXPECT_GT(least_difference(Palette::of(Colours::red_green), protanopia),
            least_difference(Palette::of(Colours::standard), protanopia));
  EXPECT_GT(least_difference(Palette::of(Colours::blue_yellow), tritanopia),
            least_difference(Palette::of(Colours::standard), tritanopia));
  EXPECT_GT(
      contrast(Palette::of(Colours::high_contrast).ball, Palette::of(Colours::high_contrast).felt),
      5);
}

TEST(Palette, CanBePlayedFromAGreyPicture) {
  for (const Colours colours : everything) {
    const Palette& p = Palette::of(colours);
    SCOPED_TRACE(static_cast<int>(colours));
    EXPECT_GT(contrast(p.ball, p.felt, greyscale), 1.3);
    EXPECT_GT(contrast(app::palette::ivory, p.ball, greyscale), 2);
    EXPECT_GT(contrast(app::palette::ivory, p.felt, greyscale), 7);
  }
}

TEST(Palette, TextInItCanBeRead) {
  for (const Colours colours : everything) {
    const Palette& p = Palette::of(colours);
    SCOPED_TRACE(static_cast<int>(colours));
    for (const Color accent : p.accents) {
      EXPECT_GT(contrast(accent, app::palette::ink), 7);  // on the bar of who is on
      EXPECT_GT(contrast(accent, app::palette::slate_bottom), 4.5);
    }
    EXPECT_GT(contrast(p.allowed, app::palette::slate_bottom), 4.5);
    EXPECT_GT(contrast(p.refused, app::palette::slate_bottom), 4.5);
  }
}

/// Between the lightest and the darkest pixel there.
double contrast_within(const app::Image& picture, const app::Rect& area) {
  std::array<double, 256> light{};
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = linear(static_cast<std::uint8_t>(i));
  double darkest = 1;
  double lightest = 0;
  for (int y = static_cast<int>(area.y); y < static_cast<int>(area.bottom()); ++y) {
    for (int x = static_cast<int>(area.x); x < static_cast<int>(area.right()); ++x) {
      const Color pixel = picture.at(x, y);
      const double one = luminance({light[pixel.r], light[pixel.g], light[pixel.b]});
      darkest = std::min(darkest, one);
      lightest = std::max(lightest, one);
    }
  }
  return (lightest + 0.05) / (darkest + 0.05);
}

// WCAG's level AA, measured in the picture: on skies and felts, too.
TEST(Palette, EveryTextStandsOutFromWhatIsBeneath) {
  using app::Key;
  using namespace std::chrono_literals;
  for (const Colours colours : everything) {
    app::MemoryStore store;
    platform::NullPlatform game(app::Language::en, 800, 600, {}, store);
    app::Settings settings = game.app().settings().get();
    settings.colours = colours;
    game.app().settings().set(settings);
    const auto check = [&](const char* screen) {
      const app::Image picture = game.picture();
      int texts = 0;
      const app::DrawList& list = game.app().draw();
      for (std::size_t i = list.covered; i < list.boxes.size(); ++i) {
        const app::Box& box = list.boxes[i];
        if (box.kind != app::Box::Kind::text) continue;
        ++texts;
        EXPECT_GE(contrast_within(picture, box.area), 4.5)
            << box.text << " on " << screen << " in palette " << static_cast<int>(colours);
      }
      EXPECT_GT(texts, 3) << screen;
    };
    const auto press = [&](Key key, int times = 1) {
      for (int i = 0; i < times; ++i) game.app().event(app::KeyPressed{key});
    };
    check("the title");
    press(Key::settings);
    check("the settings");
    press(Key::escape);
    press(Key::help);
    check("help");
    press(Key::escape);
    press(Key::enter);
    game.pass(3s);
    press(Key::up);
    check("the table");
    press(Key::escape);
    press(Key::escape);
    press(Key::back_tab, 2);
    press(Key::enter);
    press(Key::tab, 4);
    press(Key::enter);
    check("the levels");
    press(Key::tab);
    press(Key::enter);
    game.pass(3s);
    press(Key::up);
    check("a level");
  }
}

// The colours chosen are those drawn, at once.
TEST(Palette, ThePictureHasItsColours) {
  app::MemoryStore store;
  ASSERT_TRUE(
      store.save("settings.json", R"({"angry-balls-settings": 1, "colours": "high-contrast"})")
          .ok());
  platform::NullPlatform chosen(app::Language::en, 800, 600, {}, store);
  platform::NullPlatform standard(app::Language::en, 800, 600);
  const auto drawn_with = [](platform::NullPlatform& game, Color color) {
    const auto& vertices = game.app().draw().vertices;
    return std::ranges::any_of(vertices, [&](const app::Vertex& v) { return v.color == color; });
  };
  const Color felt = Palette::of(Colours::standard).felt_dark;
  const Color dark = Palette::of(Colours::high_contrast).felt_dark;
  EXPECT_TRUE(drawn_with(standard, felt));
  EXPECT_FALSE(drawn_with(standard, dark));
  EXPECT_TRUE(drawn_with(chosen, dark));
  EXPECT_FALSE(drawn_with(chosen, felt));
}

}  // namespace
