// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/reply_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace triax::lab {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

bool is_within(const std::pair<double, double>& range, double value) {
  return value >= range.first && value <= range.second;
}

}  // namespace

ReplyCheck::ReplyCheck(std::vector<ReplyPlace> places, bool can_ask_again)
    : can_ask_again_(can_ask_again) {
  for (ReplyPlace& place : places) channels_.push_back({.place = std::move(place), .trend = {}});
}

bool ReplyCheck::has_odd_form(const Reply& reply) const {
  const bool other_length =
      steady_ >= kSteady && reply.length != length_ && reply.length != before_.length;
  return reply.trailing || other_length;
}

bool ReplyCheck::is_possible(const Channel& channel, double value) {
  if (std::isnan(value) || std::isinf(value) || is_within(channel.place.possible, value))
    return true;
  why_ = fmt::format("response rejected: {} {:.10g} is outside {:g} to {:g}", channel.place.name,
                     value, channel.place.possible.first, channel.place.possible.second);
  return false;
}

bool ReplyCheck::is_complete() const {
  return std::ranges::all_of(channels_,
                             [](const Channel& channel) { return channel.accepted.has_value(); });
}

bool ReplyCheck::add(Reply reply) {
  ++replies_;
  if (!reply.trouble.empty())
    why_ = reply.trouble;
  else if (has_odd_form(reply))
    why_ = fmt::format("response rejected: {} bytes{} instead of {}", reply.length,
                       reply.trailing ? " and more" : "", length_);
  else
    started_ ? evaluate(reply) : begin(reply);
  if (reply.trouble.empty()) before_ = std::move(reply);
  return can_ask_again_ && !is_complete() && replies_ < (started_ ? kMaxReplies : kMaxFirstReplies);
}

void ReplyCheck::begin(const Reply& reply) {
  first_.push_back(reply.values);
  if (can_ask_again_ && std::ssize(first_) < kFirstReplies) return;
  started_ = true;
  for (std::size_t i = 0; i < channels_.size(); ++i) start(channels_[i], i);
  first_.clear();
}

void ReplyCheck::start(Channel& channel, std::size_t place) {
  std::vector<double> values;
  bool all_possible = true;
  for (const std::vector<double>& reply : first_) {
    const bool possible = is_possible(channel, reply[place]);
    all_possible = all_possible && possible;
    if (possible && !std::isnan(reply[place])) values.push_back(reply[place]);
  }
  if (values.empty()) {
    if (all_possible) channel.accepted = kNoValue;
    return;
  }
  std::ranges::sort(values);
  const double median = values[values.size() / 2];
  channel.accepted = median;
  if (std::isinf(median)) return;
  for (double& value : values) value = std::fabs(value - median);
  std::ranges::sort(values);
  // The largest may be garbled.
  channel.trend.start(median, values[values.size() > 1 ? values.size() - 2 : 0]);
}

void ReplyCheck::evaluate(const Reply& reply) {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    Channel& channel = channels_[i];
    const double value = reply.values[i];
    if (!is_possible(channel, value)) continue;
    const bool calibrated =
        is_within(channel.place.calibrated, value) ||
        (channel.trend.value() && !is_within(channel.place.calibrated, *channel.trend.value()));
    const bool has_before = i < before_.values.size() && !std::isnan(before_.values[i]);
    const bool expected = std::isnan(value) || (calibrated && channel.trend.expects(value));
    const bool confirms = has_before && channel.trend.confirms(value, before_.values[i]);
    channel.confirmed = !expected && confirms ? channel.confirmed + 1 : 0;
    if (expected || channel.confirmed >= (can_ask_again_ ? kConfirmations : 1)) {
      channel.accepted = value;
      continue;
    }
    why_ = fmt::format("response rejected: {} {:.10g}{}, expected about {:.10g}",
                       channel.place.name, value, replies_ > 1 ? " when queried again" : "",
                       channel.trend.value().value_or(kNoValue));
  }
}

void ReplyCheck::fail(const std::string& why) {
  if (why_.empty()) why_ = why;
}

ReplyCheck::Outcome ReplyCheck::end() {
  Outcome outcome;
  const bool complete = is_complete();
  for (Channel& channel : channels_) {
    const double value = channel.accepted.value_or(kNoValue);
    outcome.values.push_back(value);
    std::isnan(value) ? channel.trend.miss() : channel.trend.accept(value);
    channel.accepted.reset();
  }
  if (complete) {
    steady_ = before_.length == length_ ? steady_ + 1 : 1;
    length_ = before_.length;
  } else {
    outcome.why = why_;
  }
  why_.clear();
  replies_ = 0;
  return outcome;
}

}  // namespace triax::lab
