#include "src/cli/shared_options.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <cmath>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::src {

void add_db(CLI::App& app, std::string& path) {
  app.add_option("--db", path, "database of tests")->type_name("FILE")->capture_default_str();
}

void add_json(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "print one JSON document on standard output, nothing else");
}

void add_speed(CLI::App& app, double& speed) {
  app.add_option_function<std::string>(
         "--speed",
         [&speed](const std::string& text) {
           if (text == "max") return;
           char* end = nullptr;
           speed = std::strtod(text.c_str(), &end);
           if (*end != '\0' || !(speed > 0) || !std::isfinite(speed))
             throw CLI::ValidationError(
                 "--speed",
                 fmt::format("'{}' is neither max nor a positive number of seconds of the "
                             "test per second of the clock",
                             text));
         },
         "pace: as fast as possible, or N times the clock; results do not depend on it [max]")
      ->type_name("max|N");
}

std::vector<std::pair<std::string, std::string>> key_values(const std::vector<std::string>& sets,
                                                            const std::string& example) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const auto& set : sets) {
    const auto equals = set.find('=');
    if (equals == std::string::npos || equals == 0)
      throw lab::BadInput(fmt::format("--set {}: KEY=VALUE is wanted, as in {}", set, example));
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
        fmt::format("--piece {}: I/N with I from 1 to N is wanted, as in 3/8", lab::excerpt(text)));
  return {*index, *count};
}

}  // namespace triax::src
