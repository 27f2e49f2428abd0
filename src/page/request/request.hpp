// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a browser asks for, once it may: plain values, nothing of the server.
#include <atomic>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/page/request/target.hpp"
#include "src/page/request/upload.hpp"

namespace triax::src {

/// Why nobody waits for an answer any more.
enum class Cancelled { no, client_gone, too_late };

struct PageRequest {
  bool post = false;
  Target target;
  std::string body;                       ///< of a JSON request
  std::shared_ptr<Upload> upload;         ///< of a record
  std::optional<std::string> last_event;  ///< Last-Event-ID
  /// The connection sets it while the answer is computed. Empty: never cancelled.
  std::shared_ptr<const std::atomic<Cancelled>> cancelled{};

  /// Work that takes long asks now and then, and then ends by an exception.
  bool is_cancelled() const { return cancelled && *cancelled != Cancelled::no; }
};

/// Work of one queue does not wait for that of another: each has threads of its own.
enum class WorkQueue {
  orders,   ///< to tests that run: answered at once, whatever else is computed
  light,    ///< little to compute
  drawing,  ///< readings of tests
  heavy,    ///< seconds of computing
  records,  ///< uploads
};

/// Where a stream of what happens in a test begins: behind the item that a browser had last.
class LiveFeed;
struct LiveStart {
  std::shared_ptr<LiveFeed> feed;
  std::optional<std::string> after;
};

struct PageAnswer {
  unsigned status = 200;
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> fields{};
  std::optional<LiveStart> live{};
  std::shared_ptr<void> held{};  ///< kept until the answer is sent, as a share of a memory budget
};

/// Told to the browser as {"error": what} with this status.
class Refused : public std::runtime_error {
 public:
  Refused(unsigned status, const std::string& what) : std::runtime_error(what), status_(status) {}
  unsigned status() const { return status_; }

 private:
  unsigned status_;
};

PageAnswer json_answer(std::string json);
/// {"error": what}; status 503 also says when to ask again.
PageAnswer error_answer(unsigned status, const std::string& what);
/// Throws Refused if the request is cancelled.
void throw_if_cancelled(const PageRequest& request);

}  // namespace triax::src
