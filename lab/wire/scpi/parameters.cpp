// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "lab/base/text.hpp"
#include "lab/wire/scpi/scpi_error.hpp"

namespace triax::lab {
namespace {

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return capitals;
}

/// Length of the item at the front of `text`, up to its comma or the end.
std::size_t item_length(std::string_view text) {
  std::size_t i = 0;
  int depth = 0;
  while (i < text.size() && (text[i] != ',' || depth > 0)) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = text.find(c, i + 1);
      if (i == std::string_view::npos) throw ScpiError(-151, "no closing quote");
    } else if (const std::size_t block = c == '#' ? block_length(text.substr(i)) : 0) {
      if (block > text.size() - i) throw ScpiError(-161, "shorter than its stated length");
      i += block - 1;
    }
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    ++i;
  }
  return i;
}

bool is_word(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) &&
         std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

}  // namespace

ScpiParameters::ScpiParameters(std::string_view text) {
  text = trimmed(text);
  while (!text.empty()) {
    const std::size_t length = item_length(text);
    const std::string_view item = trimmed(text.substr(0, length));
    if (item.empty()) throw ScpiError(-102, "no parameter before a comma");
    items_.emplace_back(item);
    if (length == text.size()) return;
    text = trimmed(text.substr(length + 1));
    if (text.empty()) throw ScpiError(-102, "no parameter after the last comma");
  }
}

std::string_view ScpiParameters::take() {
  if (!more()) throw ScpiError(-109);
  return items_[next_++];
}

double ScpiParameters::number(std::string_view unit) {
  std::string_view item = take();
  const std::string whole(item);
  if (item.starts_with('+')) item.remove_prefix(1);
  // The number is what is left of an ending that may be the unit. E is a letter of numbers too.
  std::size_t end = item.size();
  while (end > 0 && (std::isalpha(static_cast<unsigned char>(item[end - 1])) ||
                     item[end - 1] == '/' || item[end - 1] == '%'))
    --end;
  const std::string_view ending = item.substr(end);
  const auto value = whole_text_as<double>(trimmed(item.substr(0, end)));
  if (!value || !std::isfinite(*value)) throw ScpiError(-104, "no number: " + excerpt(whole));
  if (!ending.empty() && (unit.empty() || in_capitals(ending) != in_capitals(unit)))
    throw ScpiError(-131, excerpt(ending) + (unit.empty() ? ", it has no unit"
                                                          : ", its unit is " + std::string(unit)));
  return *value;
}

int ScpiParameters::integer(int lowest, int highest) {
  const double value = number();
  if (!(value >= lowest && value <= highest) || value != std::floor(value))
    throw ScpiError(-222,
                    fmt::format("{:.10g} is not an integer from {} to {}", value, lowest, highest));
  return static_cast<int>(value);
}

bool ScpiParameters::flag() {
  if (more() && is_word(items_[next_])) {
    const std::string said = word();
    if (said != "ON" && said != "OFF") throw ScpiError(-224, "ON or OFF, not " + excerpt(said));
    return said == "ON";
  }
  return std::round(number()) != 0;
}

std::string ScpiParameters::word() {
  const std::string_view item = take();
  if (!is_word(item)) throw ScpiError(-104, "no word: " + excerpt(item));
  return in_capitals(item);
}

std::string ScpiParameters::text() {
  const std::string_view item = take();
  const char quote = item.front();
  if ((quote != '"' && quote != '\'') || item.size() < 2 || item.back() != quote)
    throw ScpiError(-104, "no text in quotes: " + excerpt(item));
  std::string text;
  for (std::size_t i = 1; i + 1 < item.size(); ++i) {
    text += item[i];
    if (item[i] == quote && item[++i] != quote) throw ScpiError(-151);
  }
  return text;
}

bool ScpiParameters::is_channels() const { return more() && items_[next_].starts_with('('); }

std::vector<int> ScpiParameters::channels() {
  constexpr std::size_t kMostChannels = 1000;
  const std::string item(take());
  if (!item.starts_with("(@") || !item.ends_with(')'))
    throw ScpiError(-104, "no channel list, as in (@101:107,110): " + excerpt(item));
  std::vector<int> channels;
  std::string_view rest = std::string_view(item).substr(2, item.size() - 3);
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest = part.size() == rest.size() ? "" : rest.substr(part.size() + 1);
    const std::size_t colon = part.find(':');
    const auto first = whole_text_as<int>(trimmed(part.substr(0, colon)));
    const auto last = colon == std::string_view::npos
                          ? first
                          : whole_text_as<int>(trimmed(part.substr(colon + 1)));
    if (!first || !last || *first < 0 || *last < 0)
      throw ScpiError(-102, "no channels: " + excerpt(part));
    const int step = *last < *first ? -1 : 1;
    for (int channel = *first; channel != *last + step; channel += step) {
      if (channels.size() == kMostChannels) throw ScpiError(-222, "more than 1,000 channels");
      channels.push_back(channel);
      if (channel == *last) break;
    }
  }
  return channels;
}

std::string ScpiParameters::block() {
  const std::string_view item = take();
  if (block_length(item) != item.size() || item.empty())
    throw ScpiError(-104, "no block, as in #15hello: " + excerpt(item));
  return std::string(item.substr(2 + static_cast<std::size_t>(item[1] - '0')));
}

std::size_t block_length(std::string_view text) {
  if (text.size() < 2 || text[0] != '#' || text[1] < '1' || text[1] > '9') return 0;
  const auto digits = static_cast<std::size_t>(text[1] - '0');
  if (text.size() < 2 + digits) return 0;
  const auto length = whole_text_as<std::uint64_t>(text.substr(2, digits));
  return length ? 2 + digits + *length : 0;
}

std::string as_block(std::string_view bytes) {
  const std::string length = std::to_string(bytes.size());
  return fmt::format("#{}{}{}", length.size(), length, bytes);
}

}  // namespace triax::lab
