// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Decides which values of an instrument's replies are readings, so that noise on a line neither
// steers a test nor gets into its record.
//
// A value of a reply is accepted if the trend of its channel expects it (value_trend.hpp) and it is
// within the range of its calibration. Any other value is asked for again, up to kMaxReplies
// replies a scan, and accepted if kConfirmations more replies in a row agree with it: so a genuine
// jump is a reading of the same scan. One would not do: any two digits that are doubled in a number
// give much the same wrong value. A reply is asked for again, too, if it could not be understood,
// if bytes follow it, or if its length differs from that of the kSteady replies before: an
// instrument that prints numbers of a fixed form gives itself away so when a byte is lost or
// doubled. A value outside of what the instrument or an apparatus can give is never accepted.
//
// The first reading is the median of kFirstReplies replies, which also give the noise of each
// channel; if they do not come by the deadline, later scans complete them.
//
// An instrument that speaks unasked cannot be asked again: its next reply alone confirms, a scan
// later.
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/wire/remote/value_trend.hpp"

namespace triax::lab {

/// One value of a reply, as the instrument says it, before calibration.
struct ReplyPlace {
  static constexpr double kAny = std::numeric_limits<double>::infinity();
  std::string name;                                   ///< of the channel or point
  std::pair<double, double> possible{-kAny, kAny};    ///< inclusive
  std::pair<double, double> calibrated{-kAny, kAny};  ///< inclusive
};

struct Reply {
  std::vector<double> values;  ///< one per place; NaN: the instrument has none; ±infinity: its end
  std::size_t length = 0;      ///< bytes
  bool trailing = false;       ///< bytes follow it
  std::string trouble = {};    ///< why it could not be understood; empty: it could
};

class ReplyCheck {
 public:
  static constexpr int kMaxReplies = 5, kConfirmations = 2, kFirstReplies = 5,
                       kMaxFirstReplies = 12;
  static constexpr int kSteady = 16;

  ReplyCheck(std::vector<ReplyPlace> places, bool can_ask_again);

  /// The next reply of this scan. True: ask again.
  bool add(Reply reply);
  /// No further reply comes in this scan.
  void fail(const std::string& why);

  struct Outcome {
    std::vector<double> values;  ///< one per place; NaN: rejected, or the instrument has none
    std::string why;             ///< a value is missing for; empty: none was rejected
  };
  /// Ends the scan.
  Outcome end();

 private:
  struct Channel {
    ReplyPlace place;
    ValueTrend trend;
    std::optional<double> accepted{};  ///< in this scan
    int confirmed = 0;                 ///< replies in a row that agreed with an unusual one
  };
  bool has_odd_form(const Reply& reply) const;
  bool is_possible(const Channel& channel, double value);
  void begin(const Reply& reply);
  void start(Channel& channel, std::size_t place);
  void evaluate(const Reply& reply);
  bool is_complete() const;

  std::vector<Channel> channels_;
  bool can_ask_again_;
  bool started_ = false;
  int replies_ = 0;                         ///< of this scan
  std::vector<std::vector<double>> first_;  ///< values of replies until it has started
  Reply before_;                            ///< the reply before, of this scan or an earlier one
  std::size_t length_ = 0;                  ///< of the last good reply
  int steady_ = 0;                          ///< good replies in a row that had it
  std::string why_;
};

}  // namespace triax::lab
