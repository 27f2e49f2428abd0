// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/served_line.hpp"

#include <utility>

namespace triax::lab {

ServedLine::ServedLine(LineLoop& loop, std::unique_ptr<ByteLine> line,
                       std::unique_ptr<Conversation> conversation, const LineFault& fault,
                       std::function<void()> ended)
    : loop_(loop),
      line_(std::move(line)),
      conversation_(std::move(conversation)),
      fault_(fault),
      ended_(std::move(ended)),
      last_s_(loop.now_s()) {
  line_->hear([this](std::string_view bytes) { take(bytes); },
              [this](const std::string&) { end(); });
  listen_for_silence();
}

void ServedLine::take(std::string_view bytes) {
  last_s_ = loop_.now_s();
  if (fault_.kind == WireFault::refuse) return;
  conversation_->take(bytes, reply_);
  answer();
}

void ServedLine::listen_for_silence() {
  silence_.cancel();
  const auto silence_s = conversation_->waits_s();
  if (!silence_s) return;
  silence_ = loop_.at(loop_.now_s() + *silence_s, [this] {
    // Who does not take what was said is told no more.
    if (all_sent()) conversation_->silent(reply_);
    answer();
  });
}

void ServedLine::answer() {
  listen_for_silence();
  std::string reply = std::exchange(reply_, {});
  if (!reply.empty()) {
    if (fault_.kind == WireFault::slow || !delayed_.empty()) {
      delayed_.push_back({loop_.now_s() + fault_.slow_s, std::move(reply)});
      if (delayed_.size() == 1) send_delayed();
    } else {
      send(std::move(reply));
    }
  }
  go_on();
}

void ServedLine::go_on() {
  // Who does not take replies has to wait with questions.
  line_->pause(!all_sent());
  if (all_sent() && conversation_->over()) {
    line_->close();
    end();
  }
}

void ServedLine::end() { end_ = loop_.at(loop_.now_s(), ended_); }

void ServedLine::send(std::string reply) {
  switch (fault_.kind) {
    case WireFault::none:
    case WireFault::slow:
      break;
    case WireFault::silent:
    case WireFault::refuse:
      return;
    case WireFault::half_frame:
    case WireFault::reset:
      reply.resize(reply.size() / 2);
      break;
    case WireFault::garbage:
      for (char& c : reply) {  // Marsaglia's xorshift
        noise_ ^= noise_ << 13;
        noise_ ^= noise_ >> 7;
        noise_ ^= noise_ << 17;
        c = static_cast<char>(noise_ >> 24);
      }
  }
  if (fault_.kind == WireFault::reset)
    line_->send(std::move(reply), [this] {
      line_->reset();
      end();
    });
  else
    line_->send(std::move(reply), [this] { sent(); });
}

void ServedLine::send_delayed() {
  delay_ = loop_.at(delayed_.front().at_s, [this] {
    std::string reply = std::move(delayed_.front().reply);
    delayed_.pop_front();
    send(std::move(reply));
    if (!delayed_.empty()) send_delayed();
    go_on();
  });
}

void ServedLine::sent() {
  last_s_ = loop_.now_s();
  go_on();
}

}  // namespace triax::lab
