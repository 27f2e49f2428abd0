// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/study/row_json.hpp"

namespace triax::study {
namespace {

/// Places of the readings of a span: [first, second).
std::pair<std::size_t, std::size_t> places_of(const std::vector<std::int64_t>& readings,
                                              std::int64_t from, std::int64_t to) {
  const auto begin = std::ranges::lower_bound(readings, from);
  const auto end = std::upper_bound(begin, readings.end(), std::max(from, to));
  return {static_cast<std::size_t>(begin - readings.begin()),
          static_cast<std::size_t>(end - readings.begin())};
}

bool is_drawn(std::size_t column) {
  const auto& name = db::read_columns()[column].name;
  return name != "time_s" && name != "stage";
}

void in_order_once(std::vector<std::size_t>& places) {
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

void all_between(std::size_t begin, std::size_t end, std::vector<std::size_t>& places) {
  places.resize(end - begin);
  for (std::size_t i = begin; i < end; ++i) places[i - begin] = i;
}

/// Both readings of an unread step, and the first of a faulty sensor: a line must end there.
void add_ends_of_breaks(const TestColumns& test, std::size_t begin, std::size_t end,
                        std::vector<std::size_t>& rows) {
  const auto add = [&](std::int64_t reading, std::size_t before) {
    const auto found = std::ranges::lower_bound(test.readings(), reading);
    const auto at = static_cast<std::size_t>(found - test.readings().begin());
    for (std::size_t i = at - std::min(at, before); i <= at; ++i)
      if (begin <= i && i < end) rows.push_back(i);
  };
  for (const std::int64_t reading : test.unread_steps()) add(reading, 1);
  for (const TestColumns::Fault& fault : test.faults()) add(fault.span.from, 0);
}

/// What of the window no line may cross as if it was measured.
void append_breaks(const TestColumns& test, std::string& json) {
  append_list(
      ",\"unread_steps\":", test.unread_steps().size(),
      [&](std::size_t i) { return static_cast<double>(test.unread_steps()[i]); }, json);
  json += ",\"faults\":[";
  for (const auto& [span, columns] : test.faults()) {
    if (json.back() != '[') json += ',';
    json += R"({"channel":")" + lab::heading(span.channel) + R"(","from":)" +
            std::to_string(span.from) + R"(,"to":)" +
            (span.lasts ? "null" : std::to_string(span.until)) + R"(,"columns":[)";
    for (const std::size_t column : columns) {
      if (json.back() != '[') json += ',';
      json += '"' + db::read_columns()[column].name + '"';
    }
    json += "]}";
  }
  json += ']';
}

void choose_rows(const TestColumns& test, const WindowAsked& asked, Window& chosen) {
  const auto [begin, end] = places_of(test.readings(), asked.from, asked.to);
  chosen.count = static_cast<std::int64_t>(end - begin);
  std::vector<std::size_t> drawn;
  std::ranges::copy_if(asked.columns, std::back_inserter(drawn), is_drawn);
  if (end - begin <= 2 * std::max<std::size_t>(drawn.size(), 1) * asked.pixels)
    return all_between(begin, end, chosen.rows);
  chosen.exact = false;
  chosen.rows = {begin, end - 1};
  for (const std::size_t column : drawn)
    keep_extremes(test.column(column), begin, end, asked.pixels, chosen.rows);
  add_ends_of_breaks(test, begin, end, chosen.rows);
  in_order_once(chosen.rows);
}

void choose_work(const TestColumns& test, const WindowAsked& asked, Window& chosen) {
  const auto& points = test.work();
  const auto first =
      std::ranges::lower_bound(points, asked.from, {}, &lab::SecondOrderWorkPoint::reading);
  const auto behind =
      std::ranges::upper_bound(points, asked.to, {}, &lab::SecondOrderWorkPoint::reading);
  const auto begin = static_cast<std::size_t>(first - points.begin());
  const auto end = std::max(begin, static_cast<std::size_t>(behind - points.begin()));
  if (end - begin <= 2 * asked.pixels) return all_between(begin, end, chosen.work);
  chosen.work_exact = false;
  std::vector<double> normalised(points.size());
  for (std::size_t i = begin; i < end; ++i) normalised[i] = points[i].work.normalised;
  chosen.work = {begin, end - 1};
  keep_extremes(normalised, begin, end, asked.pixels, chosen.work);
  in_order_once(chosen.work);
}

void append_work(const TestColumns& test, const Window& chosen, std::string& json) {
  const auto& points = test.work();
  json += R"(,"work":{"exact":)";
  json += chosen.work_exact ? "true" : "false";
  const auto list = [&](const char* name, const auto& value_of) {
    append_list(
        name, chosen.work.size(), [&](std::size_t i) { return value_of(points[chosen.work[i]]); },
        json);
  };
  list(",\"reading\":", [](const auto& p) { return static_cast<double>(p.reading); });
  list(",\"time_s\":", [](const auto& p) { return p.time_s; });
  list(",\"normalised\":", [](const auto& p) { return p.work.normalised; });
  list(",\"error\":", [](const auto& p) { return p.normalised_error; });
  json += '}';
}

}  // namespace

void keep_extremes(std::span<const double> values, std::size_t begin, std::size_t end,
                   std::size_t buckets, std::vector<std::size_t>& kept) {
  const std::size_t count = end - begin;
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    const std::size_t first = begin + count * bucket / buckets;
    const std::size_t behind = begin + count * (bucket + 1) / buckets;
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    std::size_t low = behind, high = behind;
    for (std::size_t i = first; i < behind; ++i) {
      if (values[i] < least) least = values[low = i];
      if (values[i] > largest) largest = values[high = i];
    }
    if (low != behind) kept.push_back(low);
    if (high != behind) kept.push_back(high);
  }
}

Window window(const TestColumns& test, const WindowAsked& asked) {
  Window chosen;
  choose_rows(test, asked, chosen);
  if (asked.work) choose_work(test, asked, chosen);
  return chosen;
}

std::string window_json(const TestColumns& test, const WindowAsked& asked) {
  const Window chosen = window(test, asked);
  std::string json =
      "{\"test\":" + std::to_string(test.test()) + ",\"from\":" + std::to_string(asked.from) +
      ",\"to\":" + std::to_string(asked.to) + ",\"count\":" + std::to_string(chosen.count) +
      ",\"last\":" + (test.readings().empty() ? "null" : std::to_string(test.readings().back())) +
      ",\"exact\":" + (chosen.exact ? "true" : "false") + ",\"columns\":{";
  json.reserve(json.size() + chosen.rows.size() * asked.columns.size() * 12);
  append_list(
      "\"reading\":", chosen.rows.size(),
      [&](std::size_t i) { return static_cast<double>(test.readings()[chosen.rows[i]]); }, json);
  for (const std::size_t column : asked.columns) {
    const auto& values = test.column(column);
    append_list(
        ",\"" + db::read_columns()[column].name + "\":", chosen.rows.size(),
        [&](std::size_t i) { return values[chosen.rows[i]]; }, json);
  }
  json += '}';
  append_breaks(test, json);
  if (asked.work) append_work(test, chosen, json);
  return json + '}';
}

}  // namespace triax::study
