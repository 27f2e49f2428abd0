// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "lab/wire/conversation.hpp"
#include "lab/wire/scpi/table.hpp"

namespace triax::lab {

/// A client's talk with an instrument (IEEE 488.2 chapter 7, SCPI-99 volume 1 chapter 6). A message
/// ends with LF, CR LF, or kSilence_s without a byte. Its units are parted by ";": a header is
/// looked for beside the one before it, or from the root if it begins with ":" or "*". Answers to
/// one message are one line, parted by ";". A command error (-1xx) ends the message, what stands
/// before it is done. A line feed in a block is data, in a text it ends the message.
class ScpiConversation : public Conversation {
 public:
  /// A message that is longer is thrown away up to its end: -363.
  static constexpr std::size_t kLongestMessage = 4096;
  /// Answers that are longer than this before a client has taken them are thrown away: -430.
  static constexpr std::size_t kLongestReply = std::size_t{4} << 20;
  /// Longer than TCP's shortest wait before it sends a lost segment again (0.2 s), so that a
  /// message in two of them is never taken for two.
  static constexpr double kSilence_s = 0.25;

  /// Both outlive it.
  ScpiConversation(const ScpiTable& table, const WireDevice& device)
      : table_(table), device_(device) {}

  void take(std::string_view bytes, std::string& reply) override;
  std::optional<double> waits_s() const override;
  void silent(std::string& reply) override;

  const ScpiStatus& status() const { return status_; }

 private:
  void end_of_message(std::string& reply);
  void message(std::string_view text, std::string& reply);
  void unit(std::string_view text);
  void see_block();

  const ScpiTable& table_;
  const WireDevice& device_;
  ScpiStatus status_;
  std::string received_;
  std::uint64_t in_block_ = 0;  ///< bytes of a block that are still to come
  char quote_ = 0;
  bool overrun_ = false;
  // Of the message under way.
  std::string path_, answers_;
  bool indefinite_ = false;
};

}  // namespace triax::lab
