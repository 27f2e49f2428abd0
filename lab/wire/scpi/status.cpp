// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/status.hpp"

#include <fmt/format.h>

#include <utility>

namespace triax::lab {

unsigned ScpiStatus::Group::take_event() { return std::exchange(event, 0u); }

void ScpiStatus::put(const ScpiError& error) {
  const int hundreds = error.code() / 100;
  set_event(hundreds == -1   ? kCommandError
            : hundreds == -2 ? kExecutionError
            : hundreds == -4 ? kQueryError
                             : kDeviceError);
  if (errors_.size() < kMostErrors)
    errors_.push_back({error.code(), error.what()});
  else
    errors_.back() = {-350, std::string(scpi_error_text(-350))};
}

std::string ScpiStatus::take_error() {
  if (errors_.empty()) return "0,\"No error\"";
  constexpr std::size_t kLongest = 255;
  const Error error = std::move(errors_.front());
  errors_.pop_front();
  std::string quoted;
  for (const char c : error.text.substr(0, kLongest))
    quoted += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  return fmt::format("{},\"{}\"", error.code, quoted);
}

void ScpiStatus::clear() {
  errors_.clear();
  for (Group* group : {&standard, &questionable, &operation}) group->event = 0;
}

unsigned ScpiStatus::status_byte(bool message) const {
  const auto summary = [](const Group& group, unsigned bit) {
    return (group.event & group.enable) != 0 ? bit : 0u;
  };
  const unsigned byte = (errors_.empty() ? 0u : kErrors) | (message ? kMessage : 0u) |
                        summary(questionable, kQuestionable) | summary(standard, kEvents) |
                        summary(operation, kOperation);
  return byte | ((byte & request_enable) != 0 ? kMaster : 0u);
}

}  // namespace triax::lab
