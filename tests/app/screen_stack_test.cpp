#include "app/screens/screen_stack.hpp"

#include <gtest/gtest.h>

#include "app/screens/make_screen.hpp"

namespace {

using namespace std::chrono_literals;

enum Button : app::ButtonId { yes, no };

/// Notes all that it is asked to do.
struct Probe : app::Screen {
  explicit Probe(std::vector<std::string>& told, std::string called, app::Cover how = {})
      : log(told), name(std::move(called)), covers(how) {}
  void resize(const app::View&) override { log.push_back(name + " resized"); }
  app::Navigation event(const app::Input& input) override {
    log.push_back(name + (std::holds_alternative<app::KeyReleased>(input) ? " let go" : " event"));
    return std::exchange(next, app::Stay{});
  }
  app::Navigation iterate(app::nanoseconds) override {
    log.push_back(name + " time");
    return app::Stay{};
  }
  void draw(app::Canvas&) const override { log.push_back(name + " drawn"); }
  std::string describe() const override { return name; }
  bool animating() const override { return moves; }
  app::Cover cover() const override { return covers; }
  std::optional<app::Ask> opens() override { return std::exchange(window, {}); }
  app::Navigation answered(app::ButtonId button) override {
    log.push_back(name + " answered " + std::to_string(button));
    return std::exchange(next, app::Stay{});
  }

  std::vector<std::string>& log;
  std::string name;
  app::Cover covers;
  bool moves = false;
  app::Navigation next;
  std::optional<app::Ask> window;
};

app::Ask question(bool message = false) {
  return {.dialog = app::Dialog("Sure?", {}, {{yes, "Yes"}, {no, "No"}}),
          .line = "a question",
          .shortcuts = {{app::Key::backspace, no}},
          .message = message};
}

class ScreenStackTest : public testing::Test {
 protected:
  ScreenStackTest() { show("below"); }
  Probe& show(const std::string& name) {
    auto made = std::make_unique<Probe>(log, name);
    Probe& probe = *made;
    stack.show(std::move(made));
    log.clear();
    return probe;
  }
  Probe& cover(app::Cover how, const std::string& name = "over") {
    auto made = std::make_unique<Probe>(log, name, how);
    Probe& probe = *made;
    stack.cover(std::move(made));
    log.clear();
    return probe;
  }
  void draw() {
    app::DrawList list;
    app::Canvas canvas{list, font, app::View::of(800, 600)};
    stack.draw(canvas);
  }
  Probe& top() { return dynamic_cast<Probe&>(stack.top()); }
  using Log = std::vector<std::string>;

  app::Atlas atlas;
  app::Font font{atlas};
  app::Sounds sounds;
  Log log;
  app::ScreenStack stack{sounds};
};

TEST_F(ScreenStackTest, AScreenCoveredWholeIsNeitherDrawnNorGetsTime) {
  top().moves = true;
  cover(app::Cover::whole);
  draw();
  stack.iterate(10ms);
  EXPECT_EQ(log, (Log{"over drawn", "over time"}));
  EXPECT_FALSE(stack.animating());
}

TEST_F(ScreenStackTest, AScreenThatWaitsIsDrawnAndGetsNoTime) {
  top().moves = true;
  cover(app::Cover::waiting);
  draw();
  stack.iterate(10ms);
  EXPECT_EQ(log, (Log{"below drawn", "over drawn", "over time"}));
  EXPECT_FALSE(stack.animating());
}

TEST_F(ScreenStackTest, AScreenThatRunsOnIsDrawnAndGetsTime) {
  top().moves = true;
  cover(app::Cover::running);
  draw();
  stack.iterate(10ms);
  EXPECT_EQ(log, (Log{"below drawn", "over drawn", "below time", "over time"}));
  EXPECT_TRUE(stack.animating());
  cover(app::Cover::waiting, "third");
  EXPECT_FALSE(stack.animating()) << "the third makes both wait";
}

TEST_F(ScreenStackTest, InputGoesToTheUppermostAndKeysLetGoToAll) {
  cover(app::Cover::waiting);
  stack.event(app::KeyPressed{app::Key::left});
  stack.event(app::KeyReleased{app::Key::left});
  EXPECT_EQ(log, (Log{"over event", "below let go", "over let go"}));
}

TEST_F(ScreenStackTest, ScreensThatAreSeenAreResizedAtOnceTheOthersWhenTheyComeToLight) {
  cover(app::Cover::whole);
  cover(app::Cover::waiting, "third");
  stack.resize(app::View::of(640, 480));
  EXPECT_EQ(log, (Log{"over resized", "third resized"}));
  log.clear();
  stack.apply(app::Back{});
  EXPECT_EQ(log, Log{}) << "it has been seen all the time";
  stack.apply(app::Back{});
  EXPECT_EQ(log, (Log{"below resized"}));
}

TEST_F(ScreenStackTest, BackFromTheOnlyScreenDoesNothing) {
  stack.apply(app::Back{});
  EXPECT_EQ(stack.top().describe(), "below");
}

TEST_F(ScreenStackTest, AnAnswerClosesTheQuestionAndReachesTheScreenThatAsked) {
  top().next = question();
  stack.event(app::KeyPressed{});
  EXPECT_EQ(stack.top().describe(), "a question");
  stack.event(app::KeyPressed{app::Key::right});
  EXPECT_EQ(stack.top().describe(), "a question") << "no button was chosen";
  log.clear();
  stack.event(app::KeyPressed{app::Key::enter});
  EXPECT_EQ(log, (Log{"below answered 0"}));
  EXPECT_EQ(stack.top().describe(), "below");
}

TEST_F(ScreenStackTest, ShortcutsAnswerAndWhatTheAnswerLeadsToIsReturned) {
  Probe& below = top();
  below.next = question();
  stack.event(app::KeyPressed{});
  below.next = app::PlayLevel{.level = 7};
  log.clear();
  const app::Navigation left = stack.event(app::KeyPressed{app::Key::backspace});
  EXPECT_EQ(log, (Log{"below answered 1"}));
  ASSERT_TRUE(std::holds_alternative<app::PlayLevel>(left));
  EXPECT_EQ(std::get<app::PlayLevel>(left).level, 7U);
  EXPECT_EQ(stack.top().describe(), "below");
}

TEST_F(ScreenStackTest, AMessageIsClosedWithoutAnAnswer) {
  stack.apply(question(true));
  stack.event(app::KeyPressed{app::Key::enter});
  EXPECT_EQ(stack.top().describe(), "below");
  EXPECT_EQ(log, (Log{}));
}

TEST_F(ScreenStackTest, AScreenOpensItsWindowsWheneverItIsTheUppermost) {
  Probe& below = top();
  cover(app::Cover::waiting);
  below.window = question();
  stack.apply(app::Stay{});
  EXPECT_EQ(stack.top().describe(), "over") << "not while it is covered";
  stack.apply(app::Back{});
  EXPECT_EQ(stack.top().describe(), "a question");
}

TEST_F(ScreenStackTest, RequestsForOtherScreensAreReturned) {
  top().next = app::ShowSettings{.page = 2};
  const app::Navigation left = stack.event(app::KeyPressed{});
  ASSERT_TRUE(std::holds_alternative<app::ShowSettings>(left));
  EXPECT_TRUE(app::lies_over(left));
  EXPECT_FALSE(app::lies_over(app::ShowTitle{}));
}

}  // namespace
