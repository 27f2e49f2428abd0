// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/tcp.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {
using boost::asio::ip::tcp;
using TcpError = boost::system::error_code;
constexpr double kTryAgain_s = 0.1;
}  // namespace

struct TcpListener::State : std::enable_shared_from_this<State> {
  explicit State(LineLoop& l) : loop(l), acceptor(l.context()), held(l.context()) {}

  /// Throws boost::system::system_error.
  void open() {
    acceptor.open(endpoint.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(endpoint);
    acceptor.listen(1024);
    endpoint = acceptor.local_endpoint();
    accept();
  }

  void accept() {
    acceptor.async_accept([self = shared_from_this()](TcpError error, tcp::socket socket) {
      if (self->ended || error == boost::asio::error::operation_aborted) return;
      if (error && error != boost::asio::error::connection_aborted) {
        self->again =
            self->loop.at(self->loop.now_s() + kTryAgain_s, [s = self.get()] { s->accept(); });
        return;
      }
      if (!error) {
        auto line = tcp_line(self->loop, socket.release());
        self->come(std::move(line));
      }
      if (!self->ended && self->acceptor.is_open()) self->accept();
    });
  }

  void reopen() {
    TcpError ignored;
    held.close(ignored);
    try {
      open();
    } catch (const boost::system::system_error&) {
      close();
      again = loop.at(loop.now_s() + kTryAgain_s, [this] { reopen(); });
    }
  }

  void close() {
    again.cancel();
    TcpError ignored;
    acceptor.close(ignored);
    held.close(ignored);
  }

  /// Nobody else gets the port: who calls it would meet a stranger in place of nobody.
  void refuse() {
    close();
    TcpError ignored;  // taken in between: it is tried for again when it is to be heard
    held.open(endpoint.protocol(), ignored);
    held.set_option(tcp::acceptor::reuse_address(true), ignored);
    held.bind(endpoint, ignored);
  }

  LineLoop& loop;
  tcp::endpoint endpoint;
  tcp::acceptor acceptor;
  tcp::socket held;  ///< bound to the port while the acceptor is closed
  LineTimer again;
  bool ended = false;
  std::function<void(std::unique_ptr<ByteLine>)> come;
};

TcpListener::TcpListener(LineLoop& loop, const LinkAddress& link,
                         std::function<void(std::unique_ptr<ByteLine>)> come)
    : state_(std::make_shared<State>(loop)) {
  state_->come = std::move(come);
  try {
    tcp::resolver resolver(loop.context());
    state_->endpoint = *resolver.resolve(link.host, std::to_string(link.port)).begin();
    state_->open();
  } catch (const boost::system::system_error& error) {
    throw WorkFailed("cannot listen at " + to_text(link) + ": " + error.code().message() +
                     "; expected a free address of this computer");
  }
}

TcpListener::~TcpListener() {
  state_->ended = true;
  state_->close();
}

int TcpListener::port() const { return state_->endpoint.port(); }

void TcpListener::listen(bool on) {
  if (on == state_->acceptor.is_open()) return;
  on ? state_->reopen() : state_->refuse();
}

struct TcpConnector::State : std::enable_shared_from_this<State> {
  explicit State(LineLoop& l) : loop(l), resolver(l.context()), socket(l.context()) {}

  void resolved(TcpError error, const tcp::resolver::results_type& found) {
    if (ended) return;
    if (error) return done(nullptr, "no such host");
    boost::asio::async_connect(socket, found,
                               [self = shared_from_this()](TcpError failed, const tcp::endpoint&) {
                                 if (self->ended) return;
                                 if (failed) return self->done(nullptr, failed.message());
                                 self->done(tcp_line(self->loop, self->socket.release()), "");
                               });
  }

  LineLoop& loop;
  tcp::resolver resolver;
  tcp::socket socket;
  bool ended = false;
  std::function<void(std::unique_ptr<ByteLine>, const std::string&)> done;
};

TcpConnector::TcpConnector(
    LineLoop& loop, const LinkAddress& link,
    std::function<void(std::unique_ptr<ByteLine>, const std::string& why)> done)
    : state_(std::make_shared<State>(loop)) {
  state_->done = std::move(done);
  const auto found = [state = state_](TcpError error,
                                      const tcp::resolver::results_type& endpoints) {
    state->resolved(error, endpoints);
  };
  // A number needs no name server, nor the thread that would ask it.
  TcpError no_number;
  const auto address = boost::asio::ip::make_address(link.host, no_number);
  if (no_number)
    state_->resolver.async_resolve(link.host, std::to_string(link.port), found);
  else
    found({}, tcp::resolver::results_type::create(
                  tcp::endpoint(address, static_cast<unsigned short>(link.port)), link.host, ""));
}

TcpConnector::~TcpConnector() {
  state_->ended = true;
  state_->resolver.cancel();
  TcpError ignored;
  state_->socket.close(ignored);
}

}  // namespace triax::lab
