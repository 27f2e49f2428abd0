// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/reply_check.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace triax::lab;
using Catch::Contains;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ReplyPlace place(const std::string& name) {
  ReplyPlace channel;
  channel.name = name;
  return channel;
}

Reply reply(std::vector<double> values, std::size_t length = 8) {
  return {.values = std::move(values), .length = length};
}

Reply malformed() { return {.values = {}, .trouble = "invalid response: no number"}; }

/// The replies of one scan, of which all but the last are to be followed by another question.
ReplyCheck::Outcome scan(ReplyCheck& check, const std::vector<Reply>& replies) {
  for (std::size_t i = 0; i < replies.size(); ++i) {
    INFO("reply " << i + 1 << " of " << replies.size());
    REQUIRE(check.add(replies[i]) == (i + 1 < replies.size()));
  }
  return check.end();
}

/// A check of these channels that has had some readings of `values`.
ReplyCheck settled(std::vector<ReplyPlace> places, const std::vector<double>& values) {
  ReplyCheck check(std::move(places), true);
  scan(check, std::vector(ReplyCheck::kFirstReplies, reply(values)));
  for (int i = 0; i < ReplyCheck::kSteady; ++i) scan(check, {reply(values)});
  return check;
}

ReplyCheck settled_at(double value) { return settled({place("pore_pressure")}, {value}); }

}  // namespace

TEST_CASE("ReplyCheck: the first reading is the median of five replies") {
  for (const std::size_t garbled : {0, 2, 4}) {
    ReplyCheck check({place("u")}, true);
    std::vector<Reply> replies(ReplyCheck::kFirstReplies, reply({300}));
    replies[garbled] = reply({3005}, 9);
    const auto outcome = scan(check, replies);
    CHECK(outcome.values == std::vector<double>{300});
    CHECK(outcome.why.empty());
  }
}

TEST_CASE("ReplyCheck: first replies that come late are completed by later scans") {
  ReplyCheck check({place("u")}, true);
  for (int i = 0; i < 3; ++i) CHECK(check.add(reply({300})));
  check.fail("no response within 1 s");
  const auto late = check.end();
  CHECK(std::isnan(late.values[0]));
  CHECK(late.why == "no response within 1 s");
  CHECK(scan(check, {reply({300}), reply({300})}).values[0] == 300);
}

TEST_CASE("ReplyCheck: a garbled value is asked for again") {
  ReplyCheck check = settled_at(300);
  CHECK(scan(check, {reply({3005}), reply({300})}).values[0] == 300);
}

TEST_CASE("ReplyCheck: a genuine jump is a reading of the same scan") {
  ReplyCheck check = settled_at(300);
  CHECK(scan(check, {reply({200}), reply({197}), reply({195})}).values[0] == 195);
}

TEST_CASE("ReplyCheck: two replies with a doubled digit each make no reading") {
  ReplyCheck check = settled_at(23106);
  CHECK(scan(check, {reply({231106}), reply({231066}), reply({23106})}).values[0] == 23106);
}

TEST_CASE("ReplyCheck: values that disagree are missing with their cause") {
  ReplyCheck check = settled_at(300);
  const auto outcome =
      scan(check, {reply({3005}), reply({30.5}), reply({4711}), reply({1}), reply({900})});
  CHECK(std::isnan(outcome.values[0]));
  CHECK(outcome.why ==
        "response rejected: pore_pressure 900 when queried again, expected about 300");
  CHECK(scan(check, {reply({300})}).why.empty());
}

TEST_CASE("ReplyCheck: a channel that is rejected leaves the others") {
  ReplyCheck check = settled({place("u"), place("force")}, {300, 20});
  std::vector<Reply> replies;
  for (const double force : {2000, 200, 2, 700, 60}) replies.push_back(reply({300, force}));
  const auto outcome = scan(check, replies);
  CHECK(outcome.values[0] == 300);
  CHECK(std::isnan(outcome.values[1]));
}

TEST_CASE("ReplyCheck: a reply of another length is asked for again") {
  ReplyCheck check = settled_at(300);
  CHECK(scan(check, {reply({300}, 7), reply({300}, 8)}).why.empty());
  // A number that has become longer.
  CHECK(scan(check, {reply({300}, 9), reply({300}, 9)}).values[0] == 300);
}

TEST_CASE("ReplyCheck: a reply that bytes follow is never taken") {
  ReplyCheck check = settled_at(300);
  Reply followed = reply({300});
  followed.trailing = true;
  CHECK(scan(check, {followed, reply({300})}).values[0] == 300);
  CHECK_THAT(scan(check, std::vector(ReplyCheck::kMaxReplies, followed)).why,
             Contains("bytes and more"));
}

TEST_CASE("ReplyCheck: what cannot be understood is asked for again, then missing") {
  ReplyCheck check = settled_at(300);
  CHECK(scan(check, {malformed(), reply({300})}).values[0] == 300);
  const auto outcome = scan(check, std::vector(ReplyCheck::kMaxReplies, malformed()));
  CHECK(std::isnan(outcome.values[0]));
  CHECK(outcome.why == "invalid response: no number");
}

TEST_CASE("ReplyCheck: an impossible value is never taken, however often it comes") {
  ReplyPlace limited = place("u");
  limited.possible = {-1000, 1000};
  ReplyCheck check = settled({limited}, {300});
  const auto outcome = scan(check, std::vector(ReplyCheck::kMaxReplies, reply({2000})));
  CHECK(std::isnan(outcome.values[0]));
  CHECK_THAT(outcome.why, Contains("u 2000 is outside -1000 to 1000"));
  ReplyCheck begun({limited}, true);
  CHECK_THAT(scan(begun, std::vector(ReplyCheck::kFirstReplies, reply({2000}))).why,
             Contains("outside"));
}

TEST_CASE("ReplyCheck: the end of the calibrated range needs confirmation once") {
  ReplyPlace limited = place("u");
  limited.calibrated = {0, 10};
  ReplyCheck check = settled({limited}, {9});
  scan(check, std::vector(3, reply({10})));  // a ramp begins
  CHECK(scan(check, std::vector(3, reply({11}))).values[0] == 11);
  CHECK(scan(check, {reply({12})}).values[0] == 12);
}

TEST_CASE("ReplyCheck: an instrument without a value has none, and nothing is rejected") {
  ReplyCheck check = settled({place("u"), place("open")}, {300, kNone});
  const auto outcome = scan(check, {reply({300, kNone})});
  CHECK(std::isnan(outcome.values[1]));
  CHECK(outcome.why.empty());
  CHECK(scan(check, std::vector(3, reply({300, 5}))).values[1] == 5);
}

TEST_CASE("ReplyCheck: a jump of an instrument that speaks unasked waits for its next reply") {
  ReplyCheck check({place("mass")}, false);
  for (int i = 0; i < 3; ++i) CHECK(scan(check, {reply({50})}).values[0] == 50);
  CHECK(std::isnan(scan(check, {reply({550})}).values[0]));
  CHECK(scan(check, {reply({50})}).values[0] == 50);
  CHECK(std::isnan(scan(check, {reply({70})}).values[0]));
  CHECK(scan(check, {reply({70})}).values[0] == 70);
}
