// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/byte_line.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <termios.h>

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/serial_port.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// Handlers hold the state: it outlives the line until the last of them was called.
template <class Stream>
struct StreamState : std::enable_shared_from_this<StreamState<Stream>> {
  explicit StreamState(Stream&& open) : stream(std::move(open)) {}

  void read() {
    if (closed || paused || reading || !bytes) return;
    reading = true;
    stream.async_read_some(asio::buffer(buffer),
                           [self = this->shared_from_this()](error_code error, std::size_t count) {
                             self->reading = false;
                             if (self->closed) return;
                             if (error) return self->end(error);
                             self->bytes(std::string_view(self->buffer.data(), count));
                             self->read();
                           });
  }

  void write() {
    if (closed || writing || outgoing.empty()) return;
    writing = true;
    asio::async_write(stream, asio::buffer(outgoing.front().bytes),
                      [self = this->shared_from_this()](error_code error, std::size_t) {
                        self->writing = false;
                        if (self->closed) return;
                        if (error) return self->end(error);
                        const auto sent = std::move(self->outgoing.front().sent);
                        self->unsent -= self->outgoing.front().bytes.size();
                        self->outgoing.pop_front();
                        if (sent) sent();
                        self->write();
                      });
  }

  void end(error_code error) {
    close();
    if (ended) ended(error == asio::error::eof ? "closed by the other side" : error.message());
  }

  void close() {
    if (std::exchange(closed, true)) return;
    error_code ignored;
    stream.close(ignored);
  }

  struct Piece {
    std::string bytes;
    std::function<void()> sent;
  };
  Stream stream;
  std::array<char, 4096> buffer{};
  std::deque<Piece> outgoing;
  std::size_t unsent = 0;
  bool reading = false, writing = false, paused = false, closed = false;
  std::function<void(std::string_view)> bytes;
  std::function<void(const std::string&)> ended;
};

template <class Stream>
class StreamLine : public ByteLine {
 public:
  explicit StreamLine(Stream&& stream)
      : state_(std::make_shared<StreamState<Stream>>(std::move(stream))) {}
  ~StreamLine() override { state_->close(); }

  void hear(std::function<void(std::string_view)> bytes,
            std::function<void(const std::string&)> ended) override {
    state_->bytes = std::move(bytes);
    state_->ended = std::move(ended);
    state_->read();
  }
  void send(std::string bytes, std::function<void()> sent) override {
    state_->unsent += bytes.size();
    state_->outgoing.push_back({std::move(bytes), std::move(sent)});
    state_->write();
  }
  std::size_t unsent() const override { return state_->unsent; }
  void pause(bool on) override {
    state_->paused = on;
    state_->read();
  }
  void close() override { state_->close(); }
  void reset() override {
    if constexpr (std::is_same_v<Stream, asio::ip::tcp::socket>) {
      error_code ignored;
      if (!state_->closed) state_->stream.set_option(asio::socket_base::linger(true, 0), ignored);
    }
    state_->close();
  }

 private:
  std::shared_ptr<StreamState<Stream>> state_;
};

void set_serial(asio::serial_port& port, const LinkAddress& link) {
  using Port = asio::serial_port;
  using Parity = LinkAddress::Parity;
  port.set_option(Port::baud_rate(static_cast<unsigned>(link.baud)));
  port.set_option(Port::flow_control(Port::flow_control::none));
  port.set_option(Port::stop_bits(link.stop == 2 ? Port::stop_bits::two : Port::stop_bits::one));
  try {
    port.set_option(Port::character_size(static_cast<unsigned>(link.bits)));
    port.set_option(Port::parity(link.parity == Parity::none   ? Port::parity::none
                                 : link.parity == Parity::even ? Port::parity::even
                                                               : Port::parity::odd));
  } catch (const boost::system::system_error&) {
    // A pseudo-terminal has bytes of 8 bits and no parity, and says so.
    std::array<char, 64> name{};
    if (::ttyname_r(port.native_handle(), name.data(), name.size()) != 0 ||
        !std::string_view(name.data()).starts_with("/dev/pts/"))
      throw;
  }
}

}  // namespace

std::unique_ptr<ByteLine> tcp_line(LineLoop& loop, int socket) {
  sockaddr_storage address{};
  socklen_t length = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length);
  using asio::ip::tcp;
  tcp::socket stream(loop.context(), address.ss_family == AF_INET6 ? tcp::v6() : tcp::v4(), socket);
  error_code ignored;
  stream.set_option(tcp::no_delay(true), ignored);
  return std::make_unique<StreamLine<tcp::socket>>(std::move(stream));
}

std::unique_ptr<ByteLine> serial_line(LineLoop& loop, const LinkAddress& link) {
  try {
    asio::serial_port port(loop.context(), link.path);
    set_serial(port, link);
    ::tcflush(port.native_handle(), TCIFLUSH);
    return std::make_unique<StreamLine<asio::serial_port>>(std::move(port));
  } catch (const boost::system::system_error& error) {
    throw WorkFailed(link.path + ": " + error.code().message());
  }
}

}  // namespace triax::lab
