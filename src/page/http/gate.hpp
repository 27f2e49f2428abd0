// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Who may: what a request says of itself against what this server gave out. Knows no socket.
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::src {

/// What counts of the head of a request. Empty: the field is not there.
struct RequestHead {
  bool post = false;
  bool api = false;  ///< asks for what is of the laboratory, and not for a file of the page
  std::string_view host, cookie, content_type, site;  ///< site: Sec-Fetch-Site
  std::optional<std::string_view> origin;
  std::string_view own_field;             ///< X-Triax
  std::optional<std::string_view> token;  ///< of GET /?token=...
};

class Gate {
 public:
  enum class Ruling {
    admitted,
    enters,          ///< its token was good: gets the cookie of cookie()
    foreign_host,    ///< a name that is not ours: a page elsewhere whose name was led to us
    foreign_origin,  ///< a page of another site asks
    no_field,        ///< changes need our field, which no form of another site can send
    unknown,         ///< neither cookie nor good token
  };
  /// Browsers come to these names (IPv6 in brackets), all with this port.
  Gate(const std::vector<std::string>& names, unsigned short port);

  /// Uses up the token where one is good.
  Ruling judge(const RequestHead& head);
  /// "triax_8080=..." of the browser that has just entered. Of many browsers the one that entered
  /// first has to enter anew.
  std::string new_cookie();
  /// A token that lets one browser in, once. Of many that nobody uses the oldest is good no more.
  std::string new_token();
  /// The address with that token.
  std::string address(const std::string& token) const;

 private:
  bool is_ours(std::string_view host) const;
  bool has_cookie(std::string_view cookies) const;

  std::vector<std::string> hosts_;  ///< with ports
  std::string cookie_name_;
  mutable std::mutex mutex_;
  std::deque<std::string> tokens_, cookies_;  ///< oldest first
};

/// 128 bits of the system's randomness in hexadecimal figures.
std::string random_word();

}  // namespace triax::src
