// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// HTTP/1.1 for the browsers of this machine, or of the names given: all waiting on sockets is done
// by one thread, what takes time by a few others.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "src/page/http/gate.hpp"
#include "src/page/http/limits.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {

struct PageServerOptions {
  /// Names or addresses to listen at, by which browsers come; empty: this machine only.
  std::vector<std::string> listen;
  unsigned short port = 0;  ///< 0: any that is free
  PageLimits limits{};
  AccessTimes access{};
  std::string upload_folder = ".";
  /// The queue of a request. Empty: WorkQueue::light for all.
  std::function<WorkQueue(const PageRequest&)> queue_of{};
  /// Called by several threads at a time. Refused and lab::BadInput go to the browser.
  std::function<PageAnswer(const PageRequest&)> answer;
};

class PageServer {
 public:
  /// Listens from now on. Throws lab::BadInput where it cannot.
  explicit PageServer(PageServerOptions options);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  unsigned short port() const;
  /// Lets one browser in.
  std::string new_address();
  /// Connections that are open.
  std::size_t connections() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::src
