// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/recording/patience.hpp"

#include <thread>

namespace triax::db {

bool Waiting::failed(const MayPass& why) {
  if (!under_way()) {
    since_ = Clock::now();
    say(std::string(why.what()) + "; buffering readings until the database can be written");
  }
  return Clock::now() - from_ > patience_.most || (patience_.stop && patience_.stop());
}

void Waiting::pause() const { std::this_thread::sleep_for(patience_.again); }

void Waiting::succeeded(const std::string& path) {
  if (!under_way()) return;
  since_ = {};
  say(path + ": the buffered readings are stored; nothing is lost");
}

void Waiting::say(const std::string& sentence) const {
  if (patience_.say) patience_.say(sentence);
}

}  // namespace triax::db
