// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Modbus that went wrong inside of its frames, for trying a controller.
#include <memory>
#include <string>
#include <utility>

#include "lab/wire/conversation.hpp"

namespace triax::lab {

enum class FrameFault { none, wrong_unit, wrong_check };

/// Hands everything on and spoils each reply as `fault`, which outlives it, says by then. A TCP
/// frame has no check sum of its own: there the transaction's number is wrong instead.
class SpoiltConversation : public Conversation {
 public:
  SpoiltConversation(std::unique_ptr<Conversation> inner, bool tcp, const FrameFault& fault)
      : inner_(std::move(inner)), tcp_(tcp), fault_(fault) {}

  void take(std::string_view bytes, std::string& reply) override {
    const std::size_t before = reply.size();
    inner_->take(bytes, reply);
    spoil(reply, before);
  }
  std::optional<double> waits_s() const override { return inner_->waits_s(); }
  void silent(std::string& reply) override {
    const std::size_t before = reply.size();
    inner_->silent(reply);
    spoil(reply, before);
  }
  bool over() const override { return inner_->over(); }

 private:
  void spoil(std::string& reply, std::size_t from) const {
    constexpr std::size_t kUnitOfTcp = 6;
    if (fault_ == FrameFault::none || reply.size() < from + kUnitOfTcp + 1) return;
    const std::size_t unit = from + (tcp_ ? kUnitOfTcp : 0), check = tcp_ ? from : reply.size() - 1;
    char& byte = reply[fault_ == FrameFault::wrong_unit ? unit : check];
    byte = static_cast<char>(byte ^ 0x55);
  }

  std::unique_ptr<Conversation> inner_;
  bool tcp_;
  const FrameFault& fault_;
};

}  // namespace triax::lab
