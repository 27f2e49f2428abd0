// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a question on a line that is well, and on one that is not.
#include <fcntl.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "tests/lab/wire/line/echo.hpp"

using namespace triax::lab;
using namespace triax::wire_tests;
using Kind = Asked::Kind;

TEST_CASE("questions are answered in their order, each with its own answer") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  std::vector<double> got;
  for (int i = 0; i < 50; ++i)
    echo.line.ask(question(std::to_string(i)), echo.loop.now_s() + 1,
                  [&](const Asked& asked) { got.push_back(asked.values.at(0)); });
  CHECK(got.empty());
  CHECK(echo.line.waiting() == 50);
  CHECK(echo.loop.run_until([&] { return got.size() == 50; }, echo.loop.now_s() + 2));
  for (int i = 0; i < 50; ++i) CHECK(got[i] == i);
  const Asked asked = echo.ask("7");
  CHECK(asked.sent_s > 0);
  CHECK(asked.answered_s >= asked.sent_s);
  CHECK(asked.answered_s <= echo.loop.now_s());
}

TEST_CASE("a message that wants no answer is done when it has left") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  Exchange told = question("1");
  told.answered = false;
  CHECK(echo.ask(told).kind == Kind::answered);
  CHECK(echo.ask(told).values.empty());
  echo.loop.run_for(0.05);  // the echo of it comes all the same
  CHECK(echo.ask("2").values == std::vector{2.0});
}

TEST_CASE("an answer that is late is never taken for the next one") {
  EchoLine echo({}, {.owed_s = 0.3});
  REQUIRE(echo.open() == "");
  echo.server.set_fault(echo.link, WireFault::slow, 0.15);
  const Asked late = echo.ask("1", 0.1);
  CHECK(late.kind == Kind::late);
  CHECK(late.why == "no response");
  CHECK(echo.loop.now_s() - late.sent_s < 1);
  echo.server.set_fault(echo.link, WireFault::none);
  CHECK(echo.ask("2", 0.3).values == std::vector{2.0});
  CHECK(echo.line.is_open());

  SECTION("in time it is an answer") {
    echo.server.set_fault(echo.link, WireFault::slow, 0.05);
    CHECK(echo.ask("3", 0.3).values == std::vector{3.0});
  }
  SECTION("where it never comes the line is closed, and can be opened anew") {
    std::string lost;
    echo.line.on_lost([&](const std::string& why) { lost = why; });
    echo.server.set_fault(echo.link, WireFault::silent);
    CHECK(echo.ask("4", 0.05).kind == Kind::late);
    CHECK(echo.ask("5", 0.05).why == "the connection was busy until the deadline");
    CHECK(echo.loop.run_until([&] { return !lost.empty(); }, echo.loop.now_s() + 1));
    CHECK_FALSE(echo.line.is_open());
    CHECK(echo.ask("6").kind == Kind::closed);
    echo.server.set_fault(echo.link, WireFault::none);
    REQUIRE(echo.open() == "");
    CHECK(echo.ask("7").values == std::vector{7.0});
  }
}

TEST_CASE("Line: an answer that is read after the deadline is late", "[wire][line]") {
  LineLoop instrument;
  WireServer server(instrument);
  const LinkAddress link =
      server.listen(parse_link("tcp://127.0.0.1:0"), [] { return std::make_unique<Echo>(); });
  LineLoop loop;
  Line line(loop, link);
  line.open(loop.now_s() + 1, {});
  REQUIRE(loop.run_until([&] { return line.is_open(); }, loop.now_s() + 1));
  std::optional<Asked> late, next;
  line.ask(question("1"), loop.now_s() + 0.05, [&](const Asked& asked) { late = asked; });
  instrument.run_for(0.2);  // it answers at once, and this side stands still
  loop.run_until([&] { return late.has_value(); }, loop.now_s() + 1);
  REQUIRE(late);
  CHECK(late->kind == Kind::late);
  CHECK(late->values.empty());
  line.ask(question("2"), loop.now_s() + 1, [&](const Asked& asked) { next = asked; });
  loop.run_until(
      [&] {
        instrument.poll();
        return next.has_value();
      },
      loop.now_s() + 1);
  CHECK(next.value().values == std::vector{2.0});
}

TEST_CASE("half an answer, garbage and a reset are told as what they are") {
  EchoLine echo({}, {.owed_s = 0.1});
  REQUIRE(echo.open() == "");
  CHECK(echo.ask("x").kind == Kind::malformed);
  CHECK(echo.ask("x").why.starts_with("no number: '= x"));
  CHECK(echo.line.is_open());

  echo.server.set_fault(echo.link, WireFault::half_frame);
  const Asked half = echo.ask("123456", 0.05);
  CHECK(half.kind == Kind::late);
  CHECK(half.why == "a response without its end");
  echo.loop.run_for(0.15);
  CHECK_FALSE(echo.line.is_open());

  echo.server.set_fault(echo.link, WireFault::garbage);
  REQUIRE(echo.open() == "");
  const Asked garbage = echo.ask(std::string(99, '1'), 0.05);
  CHECK(garbage.kind != Kind::answered);
  CHECK(garbage.values.empty());

  echo.server.set_fault(echo.link, WireFault::reset);
  REQUIRE(echo.open() == "");
  const Asked reset = echo.ask("123456");
  CHECK(reset.kind == Kind::closed);
  CHECK(reset.why == "Connection reset by peer");
  CHECK_FALSE(echo.line.is_open());
}

TEST_CASE("a cable that is out refuses, and is in again") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  std::string lost;
  echo.line.on_lost([&](const std::string& why) { lost = why; });
  echo.server.set_fault(echo.link, WireFault::refuse);
  CHECK(echo.loop.run_until([&] { return !lost.empty(); }, echo.loop.now_s() + 1));
  CHECK(echo.open() == "Connection refused");
  echo.server.set_fault(echo.link, WireFault::none);
  REQUIRE(echo.open() == "");
  CHECK(echo.ask("1").values == std::vector{1.0});
}

TEST_CASE("what is closed is done, what is cancelled is never told") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  std::vector<std::string> whys;
  const auto ask = [&](const char* text) {
    echo.line.ask(question(text), echo.loop.now_s() + 0.1,
                  [&](const Asked& asked) { whys.push_back(asked.why); });
  };
  ask("1");
  ask("2");
  echo.line.cancel();
  echo.loop.run_for(0.15);
  CHECK(whys.empty());
  CHECK(echo.ask("3").values == std::vector{3.0});
  ask("4");
  ask("5");
  echo.line.close("enough");
  CHECK(whys == std::vector<std::string>{"enough", "enough"});
}

TEST_CASE("a handler may ask, close and open") {
  EchoLine echo;
  double got = 0;
  echo.line.open(echo.loop.now_s() + 1, [&](const std::string&) {
    echo.line.ask(question("1"), echo.loop.now_s() + 1, [&](const Asked&) {
      echo.line.close();
      echo.line.open(echo.loop.now_s() + 1, [&](const std::string&) {
        echo.line.ask(question("2"), echo.loop.now_s() + 1,
                      [&](const Asked& asked) { got = asked.values.at(0); });
      });
    });
  });
  CHECK(echo.loop.run_until([&] { return got == 2; }, echo.loop.now_s() + 2));
}

namespace {
/// Says 1, 2, 3 ... unasked, each in two halves.
class Counter : public Conversation {
 public:
  void take(std::string_view, std::string&) override {}
  std::optional<double> waits_s() const override { return 0.02; }
  void silent(std::string& reply) override {
    reply += half_ ? "0\n" : "= " + std::to_string(++count_);
    half_ = !half_;
  }

 private:
  int count_ = 0;
  bool half_ = false;
};
}  // namespace

TEST_CASE("what an instrument says unasked is taken line by line, never a part, never an old one") {
  EchoLine echo;
  const LinkAddress link = echo.server.listen(parse_link("tcp://127.0.0.1:0"),
                                              [] { return std::make_unique<Counter>(); });
  Line line(echo.loop, link);
  Exchange said = question("");
  said.request.clear();
  std::vector<double> got;
  const auto ask = [&](double seconds) {
    const std::size_t before = got.size();
    line.ask(said, echo.loop.now_s() + seconds, [&](const Asked& asked) {
      got.push_back(asked.kind == Kind::answered ? asked.values.at(0) : -1);
    });
    echo.loop.run_until([&] { return got.size() > before; }, echo.loop.now_s() + 2);
  };
  line.open(echo.loop.now_s() + 1, {});
  REQUIRE(echo.loop.run_until([&] { return line.is_open(); }, echo.loop.now_s() + 1));
  ask(1);  // 10 may be a part of a longer number
  ask(1);
  CHECK(got == std::vector<double>{20, 30});
  echo.loop.run_for(0.25);  // those of meanwhile are old
  ask(1);
  CHECK(got.at(2) >= 70);
  CHECK(std::fmod(got.at(2), 10) == 0);
  ask(0.001);
  CHECK(got.at(3) == -1);
  ask(1);
  CHECK(got.at(4) >= got.at(2) + 10);
}

TEST_CASE("Line: an answer has its length, and says if more bytes follow") {
  EchoLine echo;
  REQUIRE(echo.open() == "");
  const Asked alone = echo.ask("12");
  CHECK(alone.length == 5);
  CHECK_FALSE(alone.trailing);
  const Asked followed = echo.ask("1\n2");
  CHECK(followed.values == std::vector{1.0});
  CHECK(followed.length == 4);
  CHECK(followed.trailing);
}

TEST_CASE("Line: a serial line waits until the rest of a wrong answer has come") {
  int instrument = -1, client = -1;
  char name[100];
  REQUIRE(::openpty(&instrument, &client, name, nullptr, nullptr) == 0);
  termios raw{};
  ::tcgetattr(instrument, &raw);
  ::cfmakeraw(&raw);
  ::tcsetattr(instrument, TCSANOW, &raw);
  ::fcntl(instrument, F_SETFL, O_NONBLOCK);
  const auto say = [instrument](const std::string& text) {
    REQUIRE(::write(instrument, text.data(), text.size()) == std::ssize(text));
  };
  LineLoop loop;
  Line line(loop, parse_link(std::string("serial://") + name));
  line.open(1, [](const std::string&) {});
  std::vector<Asked> asked;
  const auto ask = [&](const std::string& text) {
    line.ask(question(text), loop.now_s() + 1, [&](const Asked& one) { asked.push_back(one); });
  };
  const auto wait_for = [&](std::size_t count) {
    return loop.run_until([&] { return asked.size() == count; }, loop.now_s() + 1);
  };
  ask("1");
  loop.run_for(0.01);
  say("= x\n");
  REQUIRE(wait_for(1));
  CHECK(asked[0].kind == Kind::malformed);
  ask("2");
  loop.run_for(0.01);
  say("= 9\n");
  loop.run_for(0.1);
  char questions[10];
  CHECK(::read(instrument, questions, sizeof questions) == 4);
  say("= 2\n");
  REQUIRE(wait_for(2));
  CHECK(asked[1].values == std::vector{2.0});
  line.close();
  ::close(instrument);
  ::close(client);
}
