// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// What stands behind a header, parted by commas. Each call takes the next one; ScpiError -109
/// where there is none, -104 where it is of another kind.
class ScpiParameters {
 public:
  ScpiParameters() = default;
  /// Throws ScpiError: -102 for one that is empty, -151 and -161 for a text or block without end.
  explicit ScpiParameters(std::string_view text);

  std::size_t count() const { return items_.size(); }
  bool more() const { return next_ < items_.size(); }

  /// 12, -1.5E3, or with `unit` behind it, in any case; another one is -131. Never inf nor NaN.
  double number(std::string_view unit = "");
  /// A whole number from `lowest` to `highest`; -222 outside of them.
  int integer(int lowest, int highest);
  /// ON, OFF, or a number: 0 is off.
  bool flag();
  /// A bare word in capitals: IMM.
  std::string word();
  /// "..." or '...', where a doubled quote is one.
  std::string text();
  /// (@101:107,110), in the order given: backwards too. At most 1,000, else -222.
  std::vector<int> channels();
  /// #214...: its bytes.
  std::string block();
  bool is_channels() const;

 private:
  std::string_view take();

  std::vector<std::string> items_;
  std::size_t next_ = 0;
};

/// Length of the definite block at the front of `text` with its head, "#2" and "14" and 14 bytes;
/// 0: there is none. It may be longer than the text.
std::size_t block_length(std::string_view text);
/// The bytes as a definite block.
std::string as_block(std::string_view bytes);

}  // namespace triax::lab
