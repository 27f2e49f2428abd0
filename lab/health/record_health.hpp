#pragma once
// All sensors of a test, each by itself and against the others.
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/collapse/test_summary.hpp"
#include "lab/health/channel_health.hpp"
#include "lab/records/reading.hpp"
#include "lab/records/record_header.hpp"

namespace triax::lab {

/// One bit a quantity.
using ChannelSet = std::uint32_t;
constexpr ChannelSet channel_bit(Quantity q) { return ChannelSet{1} << index(q); }

/// Beside what ChannelHealth sees in one channel, in shear:
/// - driven by displacement, the force stands still to the last digit though the area grew so much
///   that it cannot: F Δε of kSteps steps of its converter;
/// - driven by displacement, the displacement stands still though the load changed by more than the
///   stiffest soil takes up within kLeastSteps steps of the converter;
/// - u, or one of those two, jumps alone and then stands still to the last digit.
class RecordHealth {
 public:
  static constexpr double kSteps = 20;
  static constexpr double kLeastSteps = 3;
  static constexpr double kStiffest_pa = 2e9;  ///< Young's modulus beyond that of soils
  static constexpr std::int64_t kAtRest = 30;  ///< readings for which a channel must stand still

  /// Readings from..until of a channel turned out to be wrong.
  struct Wrong {
    SensorFinding finding;
    std::int64_t from = 0, until = 0;
  };

  explicit RecordHealth(const RecordHeader& header);

  void watch(const Reading& reading);
  /// What the last reading brought to light about itself and readings before it.
  const std::vector<Wrong>& wrong() const { return wrong_; }
  /// First reading about which something may still come to light: no earlier one can be found
  /// wrong.
  std::int64_t doubtful_from() const { return doubtful_from_; }
  /// Findings that came to light with the last reading.
  const std::vector<SensorFinding>& news() const { return news_; }
  /// One sentence for each sensor and kind of fault.
  std::vector<Warning> warnings() const;

 private:
  struct Channel {
    Quantity quantity{};
    ChannelHealth health;
    std::optional<SensorFinding> open;          ///< what it is dead of
    std::optional<std::int64_t> lonely_jump{};  ///< reading at which it jumped and no other did
    Reading at_rest{};                          ///< the reading whose value it repeats since
  };
  struct Tally {
    SensorFinding first;
    std::int64_t more = 0;
  };
  void start_stage(const Reading& reading);
  void compare(Channel& channel, const Reading& reading);
  bool cannot_rest(const Channel& channel, const Reading& reading) const;
  bool jumped_alone(const Channel& channel) const;
  void note_jumps(const Reading& reading);
  void report(Channel& channel, const Reading& reading);
  SensorFinding& tally(const SensorFinding& finding);
  std::optional<double> time_of(std::int64_t number, const Reading& now) const;

  RecordHeader header_;
  std::vector<Channel> channels_;
  std::optional<int> stage_;
  std::int64_t stage_from_ = 0;
  bool shear_ = false, driven_ = false;
  Reading last_;
  std::vector<Wrong> wrong_;
  std::vector<SensorFinding> news_;
  std::int64_t doubtful_from_ = 0;
  std::vector<Tally> tallies_;  ///< one a channel and kind
};

}  // namespace triax::lab
