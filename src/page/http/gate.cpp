// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/gate.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostTokens = 32, kMostCookies = 256;

bool same_name(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::string random_word() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw lab::WorkFailed("the system provides no random numbers");
  std::string word;
  for (const unsigned char byte : bytes) word += fmt::format("{:02x}", byte);
  return word;
}

std::chrono::seconds seconds_since_boot() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::chrono::seconds(now.tv_sec);
}

Gate::Gate(const std::vector<std::string>& names, unsigned short port, AccessTimes times,
           Clock clock)
    : cookie_name_(fmt::format("triax_{}", port)), times_(times), clock_(std::move(clock)) {
  constexpr unsigned short kUsual = 80;  // which browsers leave out
  for (const std::string& name : names)
    hosts_.push_back(port == kUsual ? name : fmt::format("{}:{}", name, port));
}

bool Gate::is_ours(std::string_view host) const {
  return std::ranges::any_of(hosts_, [&](const auto& ours) { return same_name(ours, host); });
}

/// Inside the lock.
void Gate::drop_expired() {
  const auto now = clock_();
  std::erase_if(tokens_, [&](const Secret& one) { return now - one.given >= times_.token; });
  std::erase_if(cookies_, [&](const Secret& one) {
    return now - one.given >= times_.absolute || now - one.used >= times_.idle;
  });
}

/// A new one behind those that are there, of which there are at most so many. Inside the lock.
const std::string& Gate::add(std::deque<Secret>& secrets, std::size_t most) {
  secrets.push_back({random_word(), clock_(), clock_()});
  if (secrets.size() > most) secrets.pop_front();
  return secrets.back().word;
}

bool Gate::has_access(std::string_view cookies) {
  const std::lock_guard lock(mutex_);
  drop_expired();
  while (!cookies.empty()) {
    const auto end = std::min(cookies.find(';'), cookies.size());
    const std::string_view one = lab::trimmed(cookies.substr(0, end));
    const auto equals = std::min(one.find('='), one.size());
    if (one.substr(0, equals) == cookie_name_ && equals < one.size()) {
      const auto found = std::ranges::find(cookies_, one.substr(equals + 1), &Secret::word);
      if (found != cookies_.end()) {
        found->used = clock_();
        return true;
      }
    }
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
  }
  return false;
}

Gate::Ruling Gate::judge(const RequestHead& head) {
  if (!is_ours(head.host)) return Ruling::foreign_host;
  constexpr std::string_view kScheme = "http://";
  // Compared with what is ours and not with Host, which whoever sends the one may send as well.
  if (head.origin &&
      (!head.origin->starts_with(kScheme) || !is_ours(head.origin->substr(kScheme.size()))))
    return Ruling::foreign_origin;
  // Of no use to a page elsewhere: it may lead a browser to our first page, by a link, and no more.
  if (head.post && (!head.origin || (!head.site.empty() && head.site != "same-origin")))
    return Ruling::foreign_origin;
  // Cookies know no ports: to a browser a page of another server of this machine is of the same
  // site as ours.
  if (head.api && !head.site.empty() && head.site != "same-origin" && head.site != "none")
    return Ruling::foreign_origin;
  if (head.post && head.own_field != "1") return Ruling::no_field;
  if (head.token) {
    const std::lock_guard lock(mutex_);
    drop_expired();
    const auto found = std::ranges::find(tokens_, *head.token, &Secret::word);
    if (found != tokens_.end()) {
      tokens_.erase(found);
      return Ruling::enters;
    }
  }
  return has_access(head.cookie) ? Ruling::admitted : Ruling::unknown;
}

std::string Gate::new_cookie() {
  const std::lock_guard lock(mutex_);
  return cookie_name_ + "=" + add(cookies_, kMostCookies);
}

std::string Gate::new_token() {
  const std::lock_guard lock(mutex_);
  return add(tokens_, kMostTokens);
}

std::string Gate::address(const std::string& token) const {
  return fmt::format("http://{}/?token={}", hosts_.front(), token);
}

}  // namespace triax::src
