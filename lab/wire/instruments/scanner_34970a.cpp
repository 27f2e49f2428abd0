// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/instruments/scanner_34970a.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "lab/wire/instruments/multimeter_34401a.hpp"

namespace triax::lab {
namespace {

constexpr std::int64_t kScansWithoutEnd = std::numeric_limits<std::int64_t>::max();
constexpr int kChannelsOfSlot = 20;
constexpr std::array<std::pair<const char*, int>, 5> kTriggerSources{
    {{"IMM", 0}, {"IMMEDIATE", 0}, {"TIM", 1}, {"TIMER", 1}, {"BUS", 2}}};

/// "(@101,102)"
std::string channel_list(const std::vector<int>& channels) {
  return fmt::format("(@{})", fmt::join(channels, ","));
}

/// yyyy,mm,dd,hh,mm,ss.sss, UTC
std::string calendar_fields(double unix_s) {
  const double whole_s = std::floor(unix_s);
  const auto time = std::chrono::system_clock::time_point(
      std::chrono::seconds(static_cast<std::int64_t>(whole_s)));
  return fmt::format("{:%Y,%m,%d,%H,%M,}{:06.3f}", time,
                     std::fmod(whole_s, 60) + std::floor((unix_s - whole_s) * 1000) / 1000);
}

}  // namespace

Scanner34970A::Scanner34970A(const WireDevice& device, double epoch_s)
    : device_(device), epoch_s_(epoch_s) {
  add_common_commands(table_, device);
  table_.questionable = [this] { return overflow_ ? kMemoryOverflow : 0; };
  add_settings();
  add_formats();
  add_readings();
}

void Scanner34970A::add_settings() {
  table_.add("ROUTe:SCAN", 1, "channels of a scan; ends one that runs",
             [this](ScpiCall& call) { set_scan_list(call); });
  table_.add("ROUTe:SCAN?", 0, "channels of a scan, as a block",
             [this](ScpiCall& call) { call.reply = as_block(channel_list(list_)); });
  table_.add("ROUTe:SCAN:SIZE?", 0, "number of channels of a scan",
             [this](ScpiCall& call) { call.reply = fmt::format("{:+}", std::ssize(list_)); });
  table_.add("TRIGger:SOURce", 1, "what starts a scan: IMM, TIM or BUS (*TRG)",
             [this](ScpiCall& call) {
               const std::string word = call.parameters.word();
               for (const auto& [name, source] : kTriggerSources)
                 if (word == name) return void(source_ = static_cast<Source>(source));
               throw ScpiError(-224, "must be one of: IMM, TIM, BUS");
             });
  table_.add("TRIGger:SOURce?", 0, "what starts a scan", [this](ScpiCall& call) {
    call.reply = kTriggerSources[source_ == Source::immediate ? 0
                                 : source_ == Source::timer   ? 2
                                                              : 4]
                     .first;
  });
  table_.add("TRIGger:TIMer", 1, "from scan to scan, s", [this](ScpiCall& call) {
    const double timer_s = call.parameters.number("s");
    if (!(timer_s >= 0 && timer_s <= 359'999)) throw ScpiError(-222, "0 to 359999 s");
    timer_s_ = timer_s;
  });
  table_.add("TRIGger:TIMer?", 0, "from scan to scan, s",
             [this](ScpiCall& call) { call.reply = meter_number(timer_s_); });
  table_.add("TRIGger:COUNt", 1, "number of scans, or INF", [this](ScpiCall& call) {
    try {
      ScpiParameters again = call.parameters;
      const std::string word = again.word();
      if (word != "INF" && word != "INFINITY") throw ScpiError(-224, "a number or INF");
      count_ = kScansWithoutEnd;
    } catch (const ScpiError& error) {
      if (error.code() != -104) throw;
      count_ = call.parameters.integer(1, 50'000);
    }
  });
  table_.add("TRIGger:COUNt?", 0, "number of scans", [this](ScpiCall& call) {
    call.reply =
        count_ == kScansWithoutEnd ? "9.90000000E+37" : meter_number(static_cast<double>(count_));
  });
}

void Scanner34970A::add_formats() {
  const std::array<std::pair<const char*, bool Scanner34970A::*>, 4> flags{
      {{"FORMat:READing:ALARm", &Scanner34970A::with_alarm_},
       {"FORMat:READing:TIME", &Scanner34970A::with_time_},
       {"FORMat:READing:CHANnel", &Scanner34970A::with_channel_},
       {"FORMat:READing:UNIT", &Scanner34970A::with_unit_}}};
  for (const auto& [pattern, flag] : flags) {
    table_.add(pattern, 1, "whether readings have it: ON or OFF",
               [this, f = flag](ScpiCall& call) { this->*f = call.parameters.flag(); });
    table_.add(std::string(pattern) + "?", 0, "whether readings have it",
               [this, f = flag](ScpiCall& call) { call.reply = this->*f ? "1" : "0"; });
  }
  table_.add("FORMat:READing:TIME:TYPE", 1, "ABS: date and time, REL: s since INIT",
             [this](ScpiCall& call) {
               const std::string word = call.parameters.word();
               if (!word.starts_with("ABS") && !word.starts_with("REL"))
                 throw ScpiError(-224, "must be one of: ABS, REL");
               absolute_ = word.starts_with("ABS");
             });
  table_.add("FORMat:READing:TIME:TYPE?", 0, "ABS or REL",
             [this](ScpiCall& call) { call.reply = absolute_ ? "ABS" : "REL"; });
}

void Scanner34970A::add_readings() {
  table_.add("INITiate", 0, "clear the memory and scan as configured with TRIG",
             [this](ScpiCall&) { start(); });
  table_.add("ABORt", 0, "ends scanning", [this](ScpiCall&) { stop(); });
  table_.add("*TRG", 0, "a scan, where TRIG:SOUR is BUS", [this](ScpiCall&) {
    if (source_ != Source::bus || scans_left_ == 0)
      throw ScpiError(-221, "no scan waits for *TRG; send TRIG:SOUR BUS and INIT first");
    scan();
  });
  table_.add("READ?", 0, "INIT of one scan, and its readings", [this](ScpiCall& call) {
    if (source_ != Source::immediate || count_ != 1)
      throw ScpiError(
          -221, "READ? needs TRIG:SOUR IMM and TRIG:COUN 1; otherwise use INIT and FETC? or R?");
    start();
    take(memory_.size(), call, true, false);
  });
  table_.add("FETCh?", 0, "all readings in the memory, which keeps them", [this](ScpiCall& call) {
    if (memory_.empty()) throw ScpiError(-230, "no reading in the memory");
    take(memory_.size(), call, true, false);
  });
  table_.add("R?", 1, "takes so many of the oldest readings, or all, as a block",
             [this](ScpiCall& call) {
               const int most = call.parameters.more() ? call.parameters.integer(1, 50'000)
                                                       : static_cast<int>(kMostReadings);
               take(std::min<std::size_t>(most, memory_.size()), call, false, true);
             });
  table_.add("DATA:POINts?", 0, "readings in the memory",
             [this](ScpiCall& call) { call.reply = fmt::format("{:+}", std::ssize(memory_)); });
  table_.add("DATA:REMove?", 1, "takes so many of the oldest readings", [this](ScpiCall& call) {
    const auto wanted = static_cast<std::size_t>(call.parameters.integer(1, 50'000));
    if (wanted > memory_.size())
      throw ScpiError(-222, fmt::format("there are {} readings", memory_.size()));
    take(wanted, call, false, false);
  });
}

void Scanner34970A::set_scan_list(ScpiCall& call) {
  std::vector<int> list = call.parameters.channels();
  for (const int channel : list) point(channel);
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  stop();
  memory_.clear();
  list_ = std::move(list);
}

const Point& Scanner34970A::point(int channel) const {
  const int slot = channel / 100 - 1, place = channel % 100 - 1;
  const int index = slot * kChannelsOfSlot + place;
  if (slot < 0 || place < 0 || place >= kChannelsOfSlot || index >= std::ssize(device_.points))
    throw ScpiError(-222, fmt::format("there is no channel {}", channel));
  return device_.points[static_cast<std::size_t>(index)];
}

void Scanner34970A::start() {
  if (list_.empty()) throw ScpiError(-221, "no channels; send ROUT:SCAN first");
  memory_.clear();
  overflow_ = false;
  started_s_ = now_s_;
  scans_made_ = 0;
  scans_left_ = count_;
  if (source_ != Source::bus) scan();
}

void Scanner34970A::scan() {
  if (scans_left_ != kScansWithoutEnd) --scans_left_;
  ++scans_made_;
  for (const int channel : list_) {
    overflow_ = overflow_ || memory_.size() == kMostReadings;
    if (memory_.size() == kMostReadings) memory_.pop_front();
    memory_.push_back({now_s_, point(channel).read(), channel});
  }
}

double Scanner34970A::next_scan_s() const {
  if (scans_left_ == 0 || source_ == Source::bus) return std::numeric_limits<double>::infinity();
  if (source_ == Source::immediate) return now_s_;
  return started_s_ + timer_s_ * static_cast<double>(scans_made_);
}

void Scanner34970A::process(double now_s) {
  now_s_ = std::max(now_s, now_s_);
  if (next_scan_s() > now_s_) return;
  scan();
  // Instants that were missed meanwhile are counted as made.
  if (source_ == Source::timer && timer_s_ > 0 && next_scan_s() <= now_s_)
    scans_made_ = static_cast<std::int64_t>((now_s_ - started_s_) / timer_s_) + 1;
}

void Scanner34970A::take(std::size_t count, ScpiCall& call, bool keep, bool block) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    text += text_of(memory_[i]);
  }
  if (!keep) memory_.erase(memory_.begin(), memory_.begin() + std::ptrdiff_t(count));
  call.reply = block ? as_block(text) : text;
}

std::string Scanner34970A::text_of(const Reading& reading) const {
  std::string text = meter_number(reading.value);
  if (with_unit_) {
    const std::string unit(unit_of_point(point(reading.channel).name));
    text += " " + (unit == "V" ? "VDC" : unit);
  }
  if (with_time_)
    text += absolute_ ? "," + calendar_fields(epoch_s_ + reading.time_s)
                      : fmt::format(",{:012.3f}", reading.time_s - started_s_);
  if (with_channel_) text += fmt::format(",{:03}", reading.channel);
  if (with_alarm_) text += ",0";  // no limit is set
  return text;
}

}  // namespace triax::lab
