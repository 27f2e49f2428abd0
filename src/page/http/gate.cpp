// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/gate.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostTokens = 32, kMostCookies = 256;

bool same_name(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// A new word behind those that are there, of which there are at most so many.
const std::string& add_word(std::deque<std::string>& words, std::size_t most) {
  words.push_back(random_word());
  if (words.size() > most) words.pop_front();
  return words.back();
}

}  // namespace

std::string random_word() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw lab::WorkFailed("the system gives no random numbers");
  std::string word;
  for (const unsigned char byte : bytes) word += fmt::format("{:02x}", byte);
  return word;
}

Gate::Gate(const std::vector<std::string>& names, unsigned short port)
    : cookie_name_(fmt::format("triax_{}", port)) {
  constexpr unsigned short kUsual = 80;  // which browsers leave out
  for (const std::string& name : names)
    hosts_.push_back(port == kUsual ? name : fmt::format("{}:{}", name, port));
}

bool Gate::is_ours(std::string_view host) const {
  return std::ranges::any_of(hosts_, [&](const auto& ours) { return same_name(ours, host); });
}

bool Gate::has_cookie(std::string_view cookies) const {
  const std::lock_guard lock(mutex_);
  while (!cookies.empty()) {
    const auto end = std::min(cookies.find(';'), cookies.size());
    const std::string_view one = lab::trimmed(cookies.substr(0, end));
    const auto equals = std::min(one.find('='), one.size());
    if (one.substr(0, equals) == cookie_name_ && equals < one.size() &&
        std::ranges::find(cookies_, one.substr(equals + 1)) != cookies_.end())
      return true;
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
    const auto found = std::ranges::find(tokens_, *head.token);
    if (found != tokens_.end()) {
      tokens_.erase(found);
      return Ruling::enters;
    }
  }
  return has_cookie(head.cookie) ? Ruling::admitted : Ruling::unknown;
}

std::string Gate::new_cookie() {
  const std::lock_guard lock(mutex_);
  return cookie_name_ + "=" + add_word(cookies_, kMostCookies);
}

std::string Gate::new_token() {
  const std::lock_guard lock(mutex_);
  return add_word(tokens_, kMostTokens);
}

std::string Gate::address(const std::string& token) const {
  return fmt::format("http://{}/?token={}", hosts_.front(), token);
}

}  // namespace triax::src
