// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/stability_api.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "lab/base/bad_input.hpp"
#include "src/domain/domain_options.hpp"
#include "src/element/material_report.hpp"
#include "src/page/api/json_body.hpp"
#include "src/probe/probe_json.hpp"
#include "src/probe/probe_request.hpp"
#include "src/study/domain/domain_json.hpp"
#include "src/study/domain/domain_report.hpp"
#include "src/study/domain/domain_run.hpp"
#include "src/study/progress.hpp"

namespace triax::src {
namespace {

using study::Json;

/// Of all states of a request: the response is about 16 MB.
constexpr int kMaxDirections = 36'000;

/// Only shipped sets: no file of this machine, no plug-in.
MaterialOptions material_of(const Json& body) {
  MaterialOptions material;
  material.name = text_in(body, "material");
  material.void_ratio = number_in(body, "void_ratio");
  return material;
}

/// "FROM:TO/COUNT"; empty where nothing is said, or only how many.
std::string range_of(const Json& body, const std::string& name, int count) {
  const auto from = number_in(body, (name + "_from_kPa").c_str());
  const auto to = number_in(body, (name + "_to_kPa").c_str());
  if (from.has_value() != to.has_value())
    throw Refused(400, name + "_from_kPa and " + name + "_to_kPa: give both or none");
  return from ? fmt::format("{}:{}/{}", *from, *to, count) : std::string();
}

int count_in(const Json& body, const char* key, int usual, int most) {
  const double count = number_in(body, key).value_or(usual);
  if (!(count >= 1) || !(count <= most))
    throw Refused(400, fmt::format("{}: expected a number from 1 to {}", key, most));
  return static_cast<int>(count);
}

/// Progress that ends the computation by an exception.
study::Progress until_stopped(const PageRequest& request, const std::atomic<bool>& ending) {
  return [&request, &ending](const std::string&, double) {
    if (ending) throw lab::WorkFailed("triax open was stopped during this computation");
    throw_if_cancelled(request);
  };
}

}  // namespace

PageAnswer list_of_materials() { return json_answer(materials_json(lab::shipped_materials())); }

PageAnswer probe(const PageRequest& request, const std::atomic<bool>& ending) {
  const Json asked = json_body(request.body);
  ProbeOptions o;
  o.material = material_of(asked);
  o.p_kPa = number_in(asked, "p_kPa");
  o.eta = numbers_in(asked, "eta");
  o.q_kPa = numbers_in(asked, "q_kPa");
  o.step_deg = number_in(asked, "step_deg");
  if (o.step_deg && *o.step_deg < 0.1) throw Refused(400, "step_deg: expected 0.1 or more");
  const double directions =
      360 / o.step_deg.value_or(1) * static_cast<double>(std::max(o.eta.size(), o.q_kPa.size()));
  if (directions > kMaxDirections)
    throw Refused(400, fmt::format("{:.0f} directions in total; expected at most {}: use fewer "
                                   "states or a larger step_deg",
                                   directions, kMaxDirections));
  return json_answer(
      probe_json(study::run_probe(probe_request(o), until_stopped(request, ending))));
}

PageAnswer domain(const PageRequest& request, const std::atomic<bool>& ending) {
  static std::mutex one_at_a_time;
  const Json asked = json_body(request.body);
  DomainOptions o;
  o.material = material_of(asked);
  const int columns = count_in(asked, "columns", 40, 200), rows = count_in(asked, "rows", 40, 200);
  o.directions = count_in(asked, "directions", 72, 720);
  o.p = range_of(asked, "p", columns);
  o.q = range_of(asked, "q", rows);
  const lab::MaterialSet material = chosen_material(o.material);
  study::DomainSettings::Grid grid = chosen_grid(o, material);
  grid.columns = columns;
  grid.rows = rows;
  const std::unique_lock lock(one_at_a_time, std::try_to_lock);
  if (!lock) throw Refused(503, "another domain is being computed; try again later");
  return json_answer(study::domain_json(
      study::run_domain({.material = material, .grid = grid, .threads = 1, .piece = 1, .pieces = 1},
                        until_stopped(request, ending))));
}

}  // namespace triax::src
