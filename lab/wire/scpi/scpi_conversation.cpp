// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/scpi_conversation.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

bool header_character(unsigned char c) {
  return std::isalnum(c) || c == '_' || c == ':' || c == '*' || c == '?';
}

/// Length of the unit at the front of a message: up to a ";" that is in no text and no block.
std::size_t unit_length(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == ';') return i;
    if (c == '"' || c == '\'') {
      i = std::min(text.find(c, i + 1), text.size());
    } else if (c == '#') {
      const std::size_t block = block_length(text.substr(i));
      i += std::min(block, text.size() - i) - (block > 0 ? 1 : 0);
    }
  }
  return text.size();
}

}  // namespace

void ScpiConversation::take(std::string_view bytes, std::string& reply) {
  for (const char c : bytes) {
    if (in_block_ == 0 && c == '\n') {
      end_of_message(reply);
      continue;
    }
    if (!overrun_) received_ += c;
    if (received_.size() > kLongestMessage) {
      overrun_ = true;
      received_.clear();
    }
    if (in_block_ > 0)
      --in_block_;
    else if (quote_ != 0)
      quote_ = c == quote_ ? '\0' : quote_;
    else if (c == '"' || c == '\'')
      quote_ = c;
    else
      see_block();
  }
}

/// Whether what came ends with the head of a block: its bytes are counted, not read.
void ScpiConversation::see_block() {
  if (received_.empty() || !std::isdigit(static_cast<unsigned char>(received_.back()))) return;
  constexpr std::size_t kLongestHead = 11;  // "#9" and nine digits
  std::string_view front = received_;
  front.remove_prefix(front.size() - std::min(front.size(), kLongestHead));
  const std::size_t head = front.rfind('#');
  if (head == std::string_view::npos) return;
  front.remove_prefix(head);
  const std::size_t length = block_length(front);
  // Its last digit has just come.
  if (length > 0 && front.size() == 2 + static_cast<std::size_t>(front[1] - '0'))
    in_block_ = length - front.size();
}

std::optional<double> ScpiConversation::waits_s() const {
  return received_.empty() && !overrun_ && in_block_ == 0 ? std::nullopt
                                                          : std::optional(kSilence_s);
}

void ScpiConversation::silent(std::string& reply) { end_of_message(reply); }

void ScpiConversation::end_of_message(std::string& reply) {
  const std::string text = std::exchange(received_, {});
  in_block_ = 0;
  quote_ = 0;
  if (std::exchange(overrun_, false)) return status_.put(ScpiError(-363));
  if (device_.heard) device_.heard();
  message(text, reply);
}

void ScpiConversation::message(std::string_view text, std::string& reply) {
  path_.clear();
  answers_.clear();
  indefinite_ = false;
  if (table_.questionable) status_.questionable.is(table_.questionable());
  for (std::size_t length = 0; !text.empty();
       text.remove_prefix(std::min(length + 1, text.size()))) {
    length = unit_length(text);
    try {
      try {
        unit(trimmed(text.substr(0, length)));
      } catch (const Refused& refused) {
        throw ScpiError(refused.why() == Refused::Why::out_of_range ? -222 : -221, refused.what());
      }
      if (reply.size() + answers_.size() > kLongestReply) throw ScpiError(-430);
    } catch (const ScpiError& error) {
      status_.put(error);
      if (error.code() <= -400) answers_.clear();
      if (error.code() > -200 || error.code() <= -400) break;
    }
  }
  if (!answers_.empty()) reply += answers_ + "\n";
}

void ScpiConversation::unit(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == '\0')) text.remove_suffix(1);
  if (text.empty()) return;
  const std::size_t blank = text.find_first_of(" \t\r");
  std::string header(text.substr(0, blank));
  for (const char c : header)
    if (!header_character(static_cast<unsigned char>(c)))
      throw ScpiError(c == ',' ? -103 : -101, excerpt(header));
  if (header.starts_with(':'))
    header.erase(0, 1);
  else if (!header.starts_with('*'))
    header = path_ + header;

  ScpiCall call{.status = status_, .message = !answers_.empty()};
  const ScpiRow& row = table_.find(header, call.suffixes);
  if (!header.starts_with('*')) path_ = header.substr(0, header.rfind(':') + 1);
  if (row.pattern.is_query() && indefinite_) throw ScpiError(-440);
  call.parameters = ScpiParameters(blank == std::string_view::npos ? "" : text.substr(blank));
  if (call.parameters.count() > row.most_parameters) throw ScpiError(-108, row.pattern.shortest());
  row.handler(call);
  if (!row.pattern.is_query()) return;
  answers_ += (answers_.empty() ? "" : ";") + call.reply;
  indefinite_ = indefinite_ || row.indefinite;
}

}  // namespace triax::lab
