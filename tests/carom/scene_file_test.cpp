#include "carom/scene_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace carom {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = SOURCE_DIR;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string text(const Errors& errors, std::string_view file = {}) {
  std::string lines;
  for (const Error& error : errors) lines += to_string(error, file) + "\n";
  return lines;
}

std::string read_errors(std::string_view json) {
  const auto scene = read_scene(json);
  return scene ? "" : text(scene.errors());
}

// Everything that a file can say, nothing by default.
constexpr std::string_view full_scene = R"({
  "carom": 1,
  "name": "First \"steps\" \u00e9\n",
  "width": 800.5,
  "height": 400.25,
  "edges": {"left": "open", "right": "solid", "bottom": "open", "top": "open"},
  "friction": 0.99,
  "gravity": 600,
  "hole_pull": 12.5,
  "damage_per_speed": 3,
  "damage_threshold": 0.5,
  "throws": 4,
  "holes": [{"x": 10, "y": -10, "radius": 17}, {"x": 1e-3, "y": 1E+2}],
  "obstacles": [{"x": 500, "height": 100, "radius": 12.25}, {"x": 600}],
  "balls": [
    {"x": 200, "y": 150, "vx": 1.5, "vy": -2.5, "radius": 9, "solidity": 3000, "role": "cue"},
    {"role": "enemy", "solidity": 0, "y": 60, "x": 50}
  ]
})";

TEST(SceneFile, ReadsEverything) {
  const auto read = read_scene(full_scene);
  ASSERT_TRUE(read) << text(read.errors());
  Scene scene;
  scene.name = "First \"steps\" é\n";
  scene.width = 800.5;
  scene.height = 400.25;
  scene.edges = {Edge::open, Edge::solid, Edge::open, Edge::open};
  scene.friction = 0.99;
  scene.gravity = 600;
  scene.hole_pull = 12.5;
  scene.damage_per_speed = 3;
  scene.damage_threshold = 0.5;
  scene.throws = 4;
  scene.holes = {{.position = {10, -10}, .radius = 17}, {.position = {0.001, 100}}};
  scene.obstacles = {{.x = 500, .height = 100, .radius = 12.25}, {.x = 600}};
  scene.balls = {{.role = Role::cue,
                  .position = {200, 150},
                  .velocity = {1.5, -2.5},
                  .radius = 9,
                  .solidity = 3000},
                 {.role = Role::enemy, .position = {50, 60}, .solidity = 0}};
  EXPECT_EQ(read.value(), scene);
}

TEST(SceneFile, WhatIsLeftOutHasItsDefault) {
  const auto read = read_scene(
      R"({"balls": [{"x": 50, "y": 60}], "height": 400, "width": 800, "carom": 1.0, "edges": {}})");
  ASSERT_TRUE(read) << text(read.errors());
  Scene scene;
  scene.balls = {{.position = {50, 60}}};
  EXPECT_EQ(read.value(), scene);
}

TEST(SceneFile, ACueBallIsSmallerUnlessItSaysOtherwise) {
  const auto radius = [](const std::string& members) {
    const auto read =
        read_scene(R"({"carom": 1, "width": 800, "height": 400, "balls": [{"x": 50, "y": 60, )" +
                   members + "}]}");
    EXPECT_TRUE(read) << text(read.errors());
    return read ? read.value().balls[0].radius : 0;
  };
  EXPECT_EQ(radius(R"("role": "cue")"), 8);
  EXPECT_EQ(radius(R"("role": "cue", "radius": 10)"), 10);
  EXPECT_EQ(radius(R"("radius": 10, "role": "cue")"), 10);
  EXPECT_EQ(radius(R"("role": "projectile")"), 10);
}

TEST(SceneFile, MinusZeroIsZero) {
  const auto read = read_scene(
      R"({"carom": 1, "width": 800, "height": 400, "gravity": -0.0, "balls": [
          {"x": 50, "y": 60, "vx": -0, "vy": -1e-400}]})");
  ASSERT_TRUE(read) << text(read.errors());
  EXPECT_FALSE(std::signbit(read.value().gravity));
  EXPECT_FALSE(std::signbit(read.value().balls[0].velocity.x));
  EXPECT_FALSE(std::signbit(read.value().balls[0].velocity.y));

  Scene scene;
  scene.balls = {{.position = {50, 60}, .velocity = {-0.0, 1}}};
  scene.obstacles = {{.x = -0.0}};
  EXPECT_EQ(write_scene(scene).find("-0"), std::string::npos);
}

TEST(SceneFile, WritesALineForEachThing) {
  EXPECT_EQ(write_scene({}), R"({
  "carom": 1,
  "width": 800,
  "height": 400,
  "balls": []
}
)");
  const auto read = read_scene(full_scene);
  ASSERT_TRUE(read);
  EXPECT_EQ(write_scene(read.value()), R"({
  "carom": 1,
  "name": "First \"steps\" é\n",
  "width": 800.5,
  "height": 400.25,
  "edges": {"left": "open", "bottom": "open", "top": "open"},
  "friction": 0.99,
  "gravity": 600,
  "hole_pull": 12.5,
  "damage_per_speed": 3,
  "damage_threshold": 0.5,
  "throws": 4,
  "holes": [
    {"x": 10, "y": -10, "radius": 17},
    {"x": 0.001, "y": 100}
  ],
  "obstacles": [
    {"x": 500, "height": 100, "radius": 12.25},
    {"x": 600}
  ],
  "balls": [
    {"x": 200, "y": 150, "vx": 1.5, "vy": -2.5, "radius": 9, "solidity": 3000, "role": "cue"},
    {"x": 50, "y": 60, "solidity": 0, "role": "enemy"}
  ]
}
)");
}

TEST(SceneFile, ShippedScenesAndLevelsAreSound) {
  int count = 0;
  for (const char* folder : {"scenes", "levels"})
    for (const auto& entry : fs::directory_iterator(source_dir / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".json") || name.ends_with(".proof.json")) continue;
      const auto scene = read_scene(content(entry.path()));
      EXPECT_TRUE(scene) << text(scene.errors(), entry.path().string());
      if (!scene) continue;
      EXPECT_NE(scene.value().name, "") << entry.path();
      const auto again = read_scene(write_scene(scene.value()));
      EXPECT_TRUE(again && again.value() == scene.value()) << entry.path();
      ++count;
    }
  EXPECT_GE(count, 4);
}

// Every wrong file with the messages it gives. UPDATE_GOLDEN=1 writes them anew.
TEST(SceneFile, WrongFilesGetTheirMessages) {
  const fs::path folder = source_dir / "tests/scenes/wrong";
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().stem().string());
  EXPECT_GE(names.size(), 40u);
  for (const std::string& name : names) {
    const fs::path json = folder / (name + ".json");
    const fs::path golden = folder / (name + ".txt");
    ASSERT_TRUE(fs::exists(json)) << json;
    const auto scene = read_scene(content(json));
    if (scene) {
      ADD_FAILURE() << json << " was accepted";
      continue;
    }
    const std::string messages = text(scene.errors(), json.filename().string());
    if (std::getenv("UPDATE_GOLDEN")) std::ofstream(golden, std::ios::binary) << messages;
    ASSERT_TRUE(fs::exists(golden)) << golden;
    EXPECT_EQ(messages, content(golden));
  }
}

TEST(SceneFile, TextsForPeopleAreKeptAndTheSchemaIsReadOver) {
  const std::string json = R"({
  "carom": 1,
  "name": "A",
  "author": "B",
  "licence": "CC0-1.0",
  "description": "C\nD",
  "width": 800,
  "height": 400,
  "balls": []
}
)";
  const auto scene = read_scene(json);
  ASSERT_TRUE(scene) << text(scene.errors());
  EXPECT_EQ(scene.value().author, "B");
  EXPECT_EQ(scene.value().licence, "CC0-1.0");
  EXPECT_EQ(scene.value().description, "C\nD");
  EXPECT_EQ(write_scene(scene.value()), json);
  std::string with_schema = json;
  with_schema.insert(1, R"("$schema": "../schemas/scene.schema.json",)");
  ASSERT_TRUE(read_scene(with_schema));
  EXPECT_EQ(write_scene(read_scene(with_schema).value()), json);
}

TEST(SceneFile, TextsForPeopleHaveLimits) {
  const auto errors = [](const std::string& member) {
    return read_errors("{\"carom\": 1, " + member +
                       R"(, "width": 800, "height": 400, "balls": []})");
  };
  EXPECT_EQ(errors("\"description\": \"" + std::string(2000, 'x') + '"'), "");
  EXPECT_EQ(errors("\"description\": \"" + std::string(2001, 'x') + '"'),
            "1:29: /description: is 2001 bytes long; expected a text of at most 2000 bytes\n");
  EXPECT_EQ(errors("\"author\": \"" + std::string(201, 'x') + '"'),
            "1:24: /author: is 201 bytes long; expected a text of at most 200 bytes\n");
  EXPECT_EQ(errors("\"licence\": 3"),
            "1:25: /licence: is 3; expected a text of at most 200 bytes\n");
  EXPECT_EQ(errors("\"$schema\": 3"),
            "1:25: /$schema: is 3; expected a text of at most 2000 bytes\n");
}

TEST(SceneFile, TheSchemaKnowsTheSameKeys) {
  using Json = nlohmann::ordered_json;
  const Json schema = Json::parse(content(source_dir / "schemas/scene.schema.json"));
  const auto expect_keys = [](const Json& object, const std::string& json) {
    std::string keys;
    for (const auto& [key, rest] : object.at("properties").items())
      keys += (keys.empty() ? "" : ", ") + key;
    const std::string errors = read_errors(json);
    EXPECT_NE(errors.find("is an unknown key; expected one of " + keys + "\n"), std::string::npos)
        << errors << keys;
    EXPECT_EQ(object.at("additionalProperties"), false);
    for (const Json& key : object.value("required", Json::array())) {
      const std::string missing = "/" + key.get<std::string>() + ": is missing";
      EXPECT_NE(errors.find(missing), std::string::npos) << errors << missing;
    }
  };
  const Json& properties = schema.at("properties");
  expect_keys(schema, R"({"?": 0})");
  expect_keys(properties.at("edges"), R"({"edges": {"?": 0}})");
  for (const std::string list : {"holes", "obstacles", "balls"})
    expect_keys(properties.at(list).at("items"), "{\"" + list + R"(": [{"?": 0}]})");
}

TEST(SceneFile, ALongListOfErrorsIsCut) {
  const auto scene = [](const std::string& ball, int balls) {
    std::string json = R"({"carom": 1, "width": 800, "height": 400, "balls": [)" + ball;
    for (int i = 1; i < balls; ++i) json += "," + ball;
    return json + "]}";
  };
  for (const std::string ball : {R"({"x": 100, "y": 100, "radius": -1})", R"({"x": 100, "y": 0})",
                                 R"({"x": 100, "y": 100, "z": 0})", "0"}) {
    const auto cut = read_scene(scene(ball, 1501));
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.errors().size(), max_errors + 1);
    EXPECT_EQ(to_string(cut.errors().back(), "x.json"), "x.json: and 501 more errors");
    EXPECT_EQ(read_scene(scene(ball, 1000)).errors().size(), max_errors);
    EXPECT_EQ(to_string(read_scene(scene(ball, 1001)).errors().back()), "and 1 more error");
  }
}

TEST(SceneFile, RefusesMoreThanItsLimits) {
  std::string json = R"({"carom": 1, "width": 800, "height": 400, "balls": [], "holes": [)";
  for (std::size_t i = 0; i < max_fixtures; ++i) json += R"({"x":1,"y":2},)";
  EXPECT_EQ(read_errors(json + R"({"x":1,"y":2}, "never read")"),
            "1:" + std::to_string(json.size() + 1) +
                ": /holes: has more than 100000 elements; expected at most 100000\n");
  json.back() = ']';
  EXPECT_EQ(read_errors(json + "}"), "");
}

TEST(SceneFile, EveryBeginningIsRefused) {
  for (std::size_t size = 0; size < full_scene.size(); ++size)
    EXPECT_NE(read_errors(full_scene.substr(0, size)), "") << size;
}

// Sets a locale of that language, which is built if it is not installed; false if that fails too.
bool set_locale(const std::string& language) {
  const std::string name = language + ".UTF-8";
  if (std::setlocale(LC_ALL, name.c_str())) return true;
  const std::string folder = testing::TempDir() + "carom-locale-" + language;
  fs::create_directories(folder);
  const std::string command =
      "localedef -c -i " + language + " -f UTF-8 " + folder + "/" + name + " >/dev/null 2>&1";
  // It reports mere warnings as failures: what counts is whether the locale can be used.
  static_cast<void>(!std::system(command.c_str()));
  setenv("LOCPATH", folder.c_str(), 1);
  const bool done = std::setlocale(LC_ALL, name.c_str()) != nullptr;
  unsetenv("LOCPATH");
  return done;
}

struct CommaFacet : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(SceneFile, NumbersAreTheSameInEveryLocale) {
  const auto read = read_scene(full_scene);
  ASSERT_TRUE(read);
  Scene scene = read.value();
  scene.holes[0].position.x = 123456.789;
  const std::string written = write_scene(scene);
  const auto expect_the_same = [&] {
    EXPECT_EQ(write_scene(scene), written);
    const auto again = read_scene(written);
    ASSERT_TRUE(again) << text(again.errors());
    EXPECT_EQ(again.value(), scene);
    EXPECT_EQ(read_errors(R"({"carom": 1, "width": -1000000.5, "height": 400, "balls": []})"),
              "1:23: /width: is -1000000.5; expected a number from 0.001 to 1000000000 (px)\n");
  };

  // French has a decimal comma, Pashto a decimal point of two bytes.
  std::string found;
  for (const char* language : {"fr_FR", "de_DE", "ps_AF"}) {
    if (!set_locale(language)) continue;
    found += std::string(language) + " ";
    EXPECT_NE(std::string_view(std::localeconv()->decimal_point), ".") << language;
    expect_the_same();
  }
  std::setlocale(LC_ALL, "C");
  RecordProperty("locales", found.empty() ? "none" : found);

  // Works on every machine, but reaches only C++ streams, not the C library.
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaFacet));
  expect_the_same();
  std::locale::global(before);
}

// A number from low to high: an end, a round one, or any.
double any_number(double low, double high) {
  const double part = *rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53),
                                    [](std::int64_t n) { return std::ldexp(double(n), -53); });
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return low;
    case 1:
      return high;
    case 2:
      return std::clamp(std::round(low + (high - low) * part), low, high);
    case 3: {
      const auto number = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
      return number >= low && number <= high ? number : low;
    }
    default:
      return std::clamp(low + (high - low) * part, low, high);
  }
}

Scene any_sound_scene() {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  const auto some = [] { return *rc::gen::inRange(0, 5); };
  const auto edge = [] { return *rc::gen::element(Edge::solid, Edge::open); };
  Scene scene;
  const auto name = *rc::gen::container<std::vector<std::string>>(
      rc::gen::element<std::string>("a", " ", "\"", "\\", "/", "\n", "\x01", "é", "𝄞", "\x7F"));
  for (const std::string& c : name)
    if (scene.name.size() + c.size() <= 200) scene.name += c;
  scene.width = any_number(100, max_quantity);
  scene.height = any_number(100, max_quantity);
  scene.edges = {edge(), edge(), edge(), edge()};
  scene.friction = any_number(least, 1);
  scene.gravity = any_number(0, max_quantity);
  scene.hole_pull = any_number(0, max_quantity);
  scene.damage_per_speed = any_number(0, max_quantity);
  scene.damage_threshold = any_number(0, std::numeric_limits<double>::max());
  scene.throws = *rc::gen::inRange(1, max_throws + 1);
  for (int i = some(); i > 0; --i)
    scene.holes.push_back({.position = {any_number(-max_quantity, max_quantity), any_number(0, 9)},
                           .radius = any_number(min_size, max_quantity)});
  for (int i = some(); i > 0; --i)  // left of all balls
    scene.obstacles.push_back({.x = any_number(-max_quantity, -100),
                               .height = any_number(min_size, max_quantity),
                               .radius = any_number(min_size, 50)});
  for (int i = some(); i > 0; --i) {
    Role role = static_cast<Role>(*rc::gen::inRange(0, 5));
    if (!scene.balls.empty() && is_lead(role)) role = Role::red;
    scene.balls.push_back(
        {.role = role,
         .position = {any_number(20, scene.width - 20), any_number(20, scene.height - 20)},
         .velocity = {any_number(-7e4, 7e4), any_number(-7e4, 7e4)},
         .radius = any_number(min_size, 10),
         .solidity = *rc::gen::arbitrary<bool>()
                         ? infinite_solidity
                         : any_number(0, std::numeric_limits<double>::max())});
  }
  return scene;
}

RC_GTEST_PROP(SceneFile, WhatIsWrittenReadsBack, ()) {
  const Scene scene = any_sound_scene();
  RC_ASSERT(text(check(scene)) == "");
  const auto again = read_scene(write_scene(scene));
  RC_ASSERT(again.ok());
  RC_ASSERT(again.value() == scene);
}

std::string any_mutation(std::string json) {
  for (int edits = *rc::gen::inRange(1, 5); edits > 0; --edits) {
    const auto at = *rc::gen::inRange<std::size_t>(0, json.size() + 1);
    const auto size = *rc::gen::inRange<std::size_t>(0, 12);
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        json.erase(at, size);
        break;
      case 1:
        json.insert(at, json.substr(*rc::gen::inRange<std::size_t>(0, json.size() + 1), size));
        break;
      case 2:
        json.replace(at, 1, 1, *rc::gen::arbitrary<char>());
        break;
      default:
        json.insert(at, *rc::gen::element<std::string>(
                            "\"", "\\", "{", "}", "[", "]", ",", ":", "-", "0", "9", ".", "e99",
                            "1e999", "null", "true", "\"x\":", "\\u0000", "\\ud800", "\xFF", "é",
                            "\xEF\xBB\xBF", "\n", std::string(1, '\0')));
    }
  }
  return json;
}

RC_GTEST_PROP(SceneFile, NoBytesDoHarm, ()) {
  for (int round = 0; round < 20; ++round) {
    const auto read = read_scene(any_mutation(std::string(full_scene)));
    if (!read) {
      RC_ASSERT(!read.errors().empty());
      for (const Error& error : read.errors()) {
        RC_ASSERT(!error.problem.empty());
        RC_ASSERT(error.line >= 1 && error.column >= 1);
      }
      continue;
    }
    RC_ASSERT(check(read.value()).empty());
    const std::string written = write_scene(read.value());
    const auto again = read_scene(written);
    RC_ASSERT(again.ok());
    RC_ASSERT(again.value() == read.value());
    RC_ASSERT(write_scene(again.value()) == written);
  }
}

TEST(Error, ShowsTheKnownParts) {
  const Error error{.pointer = "/balls/0/radius",
                    .problem = "is -8",
                    .expected = "a number greater than 0",
                    .line = 3,
                    .column = 14};
  EXPECT_EQ(to_string(error, "scenes/x.json"),
            "scenes/x.json:3:14: /balls/0/radius: is -8; expected a number greater than 0");
  EXPECT_EQ(to_string(error), "3:14: /balls/0/radius: is -8; expected a number greater than 0");
  EXPECT_EQ(to_string({.pointer = "velocity", .problem = "is NaN"}), "velocity: is NaN");
  EXPECT_EQ(to_string({.problem = "is empty", .expected = "a scene"}, "x.json"),
            "x.json: is empty; expected a scene");
}

Scene one_of_everything() {
  Scene scene;
  scene.holes = {{.position = {10, 10}}};
  scene.obstacles = {{.x = 500}};
  scene.balls = {{.role = Role::projectile, .position = {200, 200}, .solidity = 5},
                 {.position = {300, 200}}};
  return scene;
}

TEST(Check, EveryNumberHasItsRange) {
  ASSERT_EQ(text(check(one_of_everything())), "");
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    const char* pointer;
    double& (*number)(Scene&);
    std::vector<double> wrong;
  };
  const Case cases[] = {
      {"/width", [](Scene& s) -> double& { return s.width; }, {0, -1, 1.1e9, inf}},
      {"/height", [](Scene& s) -> double& { return s.height; }, {0, -1, 1.1e9, inf}},
      {"/friction", [](Scene& s) -> double& { return s.friction; }, {0, -1, 1.1, inf}},
      {"/gravity", [](Scene& s) -> double& { return s.gravity; }, {-1, 1.1e9, inf}},
      {"/hole_pull", [](Scene& s) -> double& { return s.hole_pull; }, {-1, 1.1e9, inf}},
      {"/damage_per_speed", [](Scene& s) -> double& { return s.damage_per_speed; }, {-1, inf}},
      {"/damage_threshold", [](Scene& s) -> double& { return s.damage_threshold; }, {-1, inf}},
      {"/holes/0/x", [](Scene& s) -> double& { return s.holes[0].position.x; }, {1.1e9, -inf}},
      {"/holes/0/y", [](Scene& s) -> double& { return s.holes[0].position.y; }, {-1.1e9, inf}},
      {"/holes/0/radius", [](Scene& s) -> double& { return s.holes[0].radius; }, {0, -1, inf}},
      {"/obstacles/0/x", [](Scene& s) -> double& { return s.obstacles[0].x; }, {1.1e9, -inf}},
      {"/obstacles/0/height", [](Scene& s) -> double& { return s.obstacles[0].height; }, {0, inf}},
      {"/obstacles/0/radius", [](Scene& s) -> double& { return s.obstacles[0].radius; }, {0, inf}},
      {"/balls/1/x", [](Scene& s) -> double& { return s.balls[1].position.x; }, {1.1e9, -inf}},
      {"/balls/1/y", [](Scene& s) -> double& { return s.balls[1].position.y; }, {-1.1e9, inf}},
      {"/balls/1/vx", [](Scene& s) -> double& { return s.balls[1].velocity.x; }, {1e6, -inf}},
      {"/balls/1/vy", [](Scene& s) -> double& { return s.balls[1].velocity.y; }, {-1e6, inf}},
      {"/balls/1/radius", [](Scene& s) -> double& { return s.balls[1].radius; }, {0, -1, inf}},
      {"/balls/1/solidity", [](Scene& s) -> double& { return s.balls[1].solidity; }, {-1, -inf}},
  };
  for (const Case& c : cases) {
    std::vector<double> wrong = c.wrong;
    wrong.push_back(nan);
    for (const double number : wrong) {
      Scene scene = one_of_everything();
      c.number(scene) = number;
      const Errors errors = check(scene);
      ASSERT_EQ(errors.size(), 1u) << c.pointer << " " << number << "\n" << text(errors);
      EXPECT_EQ(errors[0].pointer, c.pointer);
    }
  }
}

TEST(Check, NamesTheThing) {
  const auto errors_of = [](auto change) {
    Scene scene = one_of_everything();
    change(scene);
    return text(check(scene));
  };
  EXPECT_EQ(errors_of([](Scene& s) { s.throws = 0; }),
            "/throws: is 0; expected a whole number from 1 to 1000\n");
  EXPECT_EQ(errors_of([](Scene& s) { s.name = "\xFF"; }),
            "/name: is not in UTF-8; expected a text of at most 200 bytes\n");
  EXPECT_EQ(errors_of([](Scene& s) {
              s.balls[1].velocity = {8e4, 8e4};
            }),
            "/balls/1: moves at 113137.0849898476 px/s; expected at most 100000 (px/s)\n");
  EXPECT_EQ(errors_of([](Scene& s) { s.balls[1].role = Role::cue; }),
            "/balls/1/role: is \"cue\", but ball 0 is \"projectile\" already; expected at most one "
            "cue ball or projectile, and that as the first ball\n");
  EXPECT_EQ(errors_of([](Scene& s) {
              s.balls[1].position = {795, 395};
            }),
            "/balls/1: sticks out of the solid right edge; expected x of at most 790 (px)\n");
  EXPECT_EQ(errors_of([](Scene& s) {
              s.edges = {Edge::open, Edge::open, Edge::open, Edge::open};
              s.balls[1].position = {795, 395};
              s.balls[0].position = {-5, -500};
            }),
            "");
  EXPECT_EQ(
      errors_of([](Scene& s) {
        s.balls[1].position = {480, 50};
      }),
      "/balls/1: overlaps obstacle 0 (x 500, height 120, radius 12); expected a place outside "
      "of every obstacle\n");
  EXPECT_EQ(errors_of([](Scene& s) { s.balls[1].position = {478, 50}; }), "");   // touches the wall
  EXPECT_EQ(errors_of([](Scene& s) { s.balls[1].position = {500, 142}; }), "");  // lies on the cap
  EXPECT_EQ(errors_of([](Scene& s) { s.balls[1].position = {10, 390}; }), "");   // in the corner
  EXPECT_EQ(errors_of([](Scene& s) { s.holes.resize(max_fixtures + 1); }),
            "/holes: has 100001 elements; expected at most 100000\n");
}

}  // namespace
}  // namespace carom
