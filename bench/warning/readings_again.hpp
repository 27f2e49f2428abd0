// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <utility>
#include <vector>

#include "lab/rig/back_end.hpp"

namespace triax::bench {

/// The readings of a test that has been, once more.
class ReadingsAgain : public lab::BackEnd {
 public:
  ReadingsAgain(lab::RecordHeader header, const std::vector<lab::Reading>& readings)
      : header_(std::move(header)), readings_(readings) {}
  const lab::RecordHeader& header() const override { return header_; }
  bool next(lab::Reading& reading) override {
    if (drawn_ == readings_.size()) return false;
    reading = readings_[drawn_++];
    return true;
  }
  double progress() const override { return 0; }

 private:
  const lab::RecordHeader header_;
  const std::vector<lab::Reading>& readings_;
  std::size_t drawn_ = 0;
};

}  // namespace triax::bench
