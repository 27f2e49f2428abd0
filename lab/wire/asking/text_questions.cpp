// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/wire/asking/questions.hpp"
#include "lab/wire/asking/text_answer.hpp"

namespace triax::lab {
namespace {

/// "SOURce:PRESsure[:NOW]" -> ":SOUR:PRES"
std::string short_header(std::string_view pattern) {
  std::string header(pattern.starts_with(':') || pattern.starts_with('*') ? "" : ":");
  bool left_out = false;
  for (const char c : pattern) {
    if (c == '[') left_out = true;
    if (!left_out && !(c >= 'a' && c <= 'z') && c != '?') header += c;
    if (c == ']') left_out = false;
  }
  return header;
}

class TextQuestions : public Questions {
 public:
  explicit TextQuestions(const Personality& personality) : personality_(personality) {}

  std::vector<Exchange> prepare(const std::vector<AskedValue>& asked) override {
    std::vector<std::string> texts = personality_.prepare;
    const bool scans = std::ranges::any_of(asked, [](auto& one) { return one.point.empty(); });
    if (scans && personality_.scan)
      for (const auto& text : personality_.scan->prepare)
        texts.push_back(with_channels(text, asked));
    std::vector<Exchange> exchanges;
    exchanges.reserve(texts.size());
    for (const auto& text : texts)
      exchanges.push_back(text.ends_with('?') ? asking_text(text) : telling(text));
    return exchanges;
  }

  std::optional<Exchange> identify() override {
    if (personality_.identity.ask.empty()) return std::nullopt;
    return asking_text(personality_.identity.ask);
  }

  std::vector<Question> read(const std::vector<AskedValue>& asked) override {
    std::vector<std::size_t> named, numbered;
    for (std::size_t i = 0; i < asked.size(); ++i)
      (asked[i].point.empty() ? numbered : named).push_back(i);
    std::vector<Question> questions;
    if (!numbered.empty()) questions.push_back(scan(asked, std::move(numbered)));
    const std::size_t together = personality_.compound ? named.size() : 1;
    for (std::size_t from = 0; from < named.size(); from += together)
      questions.push_back(
          query(asked, std::vector(named.data() + from, named.data() + from + together)));
    return questions;
  }

  std::vector<Exchange> set(const std::vector<PointSetting>& settings) override {
    const bool checked = !personality_.set_check.empty();
    std::vector<Exchange> exchanges;
    std::vector<std::string> messages;
    const auto send = [&] {
      if (messages.empty()) return;
      if (checked) add(messages, short_header(personality_.set_check) + "?");
      for (const auto& message : messages) exchanges.push_back(telling(message));
      if (checked) exchanges.back() = checking(messages.back());
      messages.clear();
    };
    const auto ordered = in_order(settings);
    for (const PointSetting& one : ordered) {
      const auto& point = by_scpi(one.point);
      if (!point.writable) throw BadInput(fmt::format("{} is read-only", point.name));
      // IEEE 488.2 goes on behind a refusal: the last, by which the others take effect, waits for
      // the answer to those.
      if (checked && &one == &ordered.back()) send();
      add(messages, fmt::format("{} {}", short_header(point.scpi), one.value));
    }
    send();
    return exchanges;
  }

 private:
  static int channel(const AskedValue& one) { return one.at.value_or(1); }

  /// In rising order, each once.
  static std::vector<int> channels_of(const std::vector<AskedValue>& asked) {
    std::vector<int> channels;
    for (const auto& one : asked)
      if (one.point.empty()) channels.push_back(channel(one));
    std::ranges::sort(channels);
    channels.erase(std::unique(channels.begin(), channels.end()), channels.end());
    return channels;
  }

  static std::string with_channels(std::string text, const std::vector<AskedValue>& asked) {
    constexpr std::string_view kMark = "{at}";
    if (const auto from = text.find(kMark); from != std::string::npos)
      text.replace(from, kMark.size(), fmt::format("{}", fmt::join(channels_of(asked), ",")));
    return text;
  }

  /// Behind what is there where one message may hold several.
  void add(std::vector<std::string>& messages, const std::string& text) const {
    if (personality_.compound && !messages.empty()) {
      messages.back() += ';' + text;
    } else {
      messages.push_back(text);
    }
  }

  const PersonalityPoint& by_scpi(const std::string& name) const {
    const auto& point = personality_.at(name);
    if (point.scpi.empty())
      throw BadInput(fmt::format("{} has {} over Modbus only", personality_.title, name));
    return point;
  }

  std::vector<PointSetting> in_order(std::vector<PointSetting> settings) const {
    std::ranges::stable_sort(settings, {}, [&](const PointSetting& one) {
      return &personality_.at(one.point) - personality_.points.data();
    });
    return settings;
  }

  Exchange telling(const std::string& text) const {
    Exchange exchange;
    exchange.request = text + personality_.terminator;
    exchange.answered = false;
    exchange.whole = [](std::string_view) { return std::size_t{0}; };
    exchange.values = [](std::string_view) { return std::vector<double>(); };
    return exchange;
  }

  Exchange asking(const std::string& text, int lines) const {
    Exchange exchange;
    exchange.request = text.empty() ? "" : text + personality_.terminator;
    exchange.whole = [lines, end = personality_.terminator.back()](std::string_view received) {
      return whole_lines(received, lines, end);
    };
    return exchange;
  }

  Exchange asking_text(const std::string& text) const {
    Exchange exchange = asking(text, 1);
    exchange.text = [](std::string_view answer) {
      return std::string(answer.substr(0, answer.find_last_not_of("\r\n") + 1));
    };
    return exchange;
  }

  Question query(const std::vector<AskedValue>& asked, std::vector<std::size_t> places) const {
    std::string text;
    for (const std::size_t place : places) {
      const auto& point = by_scpi(asked[place].point);
      if (!point.readable) throw BadInput(fmt::format("{} is write-only", point.name));
      if (!text.empty()) text += ';';
      text += short_header(point.scpi) + '?';
    }
    Exchange exchange = asking(text, 1);
    exchange.values = [count = places.size()](std::string_view answer) {
      return spoken_numbers(answer, count);
    };
    return {exchange, std::move(places)};
  }

  Exchange checking(const std::string& text) const {
    Exchange exchange = asking(text, 1);
    exchange.values = [](std::string_view answer) {
      const auto error = answer.substr(0, answer.find_last_not_of("\r\n") + 1);
      if (spoken_number(error.substr(0, error.find(','))) != 0)
        throw Malformed(fmt::format("it reports: {}", error));
      return std::vector<double>();
    };
    return exchange;
  }

  Question scan(const std::vector<AskedValue>& asked, std::vector<std::size_t> places) const {
    if (!personality_.scan)
      throw BadInput(fmt::format("{} has no numbered channels; expected the name of a value",
                                 personality_.title));
    const PersonalityScan& scan = *personality_.scan;
    const auto channels = channels_of(asked);
    const int count =
        scan.chooses() ? static_cast<int>(channels.size()) : scan.lines * scan.columns;
    std::vector<std::size_t> picks;  // number of the answer for each place
    for (const std::size_t place : places) {
      const int at = channel(asked[place]);
      const auto chosen = std::ranges::lower_bound(channels, at) - channels.begin();
      picks.push_back(scan.chooses() ? chosen : at - 1);
      if (at < 1 || (!scan.chooses() && at > count))
        throw BadInput(
            fmt::format("{} has no channel {}; expected 1 to {}", personality_.title, at, count));
    }
    Exchange exchange = asking(with_channels(scan.ask, asked), scan.lines);
    exchange.values = [picks, numbers = static_cast<std::size_t>(count), stamped = scan.stamped,
                       no_value = scan.no_value](std::string_view answer) {
      const StampedNumbers said =
          stamped ? stamped_numbers(answer, numbers, no_value)
                  : StampedNumbers{.numbers = spoken_numbers(answer, numbers, no_value)};
      std::vector<double> values;
      values.reserve(picks.size() + 1);
      for (const std::size_t pick : picks) values.push_back(said.numbers[pick]);
      if (stamped) values.push_back(said.first_s);
      return values;
    };
    return {exchange, std::move(places), scan.stamped};
  }

  const Personality& personality_;
};

}  // namespace

std::unique_ptr<Questions> text_questions(const Personality& personality) {
  return std::make_unique<TextQuestions>(personality);
}

}  // namespace triax::lab
