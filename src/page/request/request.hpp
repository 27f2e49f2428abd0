// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a browser asks for, once it may: plain values, nothing of the server.
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

struct PageRequest {
  bool post = false;
  Target target;
  std::string body;                       ///< of a JSON request
  std::shared_ptr<Upload> upload;         ///< of a record
  std::optional<std::string> last_event;  ///< Last-Event-ID
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
PageAnswer error_answer(unsigned status, const std::string& what);

}  // namespace triax::src
