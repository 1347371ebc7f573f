// The C++ half of the browser's storage over an imitation of localStorage. The JavaScript half is
// tested in Chromium (tests/web).

#include "platform/browser_store.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <map>

namespace {

/// localStorage, keys without the prefix.
struct Page {
  std::map<std::string, std::string> texts;
  bool refuses = false;  ///< every access throws
  bool full = false;     ///< setItem throws
} page;

char* allocated(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace

// As src/platform/browser_store.cpp declares them.
char* browser_store_load(const char* key, std::int32_t* size) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the page's sign for a refusal
  if (page.refuses) return reinterpret_cast<char*>(std::intptr_t{-1});
  const auto found = page.texts.find(key);
  if (found == page.texts.end()) return nullptr;
  *size = static_cast<std::int32_t>(found->second.size());
  return allocated(found->second);
}
char* browser_store_save(const char* key, const char* text, std::int32_t size) {
  if (page.refuses) return allocated("SecurityError");
  if (page.full) return allocated("QuotaExceededError");
  page.texts[key] = std::string(text, static_cast<std::size_t>(size));
  return allocated("");
}
int browser_store_remove(const char* key) {
  if (page.refuses) return 0;
  page.texts.erase(key);
  return 1;
}
int browser_store_move(const char* from, const char* to) {
  if (page.refuses || page.full) return -1;
  const auto found = page.texts.find(from);
  if (found == page.texts.end()) return 1;
  if (page.texts.contains(to)) return 0;
  page.texts[to] = found->second;
  page.texts.erase(found);
  return 1;
}
char* browser_store_list(const char* folder) {
  std::string names;
  if (!page.refuses)
    // Object.keys() promises no order.
    for (auto text = page.texts.rbegin(); text != page.texts.rend(); ++text)
      if (text->first.starts_with(folder) && app::is_listed(text->first))
        names += text->first + '\n';
  return allocated(names);
}

namespace {

class BrowserStoreTest : public testing::Test {
 protected:
  BrowserStoreTest() { page = {}; }
  platform::BrowserStore store;
};

TEST_F(BrowserStoreTest, ATextIsLoadedAsItWasSaved) {
  const std::string text("a\0b\n\xc3\xa9", 6);
  ASSERT_TRUE(store.save("a.json", text));
  EXPECT_EQ(store.load("a.json").value(), text);
  EXPECT_EQ(store.load("b.json").value(), std::nullopt);
}

TEST_F(BrowserStoreTest, ANewTextTakesTheOldOnesPlace) {
  ASSERT_TRUE(store.save("a.json", "old"));
  ASSERT_TRUE(store.save("a.json", "new"));
  EXPECT_EQ(store.load("a.json").value(), "new");
}

TEST_F(BrowserStoreTest, SaveNewNeverWritesOverAText) {
  EXPECT_TRUE(store.save_new("a.json", "first").value());
  EXPECT_FALSE(store.save_new("a.json", "second").value());
  EXPECT_EQ(store.load("a.json").value(), "first");
}

TEST_F(BrowserStoreTest, RemovingIsFineWhetherTheTextIsThereOrNot) {
  ASSERT_TRUE(store.save("a.json", "x"));
  EXPECT_TRUE(store.remove("a.json"));
  EXPECT_TRUE(store.remove("a.json"));
  EXPECT_EQ(store.load("a.json").value(), std::nullopt);
}

TEST_F(BrowserStoreTest, ATextSetAsideNeverTakesAnothersName) {
  for (const char* text : {"one", "two", "three"}) {
    ASSERT_TRUE(store.save("a.json", text));
    ASSERT_TRUE(store.set_aside("a.json"));
  }
  EXPECT_EQ(page.texts, (std::map<std::string, std::string>{{"a.json.broken", "one"},
                                                            {"a.json.broken-2", "two"},
                                                            {"a.json.broken-3", "three"}}));
}

TEST_F(BrowserStoreTest, NamesOfAFolderComeInOrder) {
  for (const char* name :
       {"replays/b.json", "replays/a.angry-replay", "settings.json", "replays/c.txt"})
    ASSERT_TRUE(store.save(name, "{}"));
  EXPECT_EQ(store.list("replays/"),
            (std::vector<std::string>{"replays/a.angry-replay", "replays/b.json"}));
  EXPECT_TRUE(store.list("levels/").empty());
}

TEST_F(BrowserStoreTest, ATextOfMoreThanTheLimitIsNotRead) {
  page.texts["a.json"] = std::string(platform::BrowserStore::max_text + 1, 'x');
  const auto loaded = store.load("a.json");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(carom::to_string(loaded.errors().front()), "a.json: is larger than 16 MiB");
  page.texts["a.json"].pop_back();
  EXPECT_TRUE(store.load("a.json"));
}

TEST_F(BrowserStoreTest, AFullStorageIsToldAndKeepsTheOldText) {
  ASSERT_TRUE(store.save("a.json", "old"));
  page.full = true;
  const auto saved = store.save("a.json", "new");
  ASSERT_FALSE(saved);
  EXPECT_EQ(carom::to_string(saved.errors().front()), "a.json: cannot be kept: QuotaExceededError");
  EXPECT_FALSE(store.save_new("b.json", "x"));
  EXPECT_FALSE(store.set_aside("a.json"));
  EXPECT_EQ(store.load("a.json").value(), "old");
}

TEST_F(BrowserStoreTest, AStorageThatIsRefusedFailsWithAnErrorEverywhere) {
  page.refuses = true;
  EXPECT_FALSE(store.load("a.json"));
  EXPECT_FALSE(store.save("a.json", "x"));
  EXPECT_FALSE(store.save_new("a.json", "x"));
  EXPECT_FALSE(store.remove("a.json"));
  EXPECT_FALSE(store.set_aside("a.json"));
  EXPECT_TRUE(store.list("").empty());
}

}  // namespace
