#include "platform/script.hpp"

#include <gtest/gtest.h>

namespace {

using platform::parse_script;
using namespace std::chrono_literals;

TEST(Script, ReadsEveryAction) {
  const auto script = parse_script(R"({"at": 0.5, "click": [400, 300.5]}

{"at": 1, "click": [1, 2], "button": "right"}
{"at": 1, "move": [10, -20]}
{"key": "Shift+Tab", "at": 1.25}
{"at": 2, "screenshot": "a.png"}
{"at": 3, "press": [1, 2]}
{"at": 3, "release": [3, 4]}
{"at": 3, "wheel": -2.5}
{"at": 3, "key": "Ctrl+Up"}
{"at": 3, "hold": "Space"}
{"at": 3, "let_go": "Space"}
{"at": 3, "type": "Zoé"}
{"at": 3, "key": "Shift+Left"}
{"at": 3, "key": "Q"}
{"at": 3, "touch": [1, 2]}
{"at": 3, "touch_end": [3, 4], "finger": 2}
{"at": 3, "pad": "LB"}
{"at": 3, "pad_hold": "A"}
{"at": 3, "stick": ["right_y", -0.5]})");
  ASSERT_TRUE(script);
  ASSERT_EQ(script.value().size(), 19u);
  const auto& click = std::get<platform::Click>(script.value()[0].action);
  EXPECT_EQ(script.value()[0].at, 500ms);
  EXPECT_EQ(click.at, (app::Point{400, 300.5f}));
  EXPECT_EQ(click.button, app::PointerButton::left);
  EXPECT_EQ(std::get<platform::Click>(script.value()[1].action).button, app::PointerButton::right);
  EXPECT_EQ(std::get<platform::Move>(script.value()[2].action).to, (app::Point{10, -20}));
  const app::KeyPressed back = std::get<platform::Press>(script.value()[3].action).key;
  EXPECT_EQ(back.key, app::Key::back_tab);
  EXPECT_TRUE(back.shift);
  EXPECT_EQ(std::get<platform::Screenshot>(script.value()[4].action).file, "a.png");
  EXPECT_EQ(std::get<platform::PointerDown>(script.value()[5].action).at, (app::Point{1, 2}));
  EXPECT_EQ(std::get<platform::PointerUp>(script.value()[6].action).at, (app::Point{3, 4}));
  EXPECT_EQ(std::get<platform::Wheel>(script.value()[7].action).notches, -2.5f);
  const app::KeyPressed up = std::get<platform::Press>(script.value()[8].action).key;
  EXPECT_EQ(up.key, app::Key::up);
  EXPECT_TRUE(up.ctrl && !up.shift);
  EXPECT_EQ(std::get<platform::Hold>(script.value()[9].action).key, app::Key::space);
  EXPECT_EQ(std::get<platform::LetGo>(script.value()[10].action).key, app::Key::space);
  EXPECT_EQ(std::get<platform::Type>(script.value()[11].action).text, "Zoé");
  const app::KeyPressed left = std::get<platform::Press>(script.value()[12].action).key;
  EXPECT_EQ(left.key, app::Key::left);
  EXPECT_TRUE(left.shift && !left.ctrl);
  EXPECT_EQ(std::get<platform::Press>(script.value()[13].action).key.key, app::Key::q);
  const app::Finger down = std::get<platform::Touch>(script.value()[14].action).finger;
  EXPECT_EQ(down.phase, app::Finger::Phase::down);
  EXPECT_EQ(down.at, (app::Point{1, 2}));
  const app::Finger up_again = std::get<platform::Touch>(script.value()[15].action).finger;
  EXPECT_EQ(up_again.phase, app::Finger::Phase::up);
  EXPECT_EQ(up_again.id, 2);
  EXPECT_EQ(std::get<platform::PadPress>(script.value()[16].action).button,
            app::PadButton::left_shoulder);
  const app::Input held = std::get<platform::PadInput>(script.value()[17].action).input;
  EXPECT_EQ(std::get<app::PadPressed>(held).button, app::PadButton::a);
  const app::Input stick = std::get<platform::PadInput>(script.value()[18].action).input;
  EXPECT_EQ(std::get<app::PadMoved>(stick).axis, app::PadAxis::right_y);
  EXPECT_EQ(std::get<app::PadMoved>(stick).value, -0.5f);
}

TEST(Script, EmptyIsFine) {
  EXPECT_TRUE(parse_script(""));
  EXPECT_TRUE(parse_script("\n\r\n  \n"));
}

struct Bad {
  const char* text;
  const char* message;
};

/// The name of a test has no address in it.
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.text; }

class BadScript : public testing::TestWithParam<Bad> {};

TEST_P(BadScript, IsReportedWithItsLine) {
  const auto script = parse_script(GetParam().text);
  ASSERT_FALSE(script);
  EXPECT_EQ(carom::to_string(script.errors().front(), "file"), GetParam().message);
}

constexpr const char* form =
    "an object with \"at\" and one of \"click\", \"move\", \"press\", \"release\", \"wheel\", "
    "\"key\", \"hold\", \"let_go\", \"type\", \"touch\", \"touch_move\", \"touch_end\", \"pad\", "
    "\"pad_hold\", \"pad_let_go\", \"stick\", \"screenshot\", \"print\"";
const std::string not_json = std::string("file:2: is no JSON object; expected ") + form;
const std::string unknown = std::string("file:1: /wait: is an unknown key; expected ") + form;
const std::string nothing = std::string("file:1: is {\"at\":1}; expected ") + form;
const std::string both =
    std::string("file:1: is {\"at\":1,\"move\":[1,2],\"key\":\"R\"}; expected ") + form;

INSTANTIATE_TEST_SUITE_P(
    All, BadScript,
    testing::Values(
        Bad{"{\"at\":1,\"key\":\"R\"}\n{\"at\":", not_json.c_str()},
        Bad{"{\"at\":1,\"wait\":2}", unknown.c_str()}, Bad{"{\"at\":1}", nothing.c_str()},
        Bad{"{\"at\":1,\"move\":[1,2],\"key\":\"R\"}", both.c_str()},
        Bad{"{\"at\":-1,\"move\":[1,2]}",
            "file:1: /at: is -1; expected a time from 0 to 86400 (s)"},
        Bad{"{\"at\":1,\"move\":[1,\"x\"]}",
            "file:1: /move: is [1,\"x\"]; expected a point of the window, [x, y] (px)"},
        Bad{"{\"at\":1,\"click\":[1,1e300]}",
            "file:1: /click: is [1,1e+300]; expected a point of the window, [x, y] (px)"},
        Bad{"{\"at\":1,\"key\":\"F9\"}",
            "file:1: /key: is \"F9\"; expected Return, Space, Tab, Shift+Tab, Escape, Left, "
            "Right, Up, Down (these four also with Shift+ or Ctrl+), A to Z, Backspace, +, -, ., "
            "F1, F10, Ctrl+C or Ctrl+V"},
        Bad{"{\"at\":1,\"hold\":\"Ctrl+R\"}",
            "file:1: /hold: is \"Ctrl+R\"; expected Return, Space, Tab, Shift+Tab, Escape, Left, "
            "Right, Up, Down (these four also with Shift+ or Ctrl+), A to Z, Backspace, +, -, ., "
            "F1, F10, Ctrl+C or Ctrl+V"},
        Bad{"{\"at\":1,\"pad\":\"Z\"}",
            "file:1: /pad: is \"Z\"; expected Up, Down, Left, Right, A, B, X, Y, Start, Back, LB "
            "or "
            "RB"},
        Bad{"{\"at\":1,\"stick\":[\"left_trigger\",-0.5]}",
            "file:1: /stick: is [\"left_trigger\",-0.5]; expected an axis and how far, such as "
            "[\"left_x\", -0.5]; left_x, left_y, right_x, right_y from -1 to 1, left_trigger, "
            "right_trigger from 0 to 1"},
        Bad{"{\"at\":1,\"move\":[1,2],\"finger\":1}",
            "file:1: /finger: is 1; expected a number from 0 to 9, beside a touch"},
        Bad{"{\"at\":1,\"wheel\":1001}",
            "file:1: /wheel: is 1001; expected notches, from -1000 to 1000"},
        Bad{"{\"at\":1,\"type\":47}", "file:1: /type: is 47; expected a text"},
        Bad{"{\"at\":1,\"print\":false}", "file:1: /print: is false; expected true"},
        Bad{"{\"at\":1,\"move\":[1,2],\"button\":\"left\"}",
            "file:1: /button: is \"left\"; expected \"left\" or \"right\", beside \"click\""},
        Bad{"{\"at\":1,\"screenshot\":\"a\\u0000.png\"}",
            "file:1: /screenshot: is \"a\\u0000.png\"; expected the name of a PNG file to write"},
        Bad{"{\"at\":1,\"screenshot\":\"\"}",
            "file:1: /screenshot: is \"\"; expected the name of a PNG file to write"},
        Bad{"{\"at\":2,\"key\":\"R\"}\n{\"at\":1,\"key\":\"R\"}",
            "file:2: /at: goes back in time; expected lines in the order of time"}));

TEST(Script, AllErrorsAreListed) {
  const auto script = parse_script("x\n{\"at\":1,\"key\":\"R\"}\ny\n");
  ASSERT_FALSE(script);
  ASSERT_EQ(script.errors().size(), 2u);
  EXPECT_EQ(script.errors()[1].line, 3u);
}

}  // namespace
