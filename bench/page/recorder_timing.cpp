// SPDX-License-Identifier: GPL-3.0-or-later
// Whether browsers disturb who records: the same paced test with none and with some that look at
// it, in turn. Intervals between two readings as the session tells them, and what adding to the
// feed costs. bench_recorder_timing [SECONDS [PAIRS [BROWSERS]]]
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "lab/rig/simulated/virtual_rig.hpp"
#include "src/page/api/programme_form.hpp"
#include "src/page/http/server.hpp"
#include "src/page/live/live_feed.hpp"
#include "src/study/triaxial/test_run.hpp"

namespace {

using namespace triax;
using Clock = std::chrono::steady_clock;

constexpr double kReadingsPerSecond = 100, kInterval_s = 2;

int connected(unsigned short port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    std::abort();
  return socket;
}

std::string asked(int socket, const std::string& request) {
  if (::send(socket, request.data(), request.size(), 0) < 0) std::abort();
  std::string answer(4096, '\0');
  const auto come = ::recv(socket, answer.data(), answer.size(), 0);
  answer.resize(static_cast<std::size_t>(std::max<ssize_t>(come, 0)));
  return answer;
}

/// Enters with a token of its own, and reads the stream as it comes.
void browse(src::PageServer& server, std::atomic<std::size_t>& bytes, std::atomic<bool>& go) {
  const std::string address = server.new_address();
  const std::string host = fmt::format("127.0.0.1:{}", server.port());
  int socket = connected(server.port());
  const std::string entered = asked(socket, fmt::format("GET /{} HTTP/1.1\r\nHost: {}\r\n\r\n",
                                                        address.substr(address.find('?')), host));
  ::close(socket);
  const auto from = entered.find("Set-Cookie: ") + 12;
  socket = connected(server.port());
  asked(socket, fmt::format("GET /live HTTP/1.1\r\nHost: {}\r\nCookie: {}\r\n\r\n", host,
                            entered.substr(from, entered.find(';', from) - from)));
  std::array<char, 65536> part{};
  while (go) {
    const auto come = ::recv(socket, part.data(), part.size(), 0);
    if (come <= 0) break;
    bytes += static_cast<std::size_t>(come);
  }
  ::close(socket);
}

struct Timing {
  std::vector<double> intervals_ms, feed_us;
  std::size_t bytes = 0;
};

double share_of(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

void run(std::string db, double seconds, int browsers, Timing& timing) {
  const auto feed = std::make_shared<src::LiveFeed>();
  src::PageServer server({.answer = [&](const src::PageRequest&) {
    return src::PageAnswer{.live = src::LiveStart{feed, {}}};
  }});
  std::atomic<std::size_t> bytes = 0;
  std::atomic<bool> go = true;
  std::vector<std::thread> all;
  for (int i = 0; i < browsers; ++i) all.emplace_back([&] { browse(server, bytes, go); });
  lab::VirtualRig rig(src::programme_of(
      "csu_26", {{"stages.4.end.1.above", "90000"}, {"stages.4.time_limit_min", "100000"}}));
  Clock::time_point before{}, begin = Clock::now();
  const lab::SessionListener timed = {.scanned = [&](const lab::Reading& reading,
                                                     const lab::State& state) {
    const auto now = Clock::now();
    if (reading.number > 100)
      timing.intervals_ms.push_back(
          std::chrono::duration<double, std::milli>(now - before).count());
    before = now;
    feed->scanned(reading, state);
    timing.feed_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - now).count());
  }};
  const auto stop = [&] { return Clock::now() - begin > std::chrono::duration<double>(seconds); };
  study::run_test(rig, {.reduction = {}, .speed = kReadingsPerSecond * kInterval_s, .stop = stop},
                  db, {timed});
  feed->ended("complete");
  for (auto& one : all) one.join();
  go = false;
  timing.bytes += bytes;
}

void tell(const char* what, const Timing& timing) {
  fmt::print("{:<20} {:>8} {:>12.3f} {:>10.3f} {:>14.2f} {:>10.2f} {:>10.1f}\n", what,
             timing.intervals_ms.size(), share_of(timing.intervals_ms, 0.5),
             share_of(timing.intervals_ms, 0.99), share_of(timing.feed_us, 0.5),
             share_of(timing.feed_us, 0.99), static_cast<double>(timing.bytes) / 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 20;
  const int pairs = argc > 2 ? std::atoi(argv[2]) : 5,
            browsers = argc > 3 ? std::atoi(argv[3]) : 10;
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("triax-timing-{}", ::getpid());
  std::filesystem::create_directory(folder);
  Timing none, some;
  for (int i = 0; i < pairs; ++i) {
    run((folder / "tests.db").string(), seconds, 0, none);
    run((folder / "tests.db").string(), seconds, browsers, some);
  }
  std::filesystem::remove_all(folder);
  fmt::print("{:g} readings a second, {} times {:g} s each way\n\n", kReadingsPerSecond, pairs,
             seconds);
  fmt::print("{:<20} {:>8} {:>12} {:>10} {:>14} {:>10} {:>10}\n", "", "readings", "interval ms",
             "99 %", "into feed us", "99 %", "sent MB");
  tell("no browser", none);
  tell(fmt::format("{} browsers", browsers).c_str(), some);
  const double median = share_of(some.intervals_ms, 0.5) / share_of(none.intervals_ms, 0.5) - 1;
  const double tail = share_of(some.intervals_ms, 0.99) / share_of(none.intervals_ms, 0.99) - 1;
  fmt::print("\nintervals with browsers: median {:+.2f} %, 99 % {:+.2f} %\n", 100 * median,
             100 * tail);
  const bool held = median <= 0.05 && tail <= 0.05;
  fmt::print("    asked: both within 5 %\n");
  if (!held) fmt::print(stderr, "NOT held: both within 5 %\n");
  return held ? 0 : 1;
}
