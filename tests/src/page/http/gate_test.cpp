// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/gate.hpp"

#include <catch2/catch.hpp>
#include <chrono>

using namespace triax::src;
using Ruling = Gate::Ruling;

namespace {

RequestHead get_from(std::string_view host, std::string_view cookie = {}) {
  RequestHead head;
  head.host = host;
  head.cookie = cookie;
  return head;
}

}  // namespace

TEST_CASE("a token lets one browser in, once, and its cookie from then on") {
  Gate gate({"127.0.0.1", "localhost"}, 8080);
  const std::string token = gate.new_token();
  CHECK(token.size() == 32);
  CHECK(gate.address(token) == "http://127.0.0.1:8080/?token=" + token);
  RequestHead head = get_from("localhost:8080");
  CHECK(gate.judge(head) == Ruling::unknown);
  head.token = token;
  CHECK(gate.judge(head) == Ruling::enters);
  CHECK(gate.judge(head) == Ruling::unknown);
  const std::string cookie = gate.new_cookie();
  CHECK(cookie.starts_with("triax_8080="));
  CHECK(gate.judge(get_from("127.0.0.1:8080", cookie)) == Ruling::admitted);
  CHECK(gate.judge(get_from("127.0.0.1:8080", "a=b; " + cookie + ";c=d")) == Ruling::admitted);
  CHECK(gate.judge(get_from("127.0.0.1:8080", cookie + "0")) == Ruling::unknown);
  CHECK(gate.judge(get_from("127.0.0.1:8080", "triax_8080=")) == Ruling::unknown);
  CHECK(gate.new_cookie() != cookie);
}

TEST_CASE("a foreign Host uses up no token") {
  Gate gate({"127.0.0.1"}, 8080);
  const std::string token = gate.new_token();
  RequestHead head = get_from("evil.example:8080");
  head.token = token;
  CHECK(gate.judge(head) == Ruling::foreign_host);
  head.host = "127.0.0.1:8080";
  CHECK(gate.judge(head) == Ruling::enters);
}

TEST_CASE("changes need an Origin of ours and our field") {
  Gate gate({"127.0.0.1", "[::1]"}, 8080);
  RequestHead head = get_from("[::1]:8080");
  const std::string cookie = gate.new_cookie();
  head.cookie = cookie;
  head.post = true;
  CHECK(gate.judge(head) == Ruling::foreign_origin);
  head.origin = "http://[::1]:8080";
  CHECK(gate.judge(head) == Ruling::no_field);
  head.own_field = "1";
  CHECK(gate.judge(head) == Ruling::admitted);
  head.site = "cross-site";
  CHECK(gate.judge(head) == Ruling::foreign_origin);
  head.site = "same-origin";
  CHECK(gate.judge(head) == Ruling::admitted);
  for (const char* origin :
       {"https://[::1]:8080", "http://[::1]", "null", "", "http://evil:8080"}) {
    head.origin = origin;
    CHECK(gate.judge(head) == Ruling::foreign_origin);
  }
}

TEST_CASE("addresses that nobody opens do not pile up") {
  Gate gate({"127.0.0.1"}, 8080);
  const std::string oldest = gate.new_token(), second = gate.new_token();
  for (int i = 0; i < 31; ++i) gate.new_token();
  RequestHead head = get_from("127.0.0.1:8080");
  head.token = oldest;
  CHECK(gate.judge(head) == Ruling::unknown);
  head.token = second;
  CHECK(gate.judge(head) == Ruling::enters);
}

TEST_CASE("of many browsers the one that entered first is let go") {
  Gate gate({"127.0.0.1"}, 8080);
  const std::string oldest = gate.new_cookie(), second = gate.new_cookie();
  for (int i = 0; i < 255; ++i) gate.new_cookie();
  CHECK(gate.judge(get_from("127.0.0.1:8080", oldest)) == Ruling::unknown);
  CHECK(gate.judge(get_from("127.0.0.1:8080", second)) == Ruling::admitted);
}

TEST_CASE("a page of another server of this machine gets nothing of the laboratory") {
  Gate gate({"127.0.0.1"}, 8080);
  const std::string cookie = gate.new_cookie();
  RequestHead head = get_from("127.0.0.1:8080", cookie);
  head.api = true;
  for (const char* site : {"", "none", "same-origin"}) {
    head.site = site;
    CHECK(gate.judge(head) == Ruling::admitted);
  }
  for (const char* site : {"same-site", "cross-site", "x"}) {
    head.site = site;
    CHECK(gate.judge(head) == Ruling::foreign_origin);
  }
  head.api = false;  // a link to our first page
  CHECK(gate.judge(head) == Ruling::admitted);
}

namespace {

/// A gate whose clock stands where the test sets it.
struct TimedGate {
  std::chrono::seconds now{1000};
  Gate gate{{"127.0.0.1"},
            8080,
            {.token = std::chrono::seconds(60),
             .idle = std::chrono::seconds(100),
             .absolute = std::chrono::seconds(250)},
            [this] { return now; }};
};

}  // namespace

TEST_CASE("Gate: a token that nobody uses expires") {
  TimedGate timed;
  RequestHead head = get_from("127.0.0.1:8080");
  const std::string late = timed.gate.new_token(), in_time = timed.gate.new_token();
  timed.now += std::chrono::seconds(59);
  head.token = in_time;
  CHECK(timed.gate.judge(head) == Ruling::enters);
  timed.now += std::chrono::seconds(1);
  head.token = late;
  CHECK(timed.gate.judge(head) == Ruling::unknown);
}

TEST_CASE("Gate: access ends without use, and at its absolute limit") {
  TimedGate timed;
  const std::string idle = timed.gate.new_cookie(), used = timed.gate.new_cookie();
  for (int i = 0; i < 3; ++i) {
    CHECK(timed.gate.judge(get_from("127.0.0.1:8080", used)) == Ruling::admitted);
    timed.now += std::chrono::seconds(80);
  }
  CHECK(timed.gate.judge(get_from("127.0.0.1:8080", idle)) == Ruling::unknown);
  CHECK(timed.gate.has_access(used));
  timed.now += std::chrono::seconds(10);
  CHECK_FALSE(timed.gate.has_access(used));
  CHECK(timed.gate.judge(get_from("127.0.0.1:8080", used)) == Ruling::unknown);
}
