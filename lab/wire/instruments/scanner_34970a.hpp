// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <deque>

#include "lab/wire/scpi/table.hpp"

namespace triax::lab {

/// A scanner's 34970A tree over the points of a device: channels 101 to 120, 201 to 220, 301 to 320
/// are the points in their order. One scan list, one memory for all clients, as in the instrument.
/// A scan takes all its channels at one instant; a scan of the timer whose instant was missed is
/// not made up for: nothing is read that was not there.
class Scanner34970A {
 public:
  static constexpr std::size_t kMostReadings = 50'000;
  /// Bit of the questionable register: the memory is full and its oldest readings are lost.
  static constexpr unsigned kMemoryOverflow = 4096;
  static constexpr const char* kIdentity = "HEWLETT-PACKARD,34970A,0,13-2-2";

  /// The device outlives it; it has 60 points at most, all of which can be read. `epoch_s` is Unix
  /// time where now_s is 0, for absolute time stamps.
  Scanner34970A(const WireDevice& device, double epoch_s);
  Scanner34970A(const Scanner34970A&) = delete;
  Scanner34970A& operator=(const Scanner34970A&) = delete;

  const ScpiTable& table() const { return table_; }
  /// Moves its clock on: at most one scan is taken, with the values of now.
  void process(double now_s);
  /// Sets its calendar on, or back; the timer goes on as it was.
  void shift_calendar(double by_s) { epoch_s_ += by_s; }
  /// When the timer's next scan is due; infinity where none is.
  double next_scan_s() const;
  std::size_t readings() const { return memory_.size(); }

 private:
  struct Reading {
    double time_s, value;
    int channel;
  };
  enum class Source { immediate, timer, bus };

  void add_settings();
  void add_formats();
  void add_readings();
  void set_scan_list(ScpiCall& call);
  void start();
  void stop() { scans_left_ = 0; }
  void scan();
  void take(std::size_t count, ScpiCall& call, bool keep, bool block);
  std::string text_of(const Reading& reading) const;
  const Point& point(int channel) const;

  const WireDevice& device_;
  double epoch_s_;
  ScpiTable table_;
  double now_s_ = 0, started_s_ = 0;
  std::vector<int> list_;
  Source source_ = Source::immediate;
  double timer_s_ = 10;
  std::int64_t count_ = 1, scans_left_ = 0, scans_made_ = 0;
  std::deque<Reading> memory_;
  bool overflow_ = false;
  bool with_alarm_ = false, with_time_ = false, with_channel_ = false, with_unit_ = false,
       absolute_ = false;
};

}  // namespace triax::lab
