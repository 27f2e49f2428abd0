// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <list>
#include <thread>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/page/http/connection.hpp"

namespace triax::src {

namespace asio = boost::asio;
using asio::use_awaitable;
using asio::ip::tcp;

namespace {

std::string in_brackets(const std::string& name) {
  return name.find(':') == std::string::npos ? name : '[' + name + ']';
}

/// The names by which browsers may come.
std::vector<std::string> names_of(const std::vector<std::string>& listen) {
  if (listen.empty()) return {"127.0.0.1", "localhost", "[::1]"};
  std::vector<std::string> names;
  names.reserve(listen.size());
  for (const std::string& name : listen) names.push_back(in_brackets(name));
  return names;
}

/// What a name of --listen stands for on this machine.
struct PlacesOfName {
  std::string name;
  std::vector<asio::ip::address> addresses;
};

bool is_loopback(const asio::ip::address& address) {
  return address.is_loopback() ||
         (address.is_v6() && address.to_v6().is_v4_mapped() &&
          asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).is_loopback());
}

/// Whoever gives this machine's own name means other machines too; here it may stand for this one
/// only (127.0.1.1 of Debian).
void check_reached(const std::vector<PlacesOfName>& all) {
  const auto is_within = [](const PlacesOfName& places) {
    return std::ranges::all_of(places.addresses, is_loopback);
  };
  if (!std::ranges::all_of(all, is_within)) return;
  for (const PlacesOfName& places : all) {
    boost::system::error_code is_name;
    asio::ip::make_address(places.name, is_name);
    if (!is_name || places.name == "localhost") continue;
    throw lab::BadInput(
        fmt::format("--listen {}: on this computer this name is the computer itself ({}), which "
                    "others cannot reach; give the address that others use",
                    places.name, places.addresses.front().to_string()));
  }
}

}  // namespace

struct PageServer::Impl {
  explicit Impl(PageServerOptions options) : house(std::move(options)) {
    open();
    house.gate = std::make_unique<Gate>(names_of(house.options.listen), port, house.options.access);
    for (tcp::acceptor& acceptor : acceptors)
      asio::co_spawn(context, accept(acceptor), asio::detached);
    thread = std::thread([this] { context.run(); });
  }
  ~Impl() {
    context.stop();
    thread.join();
    for (QueueThreads& queue : house.queues) queue.threads.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void open();
  PlacesOfName places_of(const std::string& name);
  void open_at(const PlacesOfName& places);
  void open_at(const tcp::endpoint& endpoint);
  asio::awaitable<void> accept(tcp::acceptor& acceptor);
  void take_in(tcp::socket socket);
  bool make_room();

  PageHouse house;
  asio::io_context context{1};
  std::list<tcp::acceptor> acceptors;
  unsigned short port = 0;
  std::list<std::shared_ptr<PageConnection>> open_connections;  ///< oldest first
  std::atomic<std::size_t> count = 0;
  std::thread thread;
};

void PageServer::Impl::open_at(const tcp::endpoint& endpoint) {
  tcp::acceptor acceptor(context);
  acceptor.open(endpoint.protocol());
  if (endpoint.address().is_v6()) acceptor.set_option(asio::ip::v6_only(true));
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  acceptor.bind(endpoint);
  acceptor.listen(256);
  port = acceptor.local_endpoint().port();
  acceptors.push_back(std::move(acceptor));
}

PlacesOfName PageServer::Impl::places_of(const std::string& name) {
  boost::system::error_code error;
  tcp::resolver resolver(context);
  const auto found = resolver.resolve(name, std::to_string(port), error);
  if (error)
    throw lab::BadInput(
        fmt::format("--listen {}: unknown name; give a name or an address of this computer",
                    lab::excerpt(name)));
  PlacesOfName places{name, {}};
  for (const auto& entry : found) {
    if (entry.endpoint().address().is_unspecified())
      throw lab::BadInput(
          fmt::format("--listen {}: give the name or the address that browsers use for this "
                      "computer; requests with any other name are rejected",
                      name));
    places.addresses.push_back(entry.endpoint().address());
  }
  return places;
}

/// Each place once: two names may stand for one.
void PageServer::Impl::open_at(const PlacesOfName& places) {
  for (const auto& address : places.addresses) {
    const tcp::endpoint endpoint(address, port);
    if (std::ranges::any_of(acceptors, [&](const tcp::acceptor& acceptor) {
          return acceptor.local_endpoint() == endpoint;
        }))
      continue;
    try {
      open_at(endpoint);
    } catch (const boost::system::system_error& failure) {
      throw lab::BadInput(
          fmt::format("cannot listen at {} port {}: {}; give another --port, or an address of this "
                      "computer with --listen",
                      places.name, port, failure.code().message()));
    }
  }
}

void PageServer::Impl::open() {
  port = house.options.port;
  if (house.options.listen.empty()) {
    open_at(places_of("127.0.0.1"));
    try {
      open_at({asio::ip::address_v6::loopback(), port});
    } catch (const boost::system::system_error&) {  // NOLINT(bugprone-empty-catch)
      // A machine without IPv6.
    }
    return;
  }
  std::vector<PlacesOfName> all;
  all.reserve(house.options.listen.size());
  for (const std::string& name : house.options.listen) all.push_back(places_of(name));
  check_reached(all);
  for (const PlacesOfName& places : all) open_at(places);
}

asio::awaitable<void> PageServer::Impl::accept(tcp::acceptor& acceptor) {
  for (;;) {
    boost::system::error_code error;
    tcp::socket socket = co_await acceptor.async_accept(asio::redirect_error(use_awaitable, error));
    if (!error) {
      take_in(std::move(socket));
      continue;
    }
    if (error == asio::error::operation_aborted) co_return;
    asio::steady_timer pause(context, std::chrono::milliseconds(100));  // no file is free, say
    co_await pause.async_wait(use_awaitable);
  }
}

/// Of the connections of which nobody knows whose they are the oldest goes.
bool PageServer::Impl::make_room() {
  if (open_connections.size() < house.options.limits.connections) return true;
  const auto stranger = std::ranges::find_if(
      open_connections, [](const auto& connection) { return !connection->is_trusted(); });
  if (stranger == open_connections.end()) return false;
  (*stranger)->drop();
  open_connections.erase(stranger);
  return true;
}

void PageServer::Impl::take_in(tcp::socket socket) {
  if (!make_room()) return;
  boost::system::error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  auto connection = std::make_shared<PageConnection>(house, std::move(socket));
  open_connections.push_back(connection);
  count = open_connections.size();
  asio::co_spawn(
      context, [connection]() -> asio::awaitable<void> { co_await connection->run(); },
      [this, connection](const std::exception_ptr&) {
        open_connections.remove(connection);
        count = open_connections.size();
      });
}

PageServer::PageServer(PageServerOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
PageServer::~PageServer() = default;

unsigned short PageServer::port() const { return impl_->port; }
std::string PageServer::new_address() {
  return impl_->house.gate->address(impl_->house.gate->new_token());
}
std::size_t PageServer::connections() const { return impl_->count; }

}  // namespace triax::src
