// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A line that is up, as bytes: a TCP socket or a serial port. For the classes of this folder.
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lab/wire/line/line_loop.hpp"
#include "lab/wire/link_address.hpp"

namespace triax::lab {

class ByteLine {
 public:
  virtual ~ByteLine() = default;
  ByteLine() = default;
  ByteLine(const ByteLine&) = delete;
  ByteLine& operator=(const ByteLine&) = delete;

  /// Bytes as they come, and once why no more will. Either may end the line's life. To be called
  /// once.
  virtual void hear(std::function<void(std::string_view)> bytes,
                    std::function<void(const std::string& why)> ended) = 0;
  /// Sends in order; one call is one write where the system takes it. `sent` is called once all
  /// that was given has left; it may be empty.
  virtual void send(std::string bytes, std::function<void()> sent) = 0;
  /// Bytes that the other side has not taken yet.
  virtual std::size_t unsent() const = 0;
  /// While it is on, nothing is read: the other side's writes will wait.
  virtual void pause(bool on) = 0;
  /// Ends without a call; what is not sent is lost.
  virtual void close() = 0;
  /// Ends with a TCP reset; of a serial port the same as close().
  virtual void reset() = 0;
};

/// Over a connected socket, which it owns from here on. TCP_NODELAY is on.
std::unique_ptr<ByteLine> tcp_line(LineLoop& loop, int socket);
/// Opens a serial port or the end of a pseudo-terminal; what had come before is thrown away. Throws
/// WorkFailed "PATH: why".
std::unique_ptr<ByteLine> serial_line(LineLoop& loop, const LinkAddress& link);

}  // namespace triax::lab
