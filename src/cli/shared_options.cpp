// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/shared_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/Config.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <thread>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::src {

void add_db(CLI::App& app, std::string& path) {
  app.add_option("--db", path, "database of tests")->type_name("FILE")->capture_default_str();
}

namespace {

void add_format_of(CLI::App& app, const std::vector<std::string>& formats,
                   const std::function<void(const std::string&)>& chosen) {
  const CLI::Option* format =
      app.add_option_function<std::string>("--format", chosen,
                                           fmt::format("output format [{}]", formats.front()))
          ->check(CLI::IsMember(formats).description(""))
          ->type_name(fmt::format("{}", fmt::join(formats, "|")));
  app.add_flag_callback(
      "--json",
      [format, chosen] {
        if (format->count() > 0 && format->as<std::string>() != "json")
          throw CLI::ValidationError("--json", fmt::format("excludes --format {}; give one of them",
                                                           format->as<std::string>()));
        chosen("json");
      },
      "same as --format json");
}

}  // namespace

void add_format(CLI::App& app, std::string& format, const std::vector<std::string>& formats) {
  format = formats.front();
  add_format_of(app, formats, [&format](const std::string& chosen) { format = chosen; });
}

void add_json(CLI::App& app, bool& json) {
  add_format_of(app, {"text", "json"},
                [&json](const std::string& chosen) { json = chosen == "json"; });
}

void add_live(CLI::App& app, bool& live) {
  app.add_flag("--live", live,
               "print what was reported during the test, and when, instead of the result");
}

void add_earlier(CLI::App& app, std::vector<std::string>& tests) {
  app.add_option("--earlier", tests,
                 "stored test on the same sand at a similar density, used to improve the onset "
                 "forecast (repeatable)")
      ->type_name("TEST")
      ->allow_extra_args(false);
}

void add_jobs(CLI::App& app, int& jobs, const std::string& what, int most) {
  app.add_option("--jobs", jobs, what + " [all cores]")
      ->check(CLI::Range(1, most).description(""))
      ->type_name("N");
}

int chosen_jobs(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void add_speed(CLI::App& app, double& speed) {
  app.add_option_function<std::string>(
         "--speed",
         [&speed](const std::string& text) {
           if (text == "max") return;
           speed = lab::whole_text_as<double>(text).value_or(0);
           if (!(speed > 0) || !std::isfinite(speed))
             throw CLI::ValidationError(
                 "--speed",
                 fmt::format("'{}' is not valid; expected max, or a factor of real time, as in 60",
                             text));
         },
         "pace: max, or N times real time, without effect on the results [max]")
      ->type_name("max|N");
}

std::vector<std::pair<std::string, std::string>> key_values(const std::vector<std::string>& sets,
                                                            const std::string& example) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& set : sets) {
    const auto equals = set.find('=');
    if (equals == std::string::npos || equals == 0)
      throw lab::BadInput(fmt::format("--set {}: expected KEY=VALUE, as in {}", set, example));
    pairs.emplace_back(set.substr(0, equals), set.substr(equals + 1));
  }
  return pairs;
}

Piece piece_of(const std::string& text) {
  if (text.empty()) return {};
  const auto slash = text.find('/');
  const auto index = lab::whole_text_as<int>(text.substr(0, slash));
  const auto count =
      slash == std::string::npos ? std::nullopt : lab::whole_text_as<int>(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count)
    throw lab::BadInput(
        fmt::format("--piece {}: expected I/N with I from 1 to N, as in 3/8", lab::excerpt(text)));
  return {*index, *count};
}

}  // namespace triax::src
