// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How TCP lines come up, from both sides. For the classes of this folder.
#include <functional>
#include <memory>
#include <string>

#include "lab/wire/line/byte_line.hpp"

namespace triax::lab {

/// Listens at `link` and gives every client's line. While open() is false connections are refused
/// by the system; what it can not take for want of descriptors waits and is tried again.
class TcpListener {
 public:
  /// Throws WorkFailed where the address is none of this machine or taken.
  TcpListener(LineLoop& loop, const LinkAddress& link,
              std::function<void(std::unique_ptr<ByteLine>)> come);
  ~TcpListener();
  TcpListener(const TcpListener&) = delete;
  TcpListener& operator=(const TcpListener&) = delete;

  int port() const;
  /// Off: the port stays taken, connections to it are refused. On: heard again, at once or as soon
  /// as the system lets it.
  void listen(bool on);

 private:
  struct State;
  std::shared_ptr<State> state_;
};

/// Connects to `link`; `done` gets the line, or null and why. Destroyed before that: never called.
class TcpConnector {
 public:
  TcpConnector(LineLoop& loop, const LinkAddress& link,
               std::function<void(std::unique_ptr<ByteLine>, const std::string& why)> done);
  ~TcpConnector();
  TcpConnector(const TcpConnector&) = delete;
  TcpConnector& operator=(const TcpConnector&) = delete;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace triax::lab
