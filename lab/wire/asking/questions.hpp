// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a controller asks and sets on one instrument, as exchanges in the instrument's own language.
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/wire/asked_value.hpp"
#include "lab/wire/exchange.hpp"
#include "lab/wire/link_address.hpp"
#include "lab/wire/personality.hpp"

namespace triax::lab {

struct PointSetting {
  std::string point;
  double value = 0;
  bool operator==(const PointSetting&) const = default;
};

/// values[i] of the exchange belongs to asked[places[i]]; where it is stamped, one more value
/// behind them is the instant by the instrument's own clock, s since 1970.
struct Question {
  Exchange exchange;
  std::vector<std::size_t> places;
  bool stamped = false;
};

/// Values are as the instrument says them, in its units: NaN where it has none, ±infinity where it
/// is beyond the end of its range (SCPI ±9.9E37).
class Questions {
 public:
  virtual ~Questions() = default;
  Questions() = default;
  Questions(const Questions&) = delete;
  Questions& operator=(const Questions&) = delete;

  /// Sent one after the other once a link stands, for what will be asked; may be empty.
  virtual std::vector<Exchange> prepare(const std::vector<AskedValue>& asked) = 0;
  /// Its `text` is for Personality::complaint_about; empty: the instrument does not say who it is.
  virtual std::optional<Exchange> identify() = 0;
  /// As few questions as the instrument allows. Throws BadInput for a value that it has not.
  virtual std::vector<Question> read(const std::vector<AskedValue>& asked) = 0;
  /// In the order of the personality, whatever the order here. Throws BadInput for a value that
  /// cannot be set or that its registers cannot hold. What the instrument refuses is Malformed; the
  /// exchanges behind it are then not to be asked, so that what takes effect by the last does not.
  virtual std::vector<Exchange> set(const std::vector<PointSetting>& settings) = 0;
};

/// In the protocol of the link. The personality lives longer. Throws BadInput where it does not
/// speak that.
std::unique_ptr<Questions> questions_for(const Personality& personality, const LinkAddress& link);
/// By SCPI or lines. Pre-condition: the personality speaks that.
std::unique_ptr<Questions> text_questions(const Personality& personality);

}  // namespace triax::lab
