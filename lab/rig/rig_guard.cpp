// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/rig_guard.hpp"

namespace triax::lab {

bool RigGuard::is_due(std::size_t place, const Stage& stage) const {
  return guard_ && !acted_ && said_ >= guard_->on && place < successor_.size() &&
         guards(*guard_, stage);
}

const Guard& RigGuard::act() {
  acted_ = true;
  did_ = describe(*guard_);
  return *guard_;
}

}  // namespace triax::lab
