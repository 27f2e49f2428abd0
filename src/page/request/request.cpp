// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/request/request.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {

PageAnswer json_answer(std::string json) { return {.body = std::move(json)}; }

PageAnswer error_answer(unsigned status, const std::string& what) {
  return {.status = status, .body = study::json_line({{"error", what}})};
}

}  // namespace triax::src
