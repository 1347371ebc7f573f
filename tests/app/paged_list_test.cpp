#include "app/widgets/paged_list.hpp"

#include <gtest/gtest.h>

namespace {

using app::PagedList;

class PagedListTest : public testing::Test {
 protected:
  static constexpr app::ButtonId own = PagedList::first_own;

  void show(std::size_t page, std::size_t items) { list.show(page, items, 4, {{own, "Title"}}); }
  std::vector<app::ButtonId> ids() const {
    std::vector<app::ButtonId> all;
    for (const auto& button : list.buttons.all()) all.push_back(button.id);
    return all;
  }

  PagedList list{app::Words(app::Language::en)};
};

TEST_F(PagedListTest, OnePageHasNothingToTurnIt) {
  show(0, 4);
  EXPECT_EQ(list.pages(), 1u);
  EXPECT_EQ(ids(), (std::vector<app::ButtonId>{0, 1, 2, 3, own}));
}

TEST_F(PagedListTest, PagesGoRoundAndTheLastHasTheRest) {
  show(0, 9);
  EXPECT_EQ(list.pages(), 3u);
  EXPECT_EQ(list.count(), 4u);
  EXPECT_EQ(list.page_of(PagedList::previous), 2u);
  EXPECT_EQ(list.page_of(PagedList::next), 1u);
  EXPECT_FALSE(list.page_of(own));
  EXPECT_FALSE(list.page_of(0));
  show(2, 9);
  EXPECT_EQ(list.first(), 8u);
  EXPECT_EQ(list.count(), 1u);
  EXPECT_EQ(ids(), (std::vector<app::ButtonId>{0, PagedList::previous, PagedList::next, own}));
  EXPECT_EQ(list.page_of(PagedList::next), 0u);
}

TEST_F(PagedListTest, APageBeyondTheEndIsTheLast) {
  show(7, 9);
  EXPECT_EQ(list.first(), 8u);
  show(7, 0);
  EXPECT_EQ(list.first(), 0u);
  EXPECT_EQ(list.count(), 0u);
  EXPECT_EQ(list.pages(), 1u);
}

TEST_F(PagedListTest, TheFocusStaysOnTheButtonThatTurnsPages) {
  show(0, 9);
  app::Sounds sounds;
  for (int i = 0; i < 2; ++i) list.buttons.event(app::KeyPressed{app::Key::back_tab}, sounds);
  ASSERT_TRUE(list.buttons.focused(PagedList::next));
  show(2, 9);
  EXPECT_TRUE(list.buttons.focused(PagedList::next));
}

}  // namespace
