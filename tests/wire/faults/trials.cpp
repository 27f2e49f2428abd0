// SPDX-License-Identifier: GPL-3.0-or-later
// Every instrument and protocol times every fault and length, at instants by strides, and pairs of
// them by strides.
#include <fmt/format.h>

#include <utility>

#include "tests/wire/faults/trial.hpp"

namespace triax::lab::test {
namespace {

struct Kind {
  std::string name;
  std::vector<std::string> on, off;
  std::vector<std::string> causes;
  bool modbus_only = false, scanner_only = false;
  double shortest_s = 0;
  bool cuts = true;
  std::string not_taken_with = {};
};

Kind line_kind(const std::string& name, const std::string& word, std::vector<std::string> causes) {
  return {.name = name,
          .on = {"LINE:FAULT \"{}\"," + word},
          .off = {"LINE:FAULT \"{}\",NONE"},
          .causes = std::move(causes)};
}

std::vector<Kind> all_kinds() {
  const std::string late = "no response", wrongly = "invalid response",
                    down = "the connection is down", unreached = "cannot be reached";
  std::vector<Kind> kinds{
      line_kind("silent", "SILENT", {late}),
      line_kind("slow, just in time", "SLOW,0.2", {}),
      line_kind("slow, just too late", "SLOW,0.36", {late}),
      line_kind("half a frame", "HALF", {late, wrongly, "without its end"}),
      line_kind("garbage", "GARBAGE", {late, wrongly, down}),
      line_kind("reset", "RESET", {down}),
      line_kind("cable out", "REFUSE", {down, unreached}),
  };
  kinds[1].cuts = false;
  for (const auto& [name, word] : {std::pair{"wrong unit", "UNIT"}, {"wrong transaction", "CHECK"}})
    kinds.push_back({.name = name,
                     .on = {std::string("LINE:FRAM \"{}\",") + word},
                     .off = {"LINE:FRAM \"{}\",NONE"},
                     .causes = {late, wrongly, down},
                     .modbus_only = true});
  // The cable is changed: out, and in again at another instrument a moment later.
  for (const auto& [name, word, told] : {std::tuple{"another make", "ON", "the identity is"},
                                         {"another of its make", "TWIN", "another identity"}})
    kinds.push_back({.name = name,
                     .on = {std::string("LINE:PRET \"{}\",") + word, "LINE:FAULT \"{}\",REFUSE",
                            "+0.1", "LINE:FAULT \"{}\",NONE"},
                     .off = {"LINE:PRET \"{}\",OFF"},
                     .causes = {told},
                     .shortest_s = 2,
                     .not_taken_with = told});
  // Readings are taken all the same; that the clock is wrong is told.
  for (const auto& [name, word, told] : {std::tuple{"its clock jumps", "1,7", "jumped by +7.0 s"},
                                         {"its clock jumps back", "1,-7", "jumped by -7.0 s"},
                                         {"its clock drifts", "2,0", "runs fast"}})
    kinds.push_back({.name = name,
                     .on = {std::string("LINE:CLOC \"{}\",") + word},
                     .off = {"LINE:CLOC \"{}\",1,0"},
                     .causes = {told},
                     .scanner_only = true,
                     .shortest_s = 2,
                     .cuts = false});
  return kinds;
}

std::vector<std::string> of(std::vector<std::string> commands, const std::string& instrument) {
  for (std::string& one : commands)
    if (const auto at = one.find("{}"); at != std::string::npos) one.replace(at, 2, instrument);
  return commands;
}

Wrong wrong_of(const Kind& kind, const std::string& instrument, double from_s, double for_s) {
  return {.kind = kind.name,
          .instrument = instrument,
          .on = of(kind.on, instrument),
          .off = of(kind.off, instrument),
          .from_s = from_s,
          .for_s = for_s,
          .causes = kind.causes,
          .cuts = kind.cuts,
          .not_taken_with = kind.not_taken_with};
}

/// Instants from 0.7 s to 1.7 s that never come round together with ticks.
double start_of(int stride) { return 0.7 + (stride * 0.137 - static_cast<int>(stride * 0.137)); }

}  // namespace

std::vector<TrialPlan> all_trials() {
  std::vector<Wrong> tcp, modbus;
  int stride = 0;
  for (const Kind& kind : all_kinds())
    for (const char* const instrument : {"scanner", "frame", "cell", "back"})
      for (const double for_s : {0.4, 2.0, 5.0}) {
        if (for_s < kind.shortest_s) continue;
        if (kind.scanner_only && std::string(instrument) != "scanner") continue;
        if (!kind.modbus_only) tcp.push_back(wrong_of(kind, instrument, start_of(++stride), for_s));
        if (std::string(instrument) != "scanner" || kind.scanner_only)
          modbus.push_back(wrong_of(kind, instrument, start_of(++stride), for_s));
      }
  std::vector<TrialPlan> all;
  const auto add = [&all](bool by_modbus, std::vector<Wrong> wrongs) {
    all.push_back(
        {.number = static_cast<int>(all.size()), .modbus = by_modbus, .wrongs = std::move(wrongs)});
  };
  for (const bool by_modbus : {false, true})
    for (const char* const instrument : {"frame", "back"}) {
      Wrong minute =
          wrong_of(line_kind("cable out", "REFUSE", {"the connection is down", "cannot be"}),
                   instrument, 1, 60);
      add(by_modbus, {minute});
    }
  // A long deadline is no excuse for getting safe late.
  for (const bool by_modbus : {false, true})
    for (const char* const instrument : {"scanner", "frame", "cell", "back"}) {
      // What the scanner reads of the Modbus rig is not needed.
      if (by_modbus && std::string(instrument) == "scanner") continue;
      const Wrong silent = wrong_of(line_kind("silent", "SILENT", {"no response"}), instrument,
                                    start_of(++stride), 5);
      add(by_modbus, {silent});
      all.back().deadline_s = 2;
    }
  // Each alone, at two instants.
  for (int turn = 0; turn < 2; ++turn)
    for (const bool by_modbus : {false, true})
      for (Wrong one : by_modbus ? modbus : tcp) {
        one.from_s = start_of(++stride);
        add(by_modbus, {one});
      }
  // The same by serial lines, where no connection ends: what cuts is silence there.
  for (Wrong one : modbus) {
    if (one.kind.starts_with("another") || one.kind.starts_with("its clock")) continue;
    if (one.kind == "reset" || one.kind == "cable out")
      one.causes = {"no response", "invalid response"};
    // Questions go one after the other on such a line.
    for (std::string& command : one.on) {
      if (command.ends_with("SLOW,0.2")) command.replace(command.size() - 3, 3, "0.1");
      if (command.ends_with("SLOW,0.36")) command.replace(command.size() - 4, 4, "1.1");
    }
    one.from_s = start_of(++stride);
    add(true, {one});
    all.back().serial = true;
    all.back().deadline_s = 1;
  }
  // Pairs on two instruments.
  for (const bool by_modbus : {false, true}) {
    const std::vector<Wrong>& of_it = by_modbus ? modbus : tcp;
    for (std::size_t step = 7, made = 0; made < 330; step += 10)
      for (std::size_t i = 0; i < of_it.size() && made < 330; ++i) {
        Wrong first = of_it[i], second = of_it[(i + step) % of_it.size()];
        if (first.instrument == second.instrument) continue;
        first.from_s = start_of(++stride);
        second.from_s = start_of(++stride);
        add(by_modbus, {first, second});
        ++made;
      }
  }
  return all;
}

}  // namespace triax::lab::test
