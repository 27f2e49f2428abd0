// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <string>
#include <utility>

#include "lab/wire/conversation.hpp"
#include "lab/wire/served/served_devices.hpp"

namespace triax::lab {

/// Hands everything on, and tells the drives before which of their clients it is that speaks.
class NumberedConversation : public Conversation {
 public:
  NumberedConversation(std::unique_ptr<Conversation> inner, ServedDrives& drives)
      : inner_(std::move(inner)), drives_(drives), number_(drives.new_client()) {}

  void take(std::string_view bytes, std::string& reply) override {
    drives_.speaks(number_);
    inner_->take(bytes, reply);
  }
  std::optional<double> waits_s() const override { return inner_->waits_s(); }
  void silent(std::string& reply) override {
    drives_.speaks(number_);
    inner_->silent(reply);
  }
  bool over() const override { return inner_->over(); }

 private:
  std::unique_ptr<Conversation> inner_;
  ServedDrives& drives_;
  int number_;
};

}  // namespace triax::lab
