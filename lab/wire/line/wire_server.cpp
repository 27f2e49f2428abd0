// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/line/wire_server.hpp"

#include <algorithm>
#include <list>

#include "lab/base/bad_input.hpp"
#include "lab/wire/line/served_line.hpp"
#include "lab/wire/line/tcp.hpp"

namespace triax::lab {
namespace {
constexpr double kTakenUpAgain_s = 0.5;
}

struct WireServer::Listener {
  LineLoop& loop;
  LinkAddress link;
  Factory conversation;
  WireLimits limits;
  LineFault fault{};
  std::uint64_t turned_away = 0;
  std::unique_ptr<TcpListener> tcp{};
  std::list<std::unique_ptr<ServedLine>> clients{};
  LineTimer idle{}, reopen{};

  void come(std::unique_ptr<ByteLine> line) {
    if (std::ssize(clients) >= limits.clients) {
      ++turned_away;
      return line->reset();
    }
    const auto place = clients.emplace(clients.end());
    // A client whose end is told twice, by its line and by its conversation, is gone only once.
    *place = std::make_unique<ServedLine>(loop, std::move(line), conversation(), fault,
                                          [this, served = &*place] { gone(served); });
  }

  void gone(const std::unique_ptr<ServedLine>* served) {
    const auto place = std::ranges::find_if(clients, [&](const auto& c) { return &c == served; });
    if (place == clients.end()) return;
    clients.erase(place);
    if (link.is_serial()) take_up_serial();
  }

  void take_up_serial() {
    reopen = loop.at(loop.now_s() + kTakenUpAgain_s, [this] {
      try {
        come(serial_line(loop, link));
      } catch (const WorkFailed&) {
        take_up_serial();
      }
    });
  }

  void look_for_idle() {
    std::erase_if(clients, [&](const std::unique_ptr<ServedLine>& client) {
      return client->last_s() + limits.idle_s < loop.now_s();
    });
    idle = loop.at(loop.now_s() + limits.idle_s / 4, [this] { look_for_idle(); });
  }
};

struct WireServer::Impl {
  LineLoop& loop;
  std::list<Listener> listeners;

  Listener& at(const LinkAddress& link) {
    const auto found = std::ranges::find(listeners, link, &Listener::link);
    if (found == listeners.end()) throw WorkFailed("nothing listens at " + to_text(link));
    return *found;
  }
};

WireServer::WireServer(LineLoop& loop) : impl_(new Impl{loop, {}}) {}
WireServer::~WireServer() = default;

LinkAddress WireServer::listen(const LinkAddress& link, Factory conversation,
                               const WireLimits& limits) {
  auto& all = impl_->listeners;
  Listener& listener = all.emplace_back(Listener{.loop = impl_->loop,
                                                 .link = link,
                                                 .conversation = std::move(conversation),
                                                 .limits = limits});
  try {
    if (link.is_serial()) {
      listener.come(serial_line(impl_->loop, link));
    } else {
      listener.tcp = std::make_unique<TcpListener>(
          impl_->loop, link, [&listener](auto line) { listener.come(std::move(line)); });
      listener.link.port = listener.tcp->port();
      listener.look_for_idle();
    }
  } catch (const WorkFailed&) {
    all.pop_back();
    throw;
  }
  return listener.link;
}

void WireServer::set_fault(const LinkAddress& listener, WireFault fault, double slow_s) {
  Listener& at = impl_->at(listener);
  at.fault = {fault, slow_s};
  if (!at.tcp) return;
  if (fault == WireFault::refuse) {
    for (const auto& client : at.clients) client->reset();
    at.clients.clear();
  }
  at.tcp->listen(fault != WireFault::refuse);
}

std::size_t WireServer::clients(const LinkAddress& listener) const {
  return impl_->at(listener).clients.size();
}

std::uint64_t WireServer::turned_away(const LinkAddress& listener) const {
  return impl_->at(listener).turned_away;
}

}  // namespace triax::lab
