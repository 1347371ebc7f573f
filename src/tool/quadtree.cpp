#include "carom/quadtree.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene.hpp"
#include "cli/options.hpp"
#include "files/output.hpp"
#include "tool/counted.hpp"
#include "tool/exit_status.hpp"
#include "tool/quadtree.hpp"
#include "tool/scene_input.hpp"

namespace tool {

namespace {

struct QuadtreeOptions {
  std::string scene;
  std::optional<std::string> svg;
};

struct Level {
  int depth;
  double side;  // px
  std::size_t squares = 0;
  std::size_t balls = 0;
};

// The levels that have balls, coarsest first.
struct Tree {
  std::vector<carom::Quadtree::Square> squares;
  std::vector<Level> levels;

  explicit Tree(const std::vector<carom::Ball>& balls) {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> radius;
    for (const carom::Ball& ball : balls) {
      x.push_back(ball.position.x);
      y.push_back(ball.position.y);
      radius.push_back(ball.radius);
    }
    carom::Quadtree tree;
    tree.build(x, y, radius);
    squares = tree.squares();
    for (const carom::Quadtree::Square& square : squares) {
      if (levels.empty() || levels.back().depth != square.level)
        levels.push_back({.depth = square.level, .side = square.side});
      ++levels.back().squares;
    }
    for (const carom::Ball& ball : balls) ++levels[level_of(ball)].balls;
  }

  // The finest whose squares are at least 1.3 diameters wide.
  std::size_t level_of(const carom::Ball& ball) const {
    std::size_t level = levels.size() - 1;
    while (level > 0 && levels[level].side < 2.6 * ball.radius) --level;
    return level;
  }
};

// To hundredths, shortest.
std::string text(double number) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                 std::round(number * 100) / 100 + 0.0);
  return {digits.data(), end.ptr};
}

// To six digits, whatever its size.
std::string side_text(double side) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), side,
                                 std::chars_format::general, 6);
  return {digits.data(), end.ptr};
}

void summarise(const carom::Scene& scene, const Tree& tree, std::FILE* out) {
  std::fprintf(out, "balls    %zu\n", scene.balls.size());
  std::fprintf(out, "squares  %zu\n", tree.squares.size());
  if (tree.levels.empty()) return;
  std::fprintf(out, "\nlevel     side px    squares      balls\n");
  for (const Level& level : tree.levels)
    std::fprintf(out, "%5d  %10s %10zu %10zu\n", level.depth, side_text(level.side).c_str(),
                 level.squares, level.balls);
}

/// Draws the play area with its balls, each in the colour of its level, and under them the squares
/// that hold them. Colours that are seen on white and on black.
class Picture {
 public:
  Picture(const carom::Scene& scene, const Tree& tree) : scene_(scene), tree_(tree) {
    // Of what is outside only the squares at the edge.
    high_ = {scene.width, scene.height};
    const double most = tree.levels.empty() ? 0 : tree.levels.front().side;
    for (const auto& [low, side, level] : tree.squares) {
      low_ = {std::max(std::min(low_.x, low.x), -most), std::max(std::min(low_.y, low.y), -most)};
      high_ = {std::min(std::max(high_.x, low.x + side), scene.width + most),
               std::min(std::max(high_.y, low.y + side), scene.height + most)};
    }
    scale_ = std::min((width - 2 * margin) / (high_.x - low_.x), most_height / (high_.y - low_.y));
  }

  std::string svg() {
    const double caption = y(low_.y) + 30;
    const std::size_t lines = (tree_.levels.size() + 1) / 2;
    const double height = caption + line * static_cast<double>(lines) + margin;
    out_ = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " + text(width) + " " +
           text(height) + "' width='" + text(width) + "' height='" + text(height) +
           "' font-family='Lato, DejaVu Sans, sans-serif' font-size='15' fill='" + ink + "'>\n";
    const carom::Vec2 size = high_ - low_;
    out_ += "<clipPath id='view'><rect";
    attributes({{"x", x(low_.x) - 2},
                {"y", y(high_.y) - 2},
                {"width", size.x * scale_ + 4},
                {"height", size.y * scale_ + 4}});
    out_ += "/></clipPath>\n<g clip-path='url(#view)'>\n";
    out_ += "<rect fill='none' stroke='" + std::string(ink) + "' stroke-dasharray='6 5'";
    attributes({{"x", x(0)},
                {"y", y(scene_.height)},
                {"width", scene_.width * scale_},
                {"height", scene_.height * scale_}});
    out_ += "/>\n";
    squares();
    balls();
    out_ += "</g>\n";
    legend(caption);
    return out_ + "</svg>\n";
  }

 private:
  static constexpr double width = 960;        // of the picture, as all that follows
  static constexpr double most_height = 960;  // of the play area
  static constexpr double margin = 12;
  static constexpr double line = 24;
  static constexpr const char* ink = "#768390";
  static constexpr std::array<const char*, 6> colours{"#d64550", "#d9822b", "#2f9e5b",
                                                      "#2f86d6", "#a05fd6", "#8a8f98"};

  double x(double px) const { return margin + (px - low_.x) * scale_; }
  double y(double px) const { return margin + (high_.y - px) * scale_; }

  void attributes(std::initializer_list<std::pair<const char*, double>> all) {
    for (const auto& [name, value] : all)
      out_ += " " + std::string(name) + "='" + text(value) + "'";
  }

  static const char* colour(std::size_t level) { return colours[level % colours.size()]; }
  static double line_width(std::size_t level) {
    return std::max(3.2 / static_cast<double>(level + 1), 0.6);
  }

  void begin_level(std::size_t level, double opacity) {
    out_ += "<g fill='" + std::string(colour(level)) + "' fill-opacity='" + text(opacity) +
            "' stroke='" + colour(level) + "'";
    attributes({{"stroke-width", line_width(level)}});
    out_ += ">\n";
  }

  void squares() {
    auto square = tree_.squares.begin();
    for (std::size_t level = 0; level < tree_.levels.size(); ++level) {
      begin_level(level, 0.07);
      for (std::size_t n = 0; n < tree_.levels[level].squares; ++n, ++square) {
        out_ += "<rect";
        attributes({{"x", x(square->low.x)},
                    {"y", y(square->low.y + square->side)},
                    {"width", square->side * scale_},
                    {"height", square->side * scale_}});
        out_ += "/>\n";
      }
      out_ += "</g>\n";
    }
  }

  void balls() {
    for (std::size_t level = 0; level < tree_.levels.size(); ++level) {
      begin_level(level, 0.6);
      for (const carom::Ball& ball : scene_.balls) {
        if (tree_.level_of(ball) != level) continue;
        out_ += "<circle";
        attributes(
            {{"cx", x(ball.position.x)}, {"cy", y(ball.position.y)}, {"r", ball.radius * scale_}});
        out_ += " stroke='none'/>\n";
      }
      out_ += "</g>\n";
    }
  }

  void write(double at_x, double at_y, const std::string& words) {
    out_ += "<text";
    attributes({{"x", at_x}, {"y", at_y}});
    out_ += ">" + words + "</text>\n";
  }

  void legend(double top) {
    write(margin, top,
          counted(scene_.balls.size(), "ball") + " in " + counted(tree_.squares.size(), "square") +
              " of " + counted(tree_.levels.size(), "level"));
    for (std::size_t level = 0; level < tree_.levels.size(); ++level) {
      const Level& shown = tree_.levels[level];
      const double left = margin + (level % 2 == 0 ? 0 : width / 2);
      const std::size_t row = level / 2 + 1;
      const double base = top + line * static_cast<double>(row);
      begin_level(level, 0.35);
      out_ += "<rect";
      attributes({{"x", left + 2}, {"y", base - 12}, {"width", 14}, {"height", 14}});
      out_ += "/>\n</g>\n";
      write(left + 26, base,
            "level " + std::to_string(shown.depth) + ": side " + side_text(shown.side) + " px, " +
                counted(shown.squares, "square") + ", " + counted(shown.balls, "ball"));
    }
  }

  const carom::Scene& scene_;
  const Tree& tree_;
  carom::Vec2 low_{};
  carom::Vec2 high_{};
  double scale_ = 1;
  std::string out_;
};

int quadtree(const QuadtreeOptions& options) {
  const auto scene = read_scene_file(options.scene);
  if (!scene) return report(scene.errors(), options.scene);
  const Tree tree(scene.value().balls);
  std::FILE* out = stdout;
  if (options.svg) {
    const std::array inputs{options.scene};
    files::Output svg(*options.svg, inputs);
    svg.write(Picture(scene.value(), tree).svg());
    if (const carom::Status written = svg.commit(); !written)
      return report_output(written.errors(), *options.svg);
    if (svg.is_standard_output()) out = stderr;
  }
  summarise(scene.value(), tree, out);
  return done;
}

}  // namespace

void add_quadtree(CLI::App& carom, int& status) {
  const auto options = std::make_shared<QuadtreeOptions>();
  CLI::App* command =
      carom.add_subcommand("quadtree", "Tell, and draw, how the quadtree divides a scene.");
  command->add_option("scene", options->scene, "Scene or level file (JSON); - is standard input")
      ->required()
      ->check(cli::file_name())
      ->option_text("SCENE");
  command
      ->add_option("--svg", options->svg,
                   "Draw the balls and the squares that hold their centres; - is standard output")
      ->check(cli::file_name())
      ->option_text("FILE");
  command->footer(
      "Prints for each level of the tree the side of its squares, how many of them hold a ball's\n"
      "centre, and the balls on it.\n"
      "Exit status: 0 done; 1 the scene is wrong, or a file cannot be read or written; 2 wrong "
      "usage.\n\n"
      "Examples:\n"
      "  carom quadtree scenes/break.json\n"
      "  carom quadtree scenes/mixed-sizes.json --svg quadtree.svg");
  command->callback([options, &status] { status = quadtree(*options); });
}

}  // namespace tool
