// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/wire_instrument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lab/base/text.hpp"
#include "lab/wire/remote/reply_places.hpp"

namespace triax::lab {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

LineTimes times_of(const RigInstrument& one) {
  return {.pause_s = one.personality.pause_s, .owed_s = one.personality.deadline_s};
}

std::string trouble_of(const Asked& asked, double deadline_s) {
  switch (asked.kind) {
    case Asked::Kind::answered:
      return {};
    case Asked::Kind::late:
      return fmt::format("no response within {:g} s", deadline_s);
    case Asked::Kind::malformed:
      return "invalid response: " + asked.why;
    case Asked::Kind::closed:
      return "the connection is down: " + asked.why;
  }
  return {};
}

}  // namespace

/// A scan whose answers are awaited.
struct WireInstrument::Round {
  Scan scan;
  std::vector<double> raw;
  std::size_t open = 0;
  double deadline_s = 0;  ///< on the loop's clock
  double awaited_s = 0;   ///< at most
  std::function<void(const Scan&)> done;
};

WireInstrument::WireInstrument(LineLoop& loop, const RigInstrument& described,
                               std::vector<std::string> also)
    : loop_(loop),
      described_(described),
      questions_(questions_for(described.personality, described.link)),
      channels_(described.channels.size()),
      line_(loop, described.link, times_of(described)) {
  for (const RigChannel& channel : described.channels) asked_.push_back(channel.asked);
  for (std::string& point : also) asked_.push_back({.point = std::move(point), .at = {}});
  if (!asked_.empty()) round_ = questions_->read(asked_);
  const std::vector<ReplyPlace> all = reply_places(described, asked_);
  for (const Question& question : round_) {
    std::vector<ReplyPlace> places;
    for (const std::size_t place : question.places) places.push_back(all[place]);
    if (question.stamped) places.push_back({.name = "the instrument's clock"});
    checks_.emplace_back(std::move(places), !question.exchange.request.empty());
  }
  line_.on_lost([this](const std::string& why) { fail("the connection is down: " + why); });
}

void WireInstrument::start() { open(); }

void WireInstrument::open() {
  state_ = State::opening;
  line_.open(loop_.now_s() + described_.personality.deadline_s + 1, [this](const std::string& why) {
    why.empty() ? greet() : fail("cannot be reached: " + why);
  });
}

void WireInstrument::greet() {
  state_ = State::greeting;
  const double deadline_s = described_.personality.deadline_s;
  auto exchange = questions_->identify();
  if (!exchange) return prepare(questions_->prepare(asked_));
  line_.ask(std::move(*exchange), loop_.now_s() + deadline_s, [this, deadline_s](const Asked& a) {
    if (a.kind != Asked::Kind::answered) return fail(trouble_of(a, deadline_s));
    std::string complaint = described_.personality.complaint_about(a.text);
    if (complaint.empty() && !identity_.empty() && identity_ != a.text)
      complaint = fmt::format("has another identity than before: {} instead of {}", excerpt(a.text),
                              excerpt(identity_));
    if (!complaint.empty()) return fail(complaint);
    identity_ = a.text;
    prepare(questions_->prepare(asked_));
  });
}

void WireInstrument::prepare(std::vector<Exchange> rest) {
  if (rest.empty()) {
    state_ = State::ready;
    trouble_.clear();
    ++links_;
    return;
  }
  Exchange first = std::move(rest.front());
  rest.erase(rest.begin());
  const double deadline_s = described_.personality.deadline_s;
  line_.ask(std::move(first), loop_.now_s() + deadline_s,
            [this, deadline_s, left = std::move(rest)](const Asked& a) mutable {
              if (a.kind != Asked::Kind::answered) return fail(trouble_of(a, deadline_s));
              prepare(std::move(left));
            });
}

/// The line is closed and taken up again after a pause.
void WireInstrument::fail(const std::string& why) {
  if (state_ == State::down) return;
  const double now_s = loop_.now_s();
  if (!wrong_s_) wrong_s_ = now_s;
  state_ = State::down;
  trouble_ = why;
  const double away_s = now_s - *wrong_s_;
  const double pause_s =
      away_s < kHurry_s ? std::max(kFirstPause_s, kPauseOfAway * away_s) : kLongestPause_s;
  again_ = loop_.at(now_s + pause_s, [this] { open(); });
  line_.close(why);
}

void WireInstrument::scan(std::function<void(const Scan&)> done, double asked_s, double latest_s) {
  const auto round = std::make_shared<Round>();
  round->scan.channels.assign(channels_, {.value = kNothing});
  round->raw.assign(asked_.size(), kNothing);
  round->done = std::move(done);
  if (!ready() || round_.empty()) {
    round->scan.also.assign(asked_.size() - channels_, kNothing);
    if (!ready()) round->scan.why = trouble_.empty() ? "not connected yet" : trouble_;
    if (ready()) wrong_s_.reset();
    for (ReplyCheck& check : checks_) check.end();
    loop_.soon([round] { round->done(round->scan); });
    return;
  }
  round->open = round_.size();
  round->deadline_s = std::min(asked_s + described_.personality.deadline_s, latest_s);
  round->awaited_s = round->deadline_s - asked_s;
  for (std::size_t i = 0; i < round_.size(); ++i) ask(round, i);
}

void WireInstrument::ask(const std::shared_ptr<Round>& round, std::size_t question) {
  line_.ask(round_[question].exchange, round->deadline_s,
            [this, round, question](const Asked& asked) { take(round, question, asked); });
}

void WireInstrument::take(const std::shared_ptr<Round>& round, std::size_t question,
                          const Asked& asked) {
  const Question& of = round_[question];
  ReplyCheck& check = checks_[question];
  Scan& scan = round->scan;
  const bool answered = asked.kind == Asked::Kind::answered;
  if (scan.sent_s == 0 || (answered && of.stamped)) scan.sent_s = asked.sent_s;
  scan.answered_s = std::max(scan.answered_s, asked.answered_s);
  const std::string trouble = trouble_of(asked, round->awaited_s);
  if (answered || asked.kind == Asked::Kind::malformed) {
    const bool again = check.add({.values = asked.values,
                                  .length = asked.length,
                                  .trailing = asked.trailing,
                                  .trouble = trouble});
    // A second reply takes as long as this one did. A question that would end in its deadline would
    // cost the next scan, too.
    const double needed_s = asked.answered_s - asked.sent_s;
    if (again && line_.is_open() && loop_.now_s() + needed_s < round->deadline_s)
      return ask(round, question);
  }
  check.fail(trouble);
  const ReplyCheck::Outcome outcome = check.end();
  for (std::size_t i = 0; i < of.places.size(); ++i) round->raw[of.places[i]] = outcome.values[i];
  if (of.stamped && !std::isnan(outcome.values.back())) scan.stamp_s = outcome.values.back();
  if (!outcome.why.empty()) scan.why = outcome.why;
  if (--round->open == 0) finish(*round);
}

void WireInstrument::finish(Round& round) {
  const bool whole = round.scan.why.empty();
  if (whole) wrong_s_.reset();
  if (!whole && !wrong_s_) wrong_s_ = loop_.now_s();
  if (state_ == State::ready) trouble_ = round.scan.why;
  for (std::size_t i = 0; i < channels_; ++i)
    round.scan.channels[i] = described_.channels[i].calibration.value_of(round.raw[i]);
  round.scan.also.assign(round.raw.begin() + static_cast<std::ptrdiff_t>(channels_),
                         round.raw.end());
  round.done(round.scan);
}

void WireInstrument::set(const std::vector<PointSetting>& settings,
                         std::function<void(const std::string&)> done) {
  if (!ready()) {
    loop_.soon(
        [done = std::move(done), why = trouble_] { done(why.empty() ? "not connected" : why); });
    return;
  }
  set_next(questions_->set(settings), std::move(done));
}

/// One after the other: behind one that fails nothing is set, so that what takes effect by the last
/// does not.
void WireInstrument::set_next(std::vector<Exchange> rest,
                              std::function<void(const std::string&)> done) {
  if (rest.empty()) return done({});
  Exchange first = std::move(rest.front());
  rest.erase(rest.begin());
  const double deadline_s = described_.personality.deadline_s;
  line_.ask(
      std::move(first), loop_.now_s() + deadline_s,
      [this, deadline_s, left = std::move(rest), done = std::move(done)](const Asked& a) mutable {
        if (a.kind == Asked::Kind::answered) return set_next(std::move(left), std::move(done));
        const std::string why = trouble_of(a, deadline_s);
        if (state_ == State::ready) trouble_ = why;
        done(why);
      });
}

}  // namespace triax::lab
