// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/line.hpp"

#include <algorithm>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/wire/line/byte_line.hpp"
#include "lab/wire/line/tcp.hpp"

namespace triax::lab {
namespace {
constexpr std::size_t kMaxResponse = std::size_t{8} << 20;
constexpr double kLatency_s = 0.02;  ///< of a serial adapter that gathers bytes; 16 ms are usual
constexpr std::size_t kMostUnasked = std::size_t{64} << 10;
}  // namespace

Line::Line(LineLoop& loop, LinkAddress link, const LineTimes& times)
    : loop_(loop), link_(std::move(link)), times_(times) {}
Line::~Line() = default;

void Line::open(double deadline_s, std::function<void(const std::string&)> opened) {
  close("reopened");
  opened_ = std::move(opened);
  if (link_.is_serial()) {
    std::string why;
    try {
      take_up(serial_line(loop_, link_));
    } catch (const WorkFailed& failed) {
      why = failed.what();
    }
    opening_ = loop_.at(loop_.now_s(), [this, why] { opened_as(why); });
    return;
  }
  opening_ = loop_.at(deadline_s, [this] {
    connector_.reset();
    opened_as("no connection until the deadline");
  });
  connector_ = std::make_unique<TcpConnector>(
      loop_, link_, [this](std::unique_ptr<ByteLine> line, const std::string& why) {
        connector_.reset();
        opening_.cancel();
        if (line) take_up(std::move(line));
        opened_as(why);
      });
}

void Line::take_up(std::unique_ptr<ByteLine> line) {
  line_ = std::move(line);
  line_->hear([this](std::string_view bytes) { heard(bytes); },
              [this](const std::string& why) { lose(why); });
}

void Line::opened_as(const std::string& why) {
  if (const auto opened = std::exchange(opened_, nullptr)) opened(why);
}

void Line::ask(Exchange exchange, double deadline_s, std::function<void(const Asked&)> done) {
  const auto entry =
      std::make_shared<Pending>(Pending{std::move(exchange), deadline_s, std::move(done)});
  // An entry holds its timer: the timer must not hold it.
  entry->deadline = loop_.at(line_ ? deadline_s : loop_.now_s(),
                             [this, weak = std::weak_ptr(entry)] { at_deadline(weak.lock()); });
  queue_.push_back(entry);
  next();
}

void Line::next() {
  if (state_ == State::idle && line_ && !queue_.empty()) send_front();
}

void Line::send_front() {
  const Entry entry = queue_.front();
  state_ = State::asked;
  drop_old_answers(entry->exchange);
  entry->sent_s = loop_.now_s();
  line_->send(entry->exchange.request, [this, entry] {
    if (entry->exchange.answered || queue_.empty() || queue_.front() != entry) return;
    take_front();
    rest(State::pauses, times_.pause_s);
    entry->done({.kind = Asked::Kind::answered, .sent_s = entry->sent_s});
  });
}

/// What came before the question is no answer to it. Of what is said unasked, the beginning of the
/// answer that is under way is kept.
void Line::drop_old_answers(const Exchange& exchange) {
  if (!exchange.request.empty()) {
    received_.clear();
    part_ = true;
    return;
  }
  try {
    while (const std::size_t length = exchange.whole(received_)) {
      received_.erase(0, length);
      part_ = false;
    }
  } catch (const Malformed&) {
    received_.clear();
    part_ = true;
  }
}

void Line::heard(std::string_view bytes) {
  if (state_ == State::resyncs) return rest(State::resyncs, times_.quiet_s);
  received_ += bytes;
  if (state_ == State::asked) {
    read_answer();
  } else if (state_ == State::owed) {
    if (whole(owed_) > 0) rest(State::pauses, times_.pause_s);
  } else if (received_.size() > kMostUnasked) {
    received_.clear();
    part_ = true;
  }
}

std::size_t Line::whole(const Exchange& exchange) {
  try {
    const std::size_t length = exchange.whole(received_);
    if (length == 0 && received_.size() > kMaxResponse) throw Malformed("a response without end");
    return std::min(length, received_.size());
  } catch (const Malformed& malformed) {
    unreadable(malformed.what());
    return 0;
  }
}

void Line::unreadable(const std::string& what) {
  const bool asked = state_ == State::asked;
  const Entry entry = asked ? take_front() : nullptr;
  received_.clear();
  part_ = true;
  rest(State::resyncs, times_.quiet_s);
  if (asked) entry->done({.kind = Asked::Kind::malformed, .why = what, .sent_s = entry->sent_s});
  if (!link_.is_serial() && line_) lose(what);
}

void Line::read_answer() {
  const Exchange& exchange = queue_.front()->exchange;
  if (!exchange.answered) return;
  std::size_t length = whole(exchange);
  if (length > 0 && exchange.request.empty() && part_) {
    received_.erase(0, length);
    part_ = false;
    length = whole(exchange);
  }
  if (length == 0) return;
  const std::string answer = received_.substr(0, length);
  received_.erase(0, length);
  const Entry entry = take_front();
  Asked result{.kind = Asked::Kind::answered,
               .sent_s = entry->sent_s,
               .answered_s = loop_.now_s(),
               .length = length,
               .trailing = !entry->exchange.request.empty() && !received_.empty()};
  if (result.answered_s > entry->deadline_s) {
    // Nobody knows when it came: this process may have stood still meanwhile.
    rest(State::pauses, times_.pause_s);
    return entry->done({.kind = Asked::Kind::late, .why = "no response", .sent_s = entry->sent_s});
  }
  try {
    if (entry->exchange.values) result.values = entry->exchange.values(answer);
    if (entry->exchange.text) result.text = entry->exchange.text(answer);
  } catch (const Malformed& malformed) {
    result.kind = Asked::Kind::malformed;
    result.values.clear();
    result.why = malformed.what();
  }
  // The rest of an answer that went wrong may still come; it is no part of the next one.
  const bool wrong = result.kind == Asked::Kind::malformed || result.trailing;
  if (wrong && link_.is_serial() && !entry->exchange.request.empty())
    rest(State::resyncs, std::min(times_.quiet_s, kLatency_s));
  else
    rest(State::pauses, times_.pause_s);
  entry->done(result);
}

Line::Entry Line::take_front() {
  Entry entry = queue_.front();
  queue_.pop_front();
  entry->deadline.cancel();
  return entry;
}

void Line::rest(State state, double seconds) {
  rest_.cancel();
  state_ = seconds > 0 ? state : State::idle;
  if (seconds > 0) {
    rest_ = loop_.at(loop_.now_s() + seconds, [this] {
      state_ = State::idle;
      next();
    });
  } else {
    next();
  }
}

void Line::at_deadline(const Entry& entry) {
  const auto place = std::ranges::find(queue_, entry);
  if (!entry || place == queue_.end()) return;
  Asked result{.kind = Asked::Kind::late, .why = "no response", .sent_s = entry->sent_s};
  if (!line_) {
    result.kind = Asked::Kind::closed;
    result.why = "the connection is not open";
  } else if (state_ != State::asked || place != queue_.begin()) {
    result.why = "the connection was busy until the deadline";
  } else if (!received_.empty()) {
    result.why = "a response without its end";
  }
  const bool under_way = line_ && state_ == State::asked && place == queue_.begin();
  queue_.erase(place);
  if (under_way) owe(entry->exchange);
  entry->done(result);
}

void Line::owe(Exchange exchange) {
  if (exchange.request.empty()) return rest(State::pauses, 0);
  owed_ = std::move(exchange);
  rest_ = loop_.at(loop_.now_s() + times_.owed_s, [this] { give_up_owed(); });
  state_ = State::owed;
}

void Line::give_up_owed() {
  if (!link_.is_serial()) return lose("no response");
  state_ = State::idle;
  next();
}

void Line::cancel() {
  const bool under_way = state_ == State::asked;
  const std::deque<Entry> dropped = std::exchange(queue_, {});
  if (under_way) owe(dropped.front()->exchange);
}

void Line::drop_line() {
  connector_.reset();
  opening_.cancel();
  rest_.cancel();
  line_.reset();
  state_ = State::idle;
  received_.clear();
  part_ = true;
}

void Line::close(const std::string& why) {
  drop_line();
  const std::deque<Entry> all = std::exchange(queue_, {});
  for (const Entry& entry : all) {
    entry->deadline.cancel();
    entry->done({.kind = Asked::Kind::closed, .why = why, .sent_s = entry->sent_s});
  }
  opened_as(why);
}

void Line::lose(const std::string& why) {
  close(why);
  if (lost_) lost_(why);
}

}  // namespace triax::lab
