#pragma once
// All sensors of a test, each by itself and against the others.
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lab/collapse/test_summary.hpp"
#include "lab/health/channel_health.hpp"
#include "lab/records/reading.hpp"
#include "lab/records/record_header.hpp"

namespace triax::lab {

/// One bit a quantity.
using ChannelSet = std::uint32_t;
constexpr ChannelSet channel_bit(Quantity q) { return ChannelSet{1} << index(q); }

/// Beside what ChannelHealth sees in one channel, in a shear stage driven by displacement:
/// - the displacement stands still while the load changes by kLoad_pa over the specimen's area;
/// - the force stands still to the last digit while the area grew so much that it cannot
///   (F Δε > kSteps steps of its converter);
/// and in any stage a jump of one channel alone to a constant, where pressures that a controller
/// can step at will are left out.
class RecordHealth {
 public:
  static constexpr double kLoad_pa = 20e3;
  static constexpr double kSteps = 20;

  /// Readings from..until of a channel turned out to be wrong.
  struct Wrong {
    Quantity channel{};
    std::int64_t from = 0, until = 0;
  };

  explicit RecordHealth(const RecordHeader& header);

  void watch(const Reading& reading);
  /// What the last reading brought to light about itself and readings before it.
  const std::vector<Wrong>& wrong() const { return wrong_; }
  /// First reading about which something may still come to light.
  std::int64_t doubtful_from() const { return doubtful_from_; }
  /// Findings that began or came to light with the last reading.
  const std::vector<SensorFinding>& news() const { return news_; }
  /// The finding that makes a channel dead now.
  std::optional<SensorFinding> dead(Quantity channel) const;
  /// Whether a reading of this channel is needed for stresses and strains in that stage.
  bool needed(Quantity channel, int stage) const;

  /// One sentence for each sensor and kind of fault; constant in number.
  std::vector<Warning> warnings() const;

 private:
  struct Channel {
    Quantity quantity{};
    ChannelHealth health;
    std::optional<SensorFinding> open;
  };
  struct Tally {
    SensorFinding first;
    std::int64_t count = 0;
    std::int64_t readings = 0;
  };
  void start_stage(const Reading& reading);
  void compare(const Reading& reading);
  void compare_force(const Reading& reading);
  void compare_displacement(const Reading& reading);
  void compare_jumps(const Reading& reading);
  void report(Channel& channel, const Reading& reading);
  void note(const SensorFinding& finding);
  Channel* find(Quantity q);

  RecordHeader header_;
  std::vector<Channel> channels_;
  std::optional<int> stage_;
  bool driven_ = false;  ///< a shear stage driven by displacement
  Reading last_;
  std::optional<std::pair<double, double>> at_force_rest_, at_displacement_rest_;
  std::vector<Wrong> wrong_;
  std::vector<SensorFinding> news_;
  std::int64_t doubtful_from_ = 0;
  std::map<std::pair<Quantity, SensorFault>, Tally> tallies_;
};

}  // namespace triax::lab
