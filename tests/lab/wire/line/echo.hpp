// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The simplest instrument, and questions to it: a line that comes is answered by "= " and itself.
#include <utility>

#include "lab/base/text.hpp"
#include "lab/wire/conversation.hpp"
#include "lab/wire/exchange.hpp"
#include "lab/wire/line/line.hpp"
#include "lab/wire/line/wire_server.hpp"

namespace triax::wire_tests {

class Echo : public lab::Conversation {
 public:
  void take(std::string_view bytes, std::string& reply) override {
    for (const char c : bytes) {
      line_ += c;
      if (c != '\n') continue;
      over_ = line_ == "bye\n";
      reply += "= " + std::exchange(line_, {});
    }
    if (line_.size() > 100) line_.clear();
  }
  std::optional<double> waits_s() const override {
    return line_.empty() ? std::nullopt : std::optional(0.02);
  }
  void silent(std::string& reply) override { reply += "~ " + std::exchange(line_, {}) + "\n"; }
  bool over() const override { return over_; }

 private:
  std::string line_;
  bool over_ = false;
};

/// A question whose answer is a line; its value is the number behind "= ".
inline lab::Exchange question(const std::string& text) {
  return {.request = text + "\n",
          .whole =
              [](std::string_view came) {
                const std::size_t end = came.find('\n');
                if (came.find('\0') < end || came.find('\xff') < end)
                  throw lab::Malformed("no text");
                return end == std::string_view::npos ? 0 : end + 1;
              },
          .values =
              [](std::string_view answer) {
                const auto value =
                    lab::whole_text_as<double>(lab::trimmed(answer.substr(2, answer.size() - 3)));
                if (!value) throw lab::Malformed("no number: " + lab::excerpt(answer));
                return std::vector{*value};
              }};
}

/// A server of echoes and a line to it, open.
struct EchoLine {
  explicit EchoLine(const lab::WireLimits& limits = {}, const lab::LineTimes& times = {})
      : link(server.listen(
            lab::parse_link("tcp://127.0.0.1:0"), [] { return std::make_unique<Echo>(); }, limits)),
        line(loop, link, times) {}

  /// Empty, or why not.
  std::string open(double seconds = 1) {
    std::optional<std::string> said;
    line.open(loop.now_s() + seconds, [&](const std::string& why) { said = why; });
    loop.run_until([&] { return said.has_value(); }, loop.now_s() + seconds + 1);
    return said.value_or("nothing was said");
  }
  /// One question and what became of it.
  lab::Asked ask(const lab::Exchange& exchange, double seconds = 0.2) {
    std::optional<lab::Asked> asked;
    line.ask(exchange, loop.now_s() + seconds, [&](const lab::Asked& what) { asked = what; });
    loop.run_until([&] { return asked.has_value(); }, loop.now_s() + seconds + 1);
    return asked.value();
  }
  lab::Asked ask(const std::string& text, double seconds = 0.2) {
    return ask(question(text), seconds);
  }

  lab::LineLoop loop;
  lab::WireServer server{loop};
  lab::LinkAddress link;
  lab::Line line;
};

}  // namespace triax::wire_tests
