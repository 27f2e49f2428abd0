// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/cells/clock_format.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

using namespace triax::lab;
using enum DateOrder;

namespace {
using Texts = std::vector<std::string>;

ClockFinding find_in(const Texts& texts, ClockHeading heading = ClockHeading::time,
                     std::optional<DateOrder> order = {}) {
  const std::vector<std::string_view> cells(texts.begin(), texts.end());
  return find_clock_format(cells, heading, order);
}

/// Seconds of the text by the format of the texts; -1 if it is no clock.
double seconds_in(const Texts& texts, const std::string& text,
                  ClockHeading heading = ClockHeading::time) {
  const auto found = find_in(texts, heading);
  if (!found.format) return -1;
  return clock_seconds(*found.format, text).value_or(-1);
}
double seconds_in(const std::string& text) { return seconds_in({text}, text); }

constexpr double kInstant = 1'773'124'224;  // date -u -d '2026-03-10 06:30:24' +%s

/// Parts of an instant, to write it in many ways.
struct Instant {
  explicit Instant(std::int64_t ms) : ms_since_1970(ms) {
    namespace ch = std::chrono;
    const ch::sys_time<ch::milliseconds> time{ch::milliseconds{ms}};
    const auto midnight = ch::floor<ch::days>(time);
    const ch::year_month_day date{midnight};
    year = static_cast<int>(date.year());
    month = static_cast<int>(static_cast<unsigned>(date.month()));
    day = static_cast<int>(static_cast<unsigned>(date.day()));
    const auto rest = (time - midnight).count();
    hour = static_cast<int>(rest / 3'600'000);
    minute = static_cast<int>(rest / 60'000 % 60);
    second = static_cast<int>(rest / 1'000 % 60);
    milli = static_cast<int>(rest % 1'000);
  }
  std::int64_t ms_since_1970;
  int year, month, day, hour, minute, second, milli;
};

/// A pattern with Y y M m D d (years, months and days of four, two or as few digits as possible),
/// N (name), H h (24 h), I i (12 h), T (minutes), S, F (milliseconds), P (AM, PM).
std::string written(const std::string& pattern, const Instant& at, const Texts& names,
                    const std::array<std::string, 2>& halves) {
  std::string out;
  const int half_hour = at.hour % 12 == 0 ? 12 : at.hour % 12;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      out += pattern[i];
      continue;
    }
    switch (pattern[++i]) {
      case 'Y':
        out += fmt::format("{:04}", at.year);
        break;
      case 'y':
        out += fmt::format("{:02}", at.year % 100);
        break;
      case 'M':
        out += fmt::format("{:02}", at.month);
        break;
      case 'm':
        out += fmt::format("{}", at.month);
        break;
      case 'N':
        out += names.at(static_cast<std::size_t>(at.month - 1));
        break;
      case 'D':
        out += fmt::format("{:02}", at.day);
        break;
      case 'd':
        out += fmt::format("{}", at.day);
        break;
      case 'H':
        out += fmt::format("{:02}", at.hour);
        break;
      case 'h':
        out += fmt::format("{}", at.hour);
        break;
      case 'I':
        out += fmt::format("{:02}", half_hour);
        break;
      case 'i':
        out += fmt::format("{}", half_hour);
        break;
      case 'T':
        out += fmt::format("{:02}", at.minute);
        break;
      case 'S':
        out += fmt::format("{:02}", at.second);
        break;
      case 'F':
        out += fmt::format("{:03}", at.milli);
        break;
      case 'P':
        out += halves.at(at.hour < 12 ? 0 : 1);
        break;
      default:
        FAIL("unknown letter in " + pattern);
    }
  }
  return out;
}

const Texts kEnglish{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
const std::vector<Texts> kMonths{
    kEnglish,
    {"January", "February", "March", "April", "May", "June", "July", "August", "September",
     "October", "November", "December"},
    {"Jan", "Feb", "Mär", "Apr", "Mai", "Jun", "Jul", "Aug", "Sep", "Okt", "Nov", "Dez"},
    {"janv.", "févr.", "mars", "avr.", "mai", "juin", "juil.", "août", "sept.", "oct.", "nov.",
     "déc."},
    {"ene", "feb", "mar", "abr", "may", "jun", "jul", "ago", "sep", "oct", "nov", "dic"},
    {"JAN", "FEV", "MAR", "ABR", "MAI", "JUN", "JUL", "AGO", "SET", "OUT", "NOV", "DEZ"},
    {"gen", "feb", "mar", "apr", "mag", "giu", "lug", "ago", "set", "ott", "nov", "dic"},
    {"jan", "feb", "mrt", "apr", "mei", "jun", "jul", "aug", "sep", "okt", "nov", "dec"},
    {"sty", "lut", "mar", "kwi", "maj", "cze", "lip", "sie", "wrz", "paź", "lis", "gru"},
    {"stycznia", "lutego", "marca", "kwietnia", "maja", "czerwca", "lipca", "sierpnia", "września",
     "października", "listopada", "grudnia"},
    {"Oca", "Şub", "Mar", "Nis", "May", "Haz", "Tem", "Ağu", "Eyl", "Eki", "Kas", "Ara"},
    {"янв", "фев", "мар", "апр", "мая", "июн", "июл", "авг", "сен", "окт", "ноя", "дек"},
    {"ЯНВАРЯ", "ФЕВРАЛЯ", "МАРТА", "АПРЕЛЯ", "МАЯ", "ИЮНЯ", "ИЮЛЯ", "АВГУСТА", "СЕНТЯБРЯ",
     "ОКТЯБРЯ", "НОЯБРЯ", "ДЕКАБРЯ"}};
const std::vector<std::array<std::string, 2>> kHalves{
    {"AM", "PM"}, {"am", "pm"},        {"a.m.", "p.m."}, {"a. m.", "p. m."},
    {"A", "P"},   {"vorm.", "nachm."}, {"上午", "下午"}, {"오전", "오후"}};

struct Way {
  std::string pattern;
  double digits_s;  ///< a unit of the last digit
};
const std::vector<Way> kWays{{"%Y-%M-%D %H:%T:%S", 1},
                             {"%Y-%M-%D %H:%T:%S.%F", 1e-3},
                             {"%Y-%M-%DT%H:%T:%S", 1},
                             {"%Y-%M-%DT%H:%T:%S.%FZ", 1e-3},
                             {"%Y-%M-%DT%H:%T:%S+00:00", 1},
                             {"%Y-%M-%D %H:%T:%S,%F", 1e-3},
                             {"%Y-%M-%D %H:%T", 60},
                             {"%Y/%M/%D %H:%T:%S", 1},
                             {"%Y/%m/%d %h:%T", 60},
                             {"%Y.%M.%D %H:%T:%S", 1},
                             {"%Y. %m. %d. %H:%T:%S", 1},
                             {"%Y年%m月%d日 %H:%T:%S", 1},
                             {"%Y年%m月%d日%h时%T分%S秒", 1},
                             {"%Y년 %m월 %d일 %h시 %T분 %S초", 1},
                             {"%Y%M%D %H%T%S", 1},
                             {"%Y%M%DT%H%T%SZ", 1},
                             {"%Y%M%D%H%T%S", 1},
                             {"%Y%M%D %H:%T:%S", 1},
                             {"%Y-%M-%D-%H-%T-%S", 1},
                             {"%Y_%M_%D_%H_%T_%S_%F", 1e-3},
                             {"%D.%M.%Y %H:%T:%S", 1},
                             {"%D.%M.%Y %H:%T", 60},
                             {"%D.%M.%Y, %H:%T:%S Uhr", 1},
                             {"%d.%m.%Y %h.%T.%S", 1},
                             {"%D.%M.%y %H:%T:%S", 1},
                             {"%D/%M/%Y %H:%T:%S", 1},
                             {"%D/%M/%Y %Hh%T", 60},
                             {"%D/%M/%Y %H:%T:%S:%F", 1e-3},
                             {"%D-%M-%Y %H:%T:%S", 1},
                             {"%d/%m/%Y  %h:%T:%S", 1},
                             {"%H:%T:%S %D/%M/%Y", 1},
                             {"%M/%D/%Y %H:%T:%S", 1},
                             {"%m/%d/%Y %h:%T", 60},
                             {"%m/%d/%Y %i:%T:%S %P", 1},
                             {"%M/%D/%y %I:%T:%S%P", 1},
                             {"%M/%D/%Y %P %I:%T:%S", 1},
                             {"%M-%D-%Y %H:%T:%S.%F", 1e-3},
                             {"%D-%N-%Y %H:%T:%S", 1},
                             {"%d %N %Y %H:%T:%S.%F", 1e-3},
                             {"%d. %N %Y %H:%T", 60},
                             {"%D-%N-%y %H:%T:%S", 1},
                             {"%D%N%Y %H:%T:%S", 1},
                             {"%N %d, %Y %i:%T:%S %P", 1},
                             {"%Y-%N-%D %H:%T:%S", 1},
                             {"%N %D %H:%T:%S %Y", 1},
                             {"%D/%M/%Y", 86'400},
                             {"%Y%M%D %H%T", 60},
                             {"%Y-%M-%D", 86'400}};
}  // namespace

TEST_CASE("find_clock_format: random instants are read back to the last digit", "[intake]") {
  std::mt19937_64 random(33);
  REQUIRE(kWays.size() >= 40);
  for (const Way& way : kWays)
    for (int trial = 0; trial < 12; ++trial) {
      const auto& names = kMonths.at(random() % kMonths.size());
      const auto& halves = kHalves.at(random() % kHalves.size());
      // 1990 to 2060; readings of ten minutes to a month, so that a number above 12 decides.
      auto ms = 631'152'000'000 + static_cast<std::int64_t>(random() % 2'209'032'000'000);
      const auto step = 600'000 + static_cast<std::int64_t>(random() % 86'400'000);
      Texts texts;
      std::vector<Instant> instants;
      for (int row = 0; row < 40; ++row, ms += step) {
        instants.emplace_back(ms);
        texts.push_back(written(way.pattern, instants.back(), names, halves));
      }
      const auto found = find_in(texts);
      INFO(way.pattern << ": " << texts.front() << ": " << found.evidence);
      REQUIRE(found.format);
      const auto first_day = instants.front().ms_since_1970 / 86'400'000;
      const bool is_decided = instants.back().ms_since_1970 / 86'400'000 - first_day > 14;
      if (is_decided) CHECK_FALSE(found.is_ambiguous);
      if (found.is_ambiguous) continue;
      const auto digits_ms = static_cast<std::int64_t>(way.digits_s * 1000);
      for (std::size_t row = 0; row < texts.size(); ++row) {
        INFO(texts[row]);
        const auto shown_ms = instants[row].ms_since_1970 / digits_ms * digits_ms;
        const auto seconds = clock_seconds(*found.format, texts[row]);
        REQUIRE(seconds);
        REQUIRE(std::llround(*seconds * 1000) == shown_ms);
      }
    }
}

TEST_CASE("clock_seconds: time zones and days count from 1970", "[intake]") {
  for (const char* text :
       {"2026-03-10 06:30:24", "2026-03-10T06:30:24Z", "2026-03-10T07:30:24+01:00",
        "2026-03-10T05:30:24 -0100", "10.03.2026 07:30:24 CET", "2026-03-10 06:30:24 UTC",
        "Tue Mar 10 06:30:24 2026", "Tue, 10 Mar 2026 06:30:24 GMT", "R8.3.10 06:30:24",
        "令和8年3月10日 06:30:24", "2026年3月10日(火) 06:30:24", "10 de marzo de 2026 06:30:24",
        "2026-03-10\xC2\xA0"
        "06:30:24",
        "10-MAR-26 06:30:24", "10/Mar/2026:07:30:24 +0100", "20260310063024"}) {
    INFO(text);
    CHECK(seconds_in(text) == kInstant);
  }
  CHECK(seconds_in("13:06:46.2639230999998221435") == Approx(47'206.2639231).epsilon(1e-15));
}

TEST_CASE("clock_seconds: times without a date count from midnight", "[intake]") {
  CHECK(seconds_in("06:30:24") == 23'424);
  CHECK(seconds_in("6:30") == 23'400);
  CHECK(seconds_in("23:59:59.5") == 86'399.5);
  CHECK(seconds_in("12:00:00 AM") == 0);
  CHECK(seconds_in("12:15 p.m.") == 43'200 + 900);
  CHECK(seconds_in("下午 3:05") == 15 * 3600 + 300);
  CHECK(seconds_in("26:15:00") == 94'500);
  CHECK(seconds_in("1.02:30:00") == 95'400);
  CHECK(seconds_in("1d 02:30") == 95'400);
  CHECK(seconds_in("1 day, 2:30:00") == 95'400);
  CHECK(seconds_in("0 days 00:00:10") == 10);
  CHECK(seconds_in("59:30.5") == 3'570.5);
  CHECK(seconds_in("90:30.5") == 5'430.5);
  CHECK(seconds_in("1h 30min 15s") == 5'415);
  CHECK(seconds_in("5 min 30 s") == 330);
}

TEST_CASE("clock_seconds: a cell in another format is refused", "[intake]") {
  const Texts day_first{"13.03.2026 10:00", "14.03.2026 10:00", "15.03.2026"};
  CHECK(seconds_in(day_first, "16.03.2026 00:00") == seconds_in(day_first, "16.03.2026"));
  for (const char* text :
       {"03.13.2026 10:00", "13/03/2026 10:00", "2026-03-13 10:00", "13.03.26 10:00",
        "13.03.2026 10:00 PM", "13.03.2026 10:00Z", "13. Mar 2026 10:00", "30.02.2026 10:00",
        "13.03.2026 25:00", "13.03.2026 10:60", "46090.5"}) {
    INFO(text);
    CHECK(seconds_in(day_first, text) == -1);
  }
  CHECK(seconds_in({"10:00", "11:00"}, "25:00") == -1);
}

TEST_CASE("find_clock_format: other texts and numbers are no clocks", "[intake]") {
  for (const char* text : {"12",
                           "12.5",
                           "1,5",
                           "45000.27",
                           "1773124224",
                           "20260310",
                           "12:60:00",
                           "12:30:99",
                           "a:b:c",
                           ":30",
                           "2026-02-30 06:30:24",
                           "-1:00:00",
                           "1:2:3:4:5",
                           "12:30:",
                           "kPa",
                           "10 kPa",
                           "0x10",
                           "2026-03",
                           "1/2",
                           "12:30 x",
                           "+",
                           "(",
                           "年",
                           "2026-03-10 06:30:24 +99:00",
                           "06:30:24 am pm",
                           "06:30:24 a a.m.\xE5\x88"}) {
    INFO(text);
    CHECK_FALSE(find_in({text}).format);
  }
  CHECK_FALSE(find_in({}).format);
  CHECK_FALSE(find_in({"", "-", "NaN"}).format);
  CHECK_FALSE(find_in({"06:30", "0.1", "0.2", "0.3"}).format);
  CHECK_FALSE(find_in({std::string(1'000'000, ':')}).format);
  CHECK_FALSE(find_in({std::string(1'000'000, '1')}).format);
  CHECK_FALSE(find_in({std::string("06:30\0", 6)}).format);
  CHECK(find_in({"06:30:00", "", "06:31:00", "broken"}).format);
}

TEST_CASE("find_clock_format: a number above 12 decides the order of the date", "[intake]") {
  const auto day = find_in({"01/03/2026 10:00", "13/03/2026 10:00"});
  CHECK(day.format->order == day_first);
  CHECK_FALSE(day.is_ambiguous);
  CHECK_THAT(day.evidence, Catch::Contains("day first, because '13/03/2026 10:00'"));
  const auto month = find_in({"03/01/2026 10:00", "03/13/2026 10:00"});
  CHECK(month.format->order == month_first);
  CHECK_FALSE(month.is_ambiguous);
}

TEST_CASE("find_clock_format: steps between the rows decide the order", "[intake]") {
  const auto found =
      find_in({"03/09/2026 22:00", "03/09/2026 23:00", "03/10/2026 00:00", "03/10/2026 01:00"});
  CHECK(found.format->order == month_first);
  CHECK_FALSE(found.is_ambiguous);
  CHECK_THAT(found.evidence,
             Catch::Contains("month first, because day first would make a step of 29 days"));
  const auto short_year = find_in({"26/03/09 23:00", "26/03/10 01:00"});
  CHECK(short_year.format->order == year_first);
  CHECK_FALSE(short_year.is_ambiguous);
}

TEST_CASE("find_clock_format: two orders that fit are reported as ambiguous", "[intake]") {
  for (const Texts& texts :
       {Texts{"03/09/2026 22:00", "03/09/2026 23:00"}, Texts{"03.09.2026", "03.09.2026"},
        Texts{"03-09-26 22:00", "03-09-26 23:00"}, Texts{"3/9/2026 10:00 PM", "3/9/2026 11:00 PM"},
        Texts{"26/03/09 10:00", "26/03/09 11:00"}, Texts{"01/03/2026", "01/04/2026", "01/05/2026"},
        Texts{"03/03/2026 10:00"}}) {
    const auto found = find_in(texts);
    INFO(texts.front() << " " << found.evidence);
    REQUIRE(found.format);
    if (texts.size() == 3) continue;  // days or months: the shorter steps decide
    CHECK(found.is_ambiguous);
    CHECK_THAT(found.evidence, Catch::Contains(" or "));
    CHECK(find_in(texts, ClockHeading::time, day_first).format->order == day_first);
    CHECK_FALSE(find_in(texts, ClockHeading::time, day_first).is_ambiguous);
  }
  CHECK(find_in({"3/9/2026 10:00 PM"}).format->order == month_first);
  CHECK(find_in({"03/09/2026 22:00"}).format->order == day_first);
  CHECK(find_in({"24:30", "25:30", "26:30"}).is_ambiguous);
  CHECK_FALSE(find_in({"2026-03-09 10:00"}).is_ambiguous);
  CHECK_FALSE(find_in({"9-Mar-26 10:00"}).is_ambiguous);
}

TEST_CASE("find_clock_format: an order that is given must fit", "[intake]") {
  CHECK_FALSE(find_in({"2026-03-10 06:00"}, ClockHeading::time, month_first).format);
  CHECK_FALSE(find_in({"13/03/2026 06:00"}, ClockHeading::time, month_first).format);
  CHECK(find_date_order("month first") == month_first);
  CHECK_FALSE(find_date_order("no date"));
}

TEST_CASE("find_clock_format: numbers are dates below such a heading", "[intake]") {
  const auto date = ClockHeading::date;
  CHECK(seconds_in({"20260310"}, "20260310", date) == kInstant - 23'424);
  CHECK(seconds_in({"46091.25"}, "46091.25", date) == kInstant - 23'424 + 21'600);
  CHECK(seconds_in({"46091,25"}, "46091,25", date) == kInstant - 23'424 + 21'600);
  CHECK(seconds_in({"740051.5"}, "740051.5", date) == kInstant - 23'424 + 43'200);
  CHECK(seconds_in({"2461109.5"}, "2461109.5", date) == kInstant - 23'424);
  CHECK(seconds_in({"1773124224"}, "1773124224", date) == kInstant);
  CHECK(seconds_in({"1773124224.5"}, "1773124224.5", date) == kInstant + 0.5);
  CHECK(seconds_in({"1773124224500"}, "1773124224500", date) == kInstant + 0.5);
  CHECK(seconds_in({"1773124224500000000"}, "1773124224500000000", date) == kInstant + 0.5);
  CHECK(seconds_in({"0.25"}, "0.25", ClockHeading::time_of_day) == 21'600);
  CHECK_FALSE(find_in({"12.5"}, date).format);
  CHECK_FALSE(find_in({"99999999999999999999999999"}, date).format);
}

TEST_CASE("find_clock_format: instants as numbers need no such heading", "[intake]") {
  CHECK(seconds_in({"1773124224", "1773124284"}, "1773124224", ClockHeading::time) == kInstant);
  CHECK(seconds_in({"1773124284500", "1773124224500"}, "1773124224500", ClockHeading::time) ==
        kInstant + 0.5);
  CHECK(seconds_in({"46091.25", "46091.251"}, "46091.25", ClockHeading::time) ==
        kInstant - 23'424 + 21'600);
  CHECK_FALSE(find_in({"46091", "46092", "46093"}).format);           // counts
  CHECK_FALSE(find_in({"46091.25", "46090.25", "46091.75"}).format);  // in no order
  CHECK_FALSE(find_in({"36091.25", "46091.25"}).format);              // within 27 years
  CHECK_FALSE(find_in({"46091.25", "46500.75"}).format);              // within 409.5 days
  CHECK_FALSE(find_in({"173124224", "173124284"}).format);            // in 1975
  CHECK_FALSE(find_in({"1773124224", "1773124284", "x"}).format);
}

namespace {
std::vector<double> times_of(const Texts& texts) {
  const auto found = find_in(texts);
  REQUIRE(found.format);
  Clock clock(*found.format);
  std::vector<double> out;
  for (const auto& text : texts) {
    const auto time = read_clock(*found.format, text);
    REQUIRE(time);
    out.push_back(clock.since_start(*time));
  }
  return out;
}
}  // namespace

TEST_CASE("Clock: a test begins at 0 and goes on past midnight", "[intake]") {
  using Times = std::vector<double>;
  CHECK(times_of({"23:59:00", "23:59:30", "00:00:10", "13:00:00", "00:00:00"}) ==
        Times{0, 30, 70, 46'860, 86'460});
  CHECK(times_of({"2019-02-11 23:59:00", "2019-02-12", "2019-02-12 00:01"}) == Times{0, 60, 120});
  CHECK(times_of({"2019-02-11 23:59:00", "23:59:30", "00:00:30"}) == Times{0, 30, 90});
  CHECK(times_of({"11:59:00 PM", "12:01:00 AM"}) == Times{0, 120});
  CHECK(times_of({"59:30.0", "00:30.0"}) == Times{0, 60});
  CHECK(times_of({"23:45:00", "24:00:00", "24:15:00"}) == Times{0, 900, 1800});
  CHECK(times_of({"23:59:59.9", "00:00:00.0", "00:00:00.1"}) == Times{0, 0.1, 0.2});
}

TEST_CASE("Clock: a clock that is set back goes back", "[intake]") {
  const auto times = times_of({"2026-10-25 02:59:00", "2026-10-25 02:00:00"});
  CHECK(times[1] == -59 * 60);
  CHECK(times_of({"02:59:00", "02:00:00"})[1] == -59 * 60);
  CHECK(times_of({"2026-10-25T02:59:00+02:00", "2026-10-25T02:00:00+01:00"})[1] == 60);
}

TEST_CASE("Clock: many midnights do not overflow", "[intake]") {
  ClockFormat format;
  format.has_time = true;
  Clock clock(format);
  const auto late = *read_clock(format, "23:59:59"), early = *read_clock(format, "00:00:00");
  double last = 0;
  for (int i = 0; i < 300'000; ++i) last = clock.since_start(i % 2 == 0 ? late : early);
  CHECK(std::fabs(last) < 1e10);
}
