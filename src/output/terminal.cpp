// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "lab/base/text.hpp"

namespace triax::src {
namespace {

constexpr int kNarrowest = 80, kWidest = 200, kInFiles = 100;

int columns() {
  const char* told = std::getenv("COLUMNS");
  if (const auto width = lab::whole_text_as<int>(told != nullptr ? told : ""); width && *width > 0)
    return *width;
  winsize size{};
  const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : kInFiles;
}

}  // namespace

std::size_t text_width() {
  return static_cast<std::size_t>(std::clamp(columns(), kNarrowest, kWidest));
}

bool takes_colour(std::FILE* stream) {
  const char* refused = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return (refused == nullptr || *refused == '\0') && terminal != nullptr &&
         std::strcmp(terminal, "dumb") != 0 && ::isatty(::fileno(stream)) == 1;
}

std::string alarming(const std::string& text, std::FILE* stream) {
  return takes_colour(stream) ? "\x1b[1;31m" + text + "\x1b[0m" : text;
}

}  // namespace triax::src
