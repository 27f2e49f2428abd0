// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One client of a WireServer. For the classes of this folder.
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lab/wire/conversation.hpp"
#include "lab/wire/line/byte_line.hpp"
#include "lab/wire/line/wire_server.hpp"

namespace triax::lab {

/// The fault of a listener, shared by its clients.
struct LineFault {
  WireFault kind = WireFault::none;
  double slow_s = 0;
};

class ServedLine {
 public:
  /// `ended` is called once from the loop; it may end the life of this.
  ServedLine(LineLoop& loop, std::unique_ptr<ByteLine> line,
             std::unique_ptr<Conversation> conversation, const LineFault& fault,
             std::function<void()> ended);

  /// When something last came or left, on the loop's clock.
  double last_s() const { return last_s_; }
  /// Ends it with a TCP reset, without a call.
  void reset() { line_->reset(); }

 private:
  void take(std::string_view bytes);
  void listen_for_silence();
  void answer();
  /// A reply that is not late: sends it as the fault lets it.
  void send(std::string reply);
  void send_delayed();
  void sent();
  /// Reads on, or closes what is over, once all has left.
  void go_on();
  void end();
  bool all_sent() const { return delayed_.empty() && line_->unsent() == 0; }

  LineLoop& loop_;
  std::unique_ptr<ByteLine> line_;
  std::unique_ptr<Conversation> conversation_;
  const LineFault& fault_;
  std::function<void()> ended_;
  std::string reply_;
  struct Delayed {
    double at_s;
    std::string reply;
  };
  std::deque<Delayed> delayed_;
  LineTimer silence_, delay_, end_;
  double last_s_;
  std::uint64_t noise_ = 88172645463325252u;
};

}  // namespace triax::lab
