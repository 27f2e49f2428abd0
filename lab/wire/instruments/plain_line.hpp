// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "lab/wire/conversation.hpp"

namespace triax::lab {

/// Instruments that are older than SCPI: a short line, and an answer. LF, CR and CR LF end a line,
/// and so do 0.25 s without a byte; a line above 80 bytes is thrown away.
class PlainLineConversation : public Conversation {
 public:
  void take(std::string_view bytes, std::string& reply) final;
  std::optional<double> waits_s() const override;
  void silent(std::string& reply) override { end_of_line(reply); }

 protected:
  /// `line` is trimmed and not empty.
  virtual void answer(std::string_view line, std::string& reply) = 0;

 private:
  void end_of_line(std::string& reply);
  std::string line_;
  bool too_long_ = false;
};

}  // namespace triax::lab
