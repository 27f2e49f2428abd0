// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The instrument's side of the wire: listens, and gives every client a conversation of its own.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "lab/wire/conversation.hpp"
#include "lab/wire/line/line_loop.hpp"
#include "lab/wire/link_address.hpp"

namespace triax::lab {

struct WireLimits {
  /// Clients of one listener at a time; a further one is closed at once.
  int clients = 64;
  /// A client that neither sends nor takes anything for so long is closed. A serial port stays.
  double idle_s = 3600;
};

/// What is wrong with a line, from its instrument on. What is wrong inside of a frame (unit, check
/// sum, identity) is the conversation's to do.
enum class WireFault {
  none,
  silent,      ///< takes what comes and says nothing
  slow,        ///< replies leave so much later
  half_frame,  ///< the front half of every reply, and no more
  garbage,     ///< other bytes, as many
  reset,       ///< half a reply, then a TCP reset; a serial line falls silent
  refuse       ///< cable out: clients are dropped and new ones refused; a serial line is dead
};

/// Nothing here is called before the loop runs. A client's requests are read no faster than it
/// takes the replies, so that no more than the replies to one piece of 4 KB are held for it. What
/// conversations throw goes through to who runs the loop.
class WireServer {
 public:
  using Factory = std::function<std::unique_ptr<Conversation>()>;

  explicit WireServer(LineLoop& loop);
  ~WireServer();
  WireServer(const WireServer&) = delete;
  WireServer& operator=(const WireServer&) = delete;

  /// Gives the address with the port that was taken; "link" may have port 0. A serial port that is
  /// lost is opened again as soon as it is there. Only what `link` names is open: 127.0.0.1 is this
  /// machine alone. Throws WorkFailed.
  LinkAddress listen(const LinkAddress& link, Factory conversation, const WireLimits& limits = {});
  /// From now on, for what is connected too; `slow_s` is the delay of a slow line. `listener` is as
  /// listen() gave it.
  void set_fault(const LinkAddress& listener, WireFault fault, double slow_s = 0);
  /// Those connected now; a serial port counts as one while it is open.
  std::size_t clients(const LinkAddress& listener) const;
  /// Those closed at once, over the limit, since it listens.
  std::uint64_t turned_away(const LinkAddress& listener) const;

 private:
  struct Listener;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::lab
