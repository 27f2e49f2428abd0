// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace triax::lab {

/// The instrument's side of one client's line, as bytes in and bytes out: no socket, no clock. Any
/// piece of what a client sends may come at a time. What is appended to `reply` leaves in one
/// write.
class Conversation {
 public:
  virtual ~Conversation() = default;
  Conversation() = default;
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;

  /// The next bytes of the client. Never throws for what a client sent; what it keeps is bounded.
  virtual void take(std::string_view bytes, std::string& reply) = 0;
  /// After how long a silence silent() is to be called, s; empty: what was taken is whole. It is
  /// asked at the beginning, after take() and after silent(): who speaks unasked always gives one.
  virtual std::optional<double> waits_s() const { return std::nullopt; }
  /// The line was silent for so long: what came without a terminator counts as whole, or is
  /// dropped.
  virtual void silent(std::string& /*reply*/) {}
  /// The line is to be closed once the reply has left: a client that cannot be understood any more.
  virtual bool over() const { return false; }
};

}  // namespace triax::lab
