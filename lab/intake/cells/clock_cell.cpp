// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/clock_cell.hpp"

#include <algorithm>
#include <utility>

#include "lab/intake/cells/clock_words.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxClockSize = 64;  ///< bytes
constexpr int kMaxDigits = 19;             ///< of a number
constexpr int kNanoDigits = 9;

bool is_clock_digit(char c) { return static_cast<unsigned>(c - '0') < 10U; }
bool is_clock_letter(char c) {
  const auto lower = static_cast<unsigned char>(c | 0x20);
  return static_cast<unsigned char>(c) >= 0x80 || (lower >= 'a' && lower <= 'z');
}

/// Reads a cell from its first to its last byte.
class ClockScanner {
 public:
  explicit ClockScanner(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}

  std::optional<ClockCell> scan() {
    if (at_ == end_ || !scan_plain_number()) return std::nullopt;
    if (cell_.is_number && !is_compact(plain_digits_)) return cell_;
    while (at_ != end_) {
      const bool known = is_clock_digit(*at_)    ? scan_number()
                         : skip_blanks()         ? true
                         : is_clock_letter(*at_) ? scan_word()
                         : is_offset()           ? scan_offset()
                         : *at_ == '('           ? skip_brackets()
                                                 : skip_mark();
      if (!known) return std::nullopt;
    }
    return settle() ? std::optional(cell_) : std::nullopt;
  }

 private:
  struct Number {
    std::int64_t value = 0;
    int digits = 0;
  };

  Number digits() {
    std::uint64_t value = 0;
    int count = 0;
    for (; at_ != end_ && is_clock_digit(*at_); ++at_, ++count)
      if (count < kMaxDigits) value = 10 * value + static_cast<unsigned>(*at_ - '0');
    return {static_cast<std::int64_t>(value), count};
  }

  bool next_is_digit() const { return end_ - at_ > 1 && is_clock_digit(at_[1]); }

  /// Nanoseconds of the digits behind a decimal mark at `at_`.
  void scan_fraction() {
    ++at_;
    int count = 0;
    for (; at_ != end_ && is_clock_digit(*at_); ++at_, ++count)
      if (count < kNanoDigits)
        cell_.fraction_ns = 10 * cell_.fraction_ns + (*at_ - '0');
      else if (count == kNanoDigits && *at_ >= '5')
        ++cell_.fraction_ns;
    for (; count < kNanoDigits; ++count) cell_.fraction_ns *= 10;
    cell_.has_fraction = true;
  }

  /// "46090.9167", "1773093600": true also for any other text, false for too many digits.
  bool scan_plain_number() {
    const char* const begin = at_;
    const Number whole = digits();
    double unit = 1;
    if (at_ != begin && at_ != end_ && (*at_ == '.' || *at_ == ',') && next_is_digit())
      for (++at_; at_ != end_ && is_clock_digit(*at_); ++at_)
        cell_.decimals += (unit /= 10) * (*at_ - '0');
    cell_.is_number = at_ == end_;
    cell_.whole = whole.value;
    plain_digits_ = whole.digits;
    if (cell_.is_number && (whole.digits > kMaxDigits || whole.value < 0)) return false;
    if (!cell_.is_number || is_compact(plain_digits_)) at_ = begin;
    return true;
  }

  bool skip_blanks() {
    if (static_cast<signed char>(*at_) > ' ') return false;
    const std::size_t size = blank_size(at_);
    if (size > 0) mark_date(*at_);
    at_ += size;
    return size > 0;
  }

  bool skip_brackets() {
    at_ = std::find(at_, end_, ')');
    return at_++ != end_;
  }

  bool skip_mark() {
    if (numbers_ + cell_.time_parts == 0 && *at_ != ',' && *at_ != '.') return false;
    if (*at_ == ':' && numbers_ == 3 && cell_.time_parts == 0) return ++at_ != end_;
    mark_date(*at_);
    constexpr std::string_view kMarks = "-/.,_'";
    return kMarks.find(*at_++) != std::string_view::npos;
  }

  void mark_date(char mark) {
    if (numbers_ == 1 && cell_.date_mark == 0) cell_.date_mark = mark;
  }

  bool add_date_part(DatePart part) {
    if (numbers_ == static_cast<int>(parts_.size())) return false;
    parts_[static_cast<std::size_t>(numbers_++)] = part;
    return true;
  }

  bool scan_number() {
    const Number number = digits();
    const bool is_year = numbers_ == 2 && number.digits == 4;  // 09/Mar/2026:22:15:30
    if (at_ != end_ && *at_ == ':' && cell_.time_parts == 0 && !is_year) return scan_time(number);
    if (std::exchange(is_behind_time_mark_, false) && cell_.time_parts < 3) return add_time(number);
    if (numbers_ == 0 && is_compact(number.digits)) return add_compact(number);
    if (is_compact_ && cell_.time_parts == 0 && (number.digits == 6 || number.digits == 4))
      return add_compact_time(number);
    constexpr int kMaxPartDigits = 9;
    if (number.digits > kMaxPartDigits) return false;
    return add_date_part({static_cast<int>(number.value), number.digits});
  }

  // 20260310, 202603100630, 20260310063024, 20260310063024123.
  static bool is_compact(int digits) {
    return digits == 8 || digits == 12 || digits == 14 || digits == 17;
  }

  bool add_compact(Number number) {
    is_compact_ = true;
    if (number.digits == 17) {
      cell_.fraction_ns = number.value % 1000 * 1'000'000;
      cell_.has_fraction = true;
      number = {number.value / 1000, 14};
    }
    if (number.digits > 8) {
      const std::int64_t unit = number.digits == 14 ? 1'000'000 : 10'000;
      add_compact_time({number.value % unit, number.digits - 8});
      number.value /= unit;
    }
    const auto value = static_cast<int>(number.value);
    return add_date_part({value / 10'000, 4}) && add_date_part({value / 100 % 100, 2}) &&
           add_date_part({value % 100, 2});
  }

  bool add_compact_time(const Number& number) {
    auto value = static_cast<int>(number.value);
    cell_.time_parts = number.digits / 2;
    for (int part = cell_.time_parts - 1; part >= 0; --part, value /= 100)
      cell_.time[static_cast<std::size_t>(part)] = value % 100;
    if (cell_.time_parts == 3 && at_ != end_ && (*at_ == '.' || *at_ == ',') && next_is_digit())
      scan_fraction();
    return true;
  }

  bool add_time(const Number& number) {
    constexpr int kMaxHourDigits = 5;
    if (cell_.time_parts == 3 || number.digits > kMaxHourDigits) return false;
    if (cell_.time_parts == 0) parts_before_time_ = numbers_;
    cell_.time[static_cast<std::size_t>(cell_.time_parts++)] = static_cast<int>(number.value);
    if (cell_.time_parts == 3 && at_ != end_ && (*at_ == '.' || *at_ == ',') && next_is_digit())
      scan_fraction();
    return true;
  }

  /// 22:15, 22:15:30, 22:15:30.5, 22:15:30,5, 22:15:30:500, 15:30.5
  bool scan_time(const Number& hours) {
    if (!add_time(hours)) return false;
    while (at_ != end_ && *at_ == ':' && next_is_digit() && cell_.time_parts < 3) {
      ++at_;
      const Number part = digits();
      if (part.digits > 2 || !add_time(part)) return false;
    }
    if (cell_.time_parts < 2) return false;
    if (cell_.has_fraction || at_ == end_) return true;
    const bool is_mark = *at_ == '.' || *at_ == ',' || (*at_ == ':' && cell_.time_parts == 3);
    if (is_mark && next_is_digit()) scan_fraction();
    return at_ == end_ || *at_ != ':';
  }

  bool scan_word() {
    const char* stop = at_;
    while (stop != end_ && is_clock_letter(*stop) && blank_size(stop) == 0) ++stop;
    if (scan_dotted_half(stop)) return true;
    if (stop - at_ == 1 && numbers_ == 0 && stop != end_ && is_clock_digit(*stop))
      if (const auto era = find_era_letter(*at_)) {
        ++at_;
        cell_.era_years = *era;
        return true;
      }
    const auto word = find_clock_word({at_, static_cast<std::size_t>(stop - at_)});
    if (!word) return false;
    mark_date(word->kind == ClockWordKind::month ? 'A' : *at_);
    at_ += word->length;
    return apply(*word);
  }

  /// Bytes of the space at `at`, no-break and thin spaces too; 0 for anything else.
  std::size_t blank_size(const char* at) const {
    constexpr std::array<std::string_view, 5> kBlanks{" ", "\t", "\xC2\xA0", "\xE2\x80\xAF",
                                                      "\xE2\x80\x89"};
    const std::string_view rest(at, static_cast<std::size_t>(end_ - at));
    const auto* const found = std::ranges::find_if(
        kBlanks, [&](std::string_view blank) { return rest.starts_with(blank); });
    return found == kBlanks.end() ? 0 : found->size();
  }

  /// "a.m.", "p. m." with the first letter up to `stop`.
  bool scan_dotted_half(const char* stop) {
    const char letter = static_cast<char>(*at_ | 0x20);
    if (cell_.half_of_day != 0 || stop - at_ != 1 || (letter != 'a' && letter != 'p') ||
        stop == end_ || *stop != '.')
      return false;
    const char* const begin = at_;
    at_ = stop + 1;
    while (at_ != end_ && skip_blanks()) continue;
    if (at_ == end_ || (*at_ | 0x20) != 'm') {
      at_ = begin;
      return false;
    }
    ++at_;
    if (at_ != end_ && *at_ == '.') ++at_;
    return set_half(letter == 'a' ? 1 : 2);
  }

  bool set_half(int half) {
    if (cell_.half_of_day != 0) return false;
    cell_.half_of_day = half;
    return true;
  }

  bool apply(const ClockWord& word) {
    switch (word.kind) {
      case ClockWordKind::month:
        return add_date_part({word.value, 0});
      case ClockWordKind::first_half:
        return set_half(1);
      case ClockWordKind::second_half:
        return set_half(2);
      case ClockWordKind::year_mark:
        cell_.has_year_mark = numbers_ == 1;
        return true;
      case ClockWordKind::hour_mark:
        return mark_time(0);
      case ClockWordKind::minute_mark:
        return mark_time(1);
      case ClockWordKind::second_mark:
        return mark_time(2);
      case ClockWordKind::era:
        cell_.era_years = word.value;
        return numbers_ == 0;
      case ClockWordKind::zone:
        if (cell_.time_parts == 0 || cell_.has_offset) return false;
        cell_.has_offset = true;
        cell_.offset_min = word.value;
        return true;
      case ClockWordKind::month_mark:
      case ClockWordKind::day_mark:
      case ClockWordKind::other:
        break;
    }
    return true;
  }

  /// h, min or s behind a number: it is the hours, minutes or seconds.
  bool mark_time(int part) {
    is_behind_time_mark_ = part < 2;
    if (cell_.time_parts > part) return true;
    if (cell_.time_parts < part && (part > 1 || cell_.time_parts > 0)) return false;
    if (numbers_ == 0) return false;
    const DatePart last = parts_[static_cast<std::size_t>(--numbers_)];
    if (numbers_ == 0) cell_.date_mark = 0;
    if (part > cell_.time_parts && !add_time({})) return false;  // no hours
    return last.digits > 0 && add_time({last.value, last.digits});
  }

  bool is_offset() const {
    return (*at_ == '+' || *at_ == '-') && cell_.time_parts > 0 && next_is_digit() &&
           (numbers_ == 0 || numbers_ == 3);
  }

  /// +01:00, +0100, +01
  bool scan_offset() {
    const int sign = *at_++ == '-' ? -1 : 1;
    const Number first = digits();
    int minutes = 0;
    if (first.digits == 4) {
      minutes = static_cast<int>(first.value / 100 * 60 + first.value % 100);
    } else if (first.digits <= 2) {
      minutes = static_cast<int>(60 * first.value);
      if (at_ != end_ && *at_ == ':' && next_is_digit()) {
        ++at_;
        minutes += static_cast<int>(digits().value % 100);
      }
    } else {
      return false;
    }
    constexpr int kMaxOffset_min = 18 * 60;
    cell_.has_offset = true;
    cell_.offset_min += sign * minutes;
    return minutes <= kMaxOffset_min;
  }

  /// Six numbers without colons are a date and a time; then the number of parts must be right.
  bool settle() {
    if (cell_.time_parts == 0 && numbers_ > 4) {
      for (int i = 3; i < std::min(numbers_, 6); ++i)
        if (!add_time({parts_[static_cast<std::size_t>(i)].value,
                       parts_[static_cast<std::size_t>(i)].digits}))
          return false;
      if (numbers_ == 7 && !add_fraction(parts_.back())) return false;
      numbers_ = 3;
    }
    const bool is_date = numbers_ == 3, is_time = cell_.time_parts > 1;
    const bool is_days = numbers_ == 1 && parts_before_time_ == 1;
    if (cell_.time_parts == 1 || !(is_date || (is_time && (numbers_ == 0 || is_days))))
      return false;
    cell_.date_parts = numbers_;
    std::copy_n(parts_.begin(), cell_.date.size(), cell_.date.begin());
    return true;
  }

  bool add_fraction(const DatePart& part) {
    if (part.digits == 0) return false;
    cell_.has_fraction = true;
    cell_.fraction_ns = part.value;
    for (int digits = part.digits; digits < kNanoDigits; ++digits) cell_.fraction_ns *= 10;
    return true;
  }

  const char* at_;
  const char* end_;
  ClockCell cell_;
  std::array<DatePart, 7> parts_{};
  int numbers_ = 0;  ///< of parts_
  int plain_digits_ = 0;
  int parts_before_time_ = 0;
  bool is_compact_ = false;           ///< the date has 8 digits
  bool is_behind_time_mark_ = false;  ///< the next number is a part of the time: 22h15
};

}  // namespace

std::optional<ClockCell> scan_clock_cell(std::string_view cell) {
  if (cell.size() > kMaxClockSize) return std::nullopt;
  return ClockScanner(cell).scan();
}

}  // namespace triax::lab
