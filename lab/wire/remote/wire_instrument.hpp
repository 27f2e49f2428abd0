// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One instrument of a rig on the controller's side: its line, who it says that it is, what it is
// asked and set. Nothing is invented: what did not come, or what a ReplyCheck rejects, is missing,
// with the cause in words.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/wire/asking/questions.hpp"
#include "lab/wire/line/line.hpp"
#include "lab/wire/remote/reply_check.hpp"
#include "lab/wire/rig_file.hpp"

namespace triax::lab {

class WireInstrument {
 public:
  /// A link that is lost is taken up again after pauses that grow with the time since it was last
  /// understood, so that one which is back within kHurry_s is found before a test has to end for
  /// it. Then it is left alone for kLongestPause_s at a time: longer than the watchdogs of devices
  /// wait, so that one that hears us and is not understood holds.
  static constexpr double kFirstPause_s = 0.1, kPauseOfAway = 0.125, kHurry_s = 3,
                          kLongestPause_s = 8;

  /// `also`: points that are read with the channels at every scan ("state"). All outlive it. Throws
  /// BadInput where the instrument does not have one of them.
  WireInstrument(LineLoop& loop, const RigInstrument& described, std::vector<std::string> also);

  /// Begins to open the line; from here on it sees to itself, from the loop.
  void start();
  const RigInstrument& described() const { return described_; }
  /// Linked, known by its identity and prepared.
  bool ready() const { return state_ == State::ready; }
  /// Empty while it has never said who it is.
  const std::string& identity() const { return identity_; }
  /// Why it is not ready or what was wrong with its last answer; empty: nothing.
  const std::string& trouble() const { return trouble_; }
  /// Times that it became ready.
  int links() const { return links_; }

  struct Scan {
    std::vector<CalibratedValue> channels;  ///< in the order of the description; NaN: missing
    std::vector<double> also;               ///< NaN: missing
    double sent_s = 0, answered_s = 0;      ///< on the loop's clock; 0: not asked
    std::optional<double> stamp_s;          ///< by the instrument's own clock, where it says it
    std::string why;                        ///< what was wrong; empty: all was answered
  };
  /// Asks for everything at once; `done` is called once, from the loop, by the instrument's
  /// deadline counted from `asked_s` (the instant of the scan, now or a little before) or by
  /// `latest_s`, both on the loop's clock. It may be called after the caller has returned, so it
  /// owns what it needs. An instrument that is not ready gives a scan without values.
  void scan(std::function<void(const Scan&)> done, double asked_s, double latest_s);
  /// Sets the points; `done` gets an empty text, or why not.
  void set(const std::vector<PointSetting>& settings, std::function<void(const std::string&)> done);

 private:
  enum class State { down, opening, greeting, ready };
  struct Round;

  void open();
  void greet();
  void prepare(std::vector<Exchange> rest);
  void set_next(std::vector<Exchange> rest, std::function<void(const std::string&)> done);
  void fail(const std::string& why);
  void ask(const std::shared_ptr<Round>& round, std::size_t question);
  void take(const std::shared_ptr<Round>& round, std::size_t question, const Asked& asked);
  void finish(Round& round);

  LineLoop& loop_;
  const RigInstrument& described_;
  std::vector<AskedValue> asked_;
  std::unique_ptr<Questions> questions_;
  std::vector<Question> round_;     ///< of one scan
  std::vector<ReplyCheck> checks_;  ///< one per question
  std::size_t channels_ = 0;
  Line line_;
  LineTimer again_;
  State state_ = State::down;
  std::optional<double> wrong_s_;  ///< since when no scan was whole
  std::string identity_, trouble_;
  int links_ = 0;
};

}  // namespace triax::lab
