// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who may: what a request says of itself against what this server gave out. Knows no socket.
// From any thread.
#include <chrono>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::src {

std::chrono::seconds seconds_since_boot();

/// What counts of the head of a request. Empty: the field is not there.
struct RequestHead {
  bool post = false;
  bool api = false;  ///< asks for what is of the laboratory, and not for a file of the page
  std::string_view host, cookie, content_type, site;  ///< site: Sec-Fetch-Site
  std::optional<std::string_view> origin;
  std::string_view own_field;             ///< X-Triax
  std::optional<std::string_view> token;  ///< of GET /?token=...
};

/// How long tokens and cookies are valid.
struct AccessTimes {
  std::chrono::seconds token{std::chrono::hours(1)};       ///< of an address that was not opened
  std::chrono::seconds idle{std::chrono::hours(12)};       ///< of a browser, since its last request
  std::chrono::seconds absolute{std::chrono::hours(168)};  ///< of a browser, since its entry
};

class Gate {
 public:
  /// Seconds that never go back and include those that the computer slept.
  using Clock = std::function<std::chrono::seconds()>;
  enum class Ruling {
    admitted,
    enters,          ///< its token was good: gets the cookie of cookie()
    foreign_host,    ///< a name that is not ours: a page elsewhere whose name was led to us
    foreign_origin,  ///< a page of another site asks
    no_field,        ///< changes need our field, which no form of another site can send
    unknown,         ///< neither cookie nor good token
  };
  /// Browsers come to these names (IPv6 in brackets), all with this port.
  Gate(const std::vector<std::string>& names, unsigned short port, AccessTimes times = {},
       Clock clock = seconds_since_boot);

  /// Uses up the token where one is good.
  Ruling judge(const RequestHead& head);
  /// "triax_8080=..." of the browser that has just entered; valid as AccessTimes says. Of many
  /// browsers the one that entered first has to enter again.
  std::string new_cookie();
  /// Whether the Cookie field gives access now, which counts as its use.
  bool has_access(std::string_view cookies);
  /// A token that lets one browser in, once, within AccessTimes::token. Of many that nobody uses
  /// the oldest is good no more.
  std::string new_token();
  /// The address with that token.
  std::string address(const std::string& token) const;

 private:
  bool is_ours(std::string_view host) const;
  /// A token or a cookie.
  struct Secret {
    std::string word;
    std::chrono::seconds given, used;
  };
  const std::string& add(std::deque<Secret>& secrets, std::size_t most);
  void drop_expired();

  std::vector<std::string> hosts_;  ///< with ports
  std::string cookie_name_;
  AccessTimes times_;
  Clock clock_;
  std::mutex mutex_;
  std::deque<Secret> tokens_, cookies_;  ///< oldest first
};

/// 128 bits of the system's randomness in hexadecimal figures.
std::string random_word();

}  // namespace triax::src
