#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace cli {

/// --help within 80 columns: CLI11 breaks no lines.
class HelpFormat : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    return wrapped(CLI::Formatter::make_help(app, std::move(name), mode));
  }

  static std::string wrapped(const std::string& help) {
    std::string out;
    std::string paragraph;
    const auto end_paragraph = [&] {
      if (!paragraph.empty()) append_wrapped(out, paragraph, 0);
      paragraph.clear();
    };
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      const bool text = !line.empty() && line[0] != ' ' && line.back() != ':';
      if (!text || line.starts_with("Exit status") || line.starts_with("Usage:")) end_paragraph();
      if (text)
        paragraph += (paragraph.empty() ? "" : " ") + line;
      else
        append_wrapped(out, line, description_column);
    }
    end_paragraph();
    return out;
  }

 private:
  static constexpr std::size_t columns = 80;
  static constexpr std::size_t description_column = 30;  // CLI11's default

  // The line as several, those after the first indented.
  static void append_wrapped(std::string& out, std::string line, std::size_t indent) {
    while (width(line) > columns) {
      std::size_t cut = columns;
      while (cut > indent && line[cut] != ' ') --cut;
      if (cut <= indent) break;  // one long word
      out += line.substr(0, cut) + '\n';
      line = std::string(indent, ' ') + line.substr(cut + 1);
    }
    out += line + '\n';
  }

  // Characters, which begin with any byte but 10xxxxxx.
  static std::size_t width(const std::string& line) {
    std::size_t count = 0;
    for (const char c : line) count += (c & 0xc0) != 0x80 ? 1 : 0;
    return count;
  }
};

}  // namespace cli
