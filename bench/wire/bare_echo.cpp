// SPDX-License-Identifier: GPL-3.0-or-later
// The yardstick of bench/wire/run.sh: Boost.Asio's echo of bytes, a blocking-free loop of one
// thread and nothing else, to which a line's answer is the line itself. Prints its port.
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <cstdio>
#include <memory>

using boost::asio::ip::tcp;

namespace {
struct Session : std::enable_shared_from_this<Session> {
  explicit Session(tcp::socket s) : socket(std::move(s)) {}
  void go() {
    socket.async_read_some(
        boost::asio::buffer(bytes), [self = shared_from_this()](auto failed, std::size_t count) {
          if (failed) return;
          boost::asio::async_write(self->socket, boost::asio::buffer(self->bytes.data(), count),
                                   [self](auto error, std::size_t) {
                                     if (!error) self->go();
                                   });
        });
  }
  tcp::socket socket;
  std::array<char, 4096> bytes;
};

void accept(tcp::acceptor& acceptor) {
  acceptor.async_accept([&acceptor](auto failed, tcp::socket socket) {
    if (failed) return;
    socket.set_option(tcp::no_delay(true));
    std::make_shared<Session>(std::move(socket))->go();
    accept(acceptor);
  });
}
}  // namespace

int main() {
  boost::asio::io_context context(1);
  tcp::acceptor acceptor(context, {boost::asio::ip::address_v4::loopback(), 0});
  std::printf("%d\n", acceptor.local_endpoint().port());
  std::fflush(stdout);
  accept(acceptor);
  context.run();
}
