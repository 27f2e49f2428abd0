// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/request/request.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {

PageAnswer json_answer(std::string json) { return {.body = std::move(json)}; }

PageAnswer error_answer(unsigned status, const std::string& what) {
  PageAnswer answer{.status = status, .body = study::json_line({{"error", what}})};
  if (status == 503) answer.fields = {{"Retry-After", "5"}};
  return answer;
}

void throw_if_cancelled(const PageRequest& request) {
  if (request.is_cancelled())
    throw Refused(503, "the request was cancelled: the browser disconnected");
}

}  // namespace triax::src
