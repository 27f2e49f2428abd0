// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/inp_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/inp_restriction.hpp"

namespace triax::lab {
namespace {

constexpr int kMostIncrements = 10'000'000;
constexpr double kMinPeriod = 1e-12;  // s
constexpr std::size_t kMostImported = 20'000;

/// A keyword that stands for a *LinearLoad with one number to read.
struct Shorthand {
  std::string_view keyword, frame;
  int driven;                     ///< component that takes the number; −1: none
  std::string_view stress_given;  ///< six characters, s where a stress is given, else e
};
constexpr std::array<Shorthand, 9> kShorthands{{{"*oedometrice1", "*cartesian", 0, "eeeeee"},
                                                {"*oedometrics1", "*cartesian", 0, "seeeee"},
                                                {"*triaxiale1", "*cartesian", 0, "esseee"},
                                                {"*triaxials1", "*cartesian", 0, "ssseee"},
                                                {"*triaxialueq", "*roscoe", 1, "eeeeee"},
                                                {"*triaxialuq", "*roscoe", 1, "eseeee"},
                                                {"*purerelaxation", "*cartesian", -1, "eeeeee"},
                                                {"*purecreep", "*cartesian", -1, "ssssss"},
                                                {"*undrainedcreep", "*roscoe", -1, "esssss"}}};

const std::vector<std::string> kKnown = {
    "*LinearLoad", "*CirculatingLoad", "*ImportFile",       "*OedometricE1", "*OedometricS1",
    "*TriaxialE1", "*TriaxialS1",      "*TriaxialUEq",      "*TriaxialUq",   "*PureRelaxation",
    "*PureCreep",  "*UndrainedCreep",  "*ObeyRestrictions", "*Repetition",   "*End"};

/// "increments iterations duration [: every]"
void read_commons(InpLines& lines, InpStep& step) {
  constexpr const char* kWhat = "number of increments, of iterations, and duration";
  const std::string line = lines.required(kWhat);
  const std::size_t colon = line.find(':');
  const auto words = inp_words(std::string_view(line).substr(0, colon));
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto value = i < words.size() ? fortran_number(words[i]) : std::nullopt;
    if (!value) lines.fail(fmt::format("{}: expected {}", excerpt(line), kWhat));
    values[i] = *value;
  }
  step.increments = lines.as_whole(values[0], "the number of increments", 1, kMostIncrements);
  step.duration = values[2];
  if (colon == std::string::npos) return;
  const auto every = inp_words(std::string_view(line).substr(colon + 1));
  const auto value = every.empty() ? std::nullopt : fortran_number(every[0]);
  if (!value) lines.fail(fmt::format("{}: expected a number after the colon", excerpt(line)));
  step.every = lines.as_whole(std::clamp(*value, 1.0, static_cast<double>(step.increments)),
                              "the number after the colon", 1, kMostIncrements);
}

InpFrame read_frame(InpLines& lines) {
  const std::string line = lines.required("a frame, *Cartesian or *Roscoe");
  if (auto frame = find_inp_frame(inp_before(line, "#!"))) return *frame;
  lines.fail(fmt::format("unknown frame {}; {}", excerpt(line),
                         suggestion(inp_before(line, "#!"),
                                    {"*Cartesian", "*Roscoe", "*RoscoeIsomorph", "*Rendulic"})));
}

void give(InpStep& step, const InpFrame& frame, int component, bool stress, double total) {
  const auto u = static_cast<std::size_t>(component);
  if (stress)
    step.conditions.stress.row(component) = frame.stress.row(component);
  else
    step.conditions.strain.row(component) = frame.strain.row(component);
  step.conditions.increment(component) = total;
  step.labels[u] = stress ? frame.stress_labels[u] : frame.strain_labels[u];
}

bool read_which(double value, const InpLines& lines) {
  return lines.as_whole(value, "1 for stress, 0 for strain", 0, 1) == 1;
}

void read_linear(InpLines& lines, InpStep& step) {
  const InpFrame frame = read_frame(lines);
  for (int i = 0; i < 6; ++i) {
    const auto values = lines.numbers(2, "1 for stress or 0 for strain, and the change");
    give(step, frame, i, read_which(values[0], lines), values[1]);
  }
}

void read_circulating(InpLines& lines, InpStep& step) {
  if (!(step.duration > kMinPeriod)) lines.fail("the duration is the period; must be above 0");
  const InpFrame frame = read_frame(lines);
  for (int i = 0; i < 6; ++i) {
    const auto values =
        lines.numbers(4, "1 for stress or 0 for strain, amplitude, phase (rad) and linear change");
    give(step, frame, i, read_which(values[0], lines), values[3]);
    step.amplitude(i) = values[1];
    step.phase(i) = values[2];
  }
  step.circulating = true;
  if (!step.end.empty()) lines.fail("an end condition of *CirculatingLoad is not supported");
}

void read_restrictions(InpLines& lines, InpStep& step) {
  for (int i = 0; i < 6; ++i) {
    const std::string line = lines.required("a restriction");
    read_inp_restriction(line, i, lines, step.conditions);
    step.labels[static_cast<std::size_t>(i)] = inp_before(line, "=!#");
  }
}

/// Rows of an imported file; what stands before the first line of numbers is a heading.
std::vector<std::vector<double>> read_imported(InpLines& table, std::size_t columns) {
  std::vector<std::vector<double>> rows;
  while (auto line = table.next()) {
    const auto words = inp_words(*line);
    if (rows.empty() && (words.empty() || !fortran_number(words[0]))) continue;
    std::vector<double> row;
    for (std::size_t i = 0; i < columns; ++i) {
      const auto value = i < words.size() ? fortran_number(words[i]) : std::nullopt;
      if (!value)
        table.fail(fmt::format("column {} is not a number; {} columns are read", i + 1, columns));
      row.push_back(*value);
    }
    rows.push_back(std::move(row));
    if (rows.size() > kMostImported) table.fail(fmt::format("more than {} rows", kMostImported));
  }
  if (rows.size() < 2) table.fail("at least two rows of numbers are needed");
  return rows;
}

void read_import(std::string_view rest, InpLines& lines, InpStep& step, const InpFile& file,
                 std::vector<std::string>& files) {
  const std::size_t bar = rest.find('|');
  const auto count =
      bar == std::string_view::npos ? std::vector<std::string>{} : inp_words(rest.substr(bar + 1));
  const auto columns = count.empty() ? std::nullopt : fortran_number(count[0]);
  if (!columns) lines.fail("*ImportFile: expected NAME | number of columns");
  const int column_count = lines.as_whole(*columns, "the number of columns", 1, 100);
  const std::string name(trimmed(rest.substr(0, bar)));
  if (name.empty()) lines.fail("*ImportFile: expected NAME | number of columns");
  if (!step.end.empty()) lines.fail("an end condition of *ImportFile is not supported");
  read_commons(lines, step);
  const InpFrame frame = read_frame(lines);
  std::array<int, 6> column{};
  std::array<double, 6> factor{};
  for (int i = 0; i < 6; ++i) {
    const auto u = static_cast<std::size_t>(i);
    const std::string line = lines.required("1 for stress or 0 for strain, and a column");
    const std::size_t star = line.find('*');
    const auto words = inp_words(std::string_view(line).substr(0, star));
    const auto which = !words.empty() ? fortran_number(words[0]) : std::nullopt;
    const auto place = words.size() > 1 ? fortran_number(words[1]) : std::nullopt;
    const auto scale_words = star == std::string::npos
                                 ? std::vector<std::string>{"1"}
                                 : inp_words(std::string_view(line).substr(star + 1));
    const auto scale = scale_words.empty() ? std::nullopt : fortran_number(scale_words[0]);
    if (!which || !place || !scale)
      lines.fail(fmt::format(
          "{}: expected 1 for stress or 0 for strain, a column and optionally * a factor",
          excerpt(line)));
    give(step, frame, i, read_which(*which, lines), 0);
    column[u] = lines.as_whole(*place, "the column", 0, column_count);
    factor[u] = *scale;
  }
  if (step.duration <= 0) lines.required("the column of time");
  files.push_back(name);
  InpLines table(file(name), name);
  const auto rows = read_imported(table, static_cast<std::size_t>(column_count));
  const std::size_t used = std::min(rows.size(), static_cast<std::size_t>(step.increments) + 1);
  for (std::size_t r = 1; r < used; ++r) {
    sim::Vector<sim::Tensor> change = sim::Vector<sim::Tensor>::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
      if (column[i] == 0) continue;
      const auto c = static_cast<std::size_t>(column[i] - 1);
      change(static_cast<Eigen::Index>(i)) = factor[i] * (rows[r][c] - rows[r - 1][c]);
    }
    step.imported.push_back(change);
  }
}

bool read_shorthand(const std::string& keyword, InpLines& lines, InpStep& step,
                    std::vector<std::string>& warnings) {
  const auto* found = std::ranges::find(kShorthands, keyword, &Shorthand::keyword);
  if (found == kShorthands.end()) return false;
  const InpFrame frame = *find_inp_frame(found->frame);
  read_commons(lines, step);
  const double total = found->driven < 0 ? 0 : lines.numbers(1, "the change")[0];
  for (int i = 0; i < 6; ++i)
    give(step, frame, i, found->stress_given[static_cast<std::size_t>(i)] == 's',
         i == found->driven ? total : 0);
  if (found->driven < 0)
    warnings.push_back(
        fmt::format("{}:{}: {} needs a law with viscosity; the laws of triax do not depend on "
                    "time, so the state does not change",
                    lines.name(), lines.line_number(), step.keyword));
  return true;
}

}  // namespace

InpStep read_inp_step(const std::string& keyword_line, InpLines& lines, const InpFile& file,
                      std::vector<std::string>& files, std::vector<std::string>& warnings) {
  InpStep step;
  step.labels.resize(6);
  const std::string line = inp_before(keyword_line, "#!");
  const std::size_t question = line.find('?');
  step.keyword = std::string(trimmed(std::string_view(line).substr(0, question)));
  const std::string keyword = folded(step.keyword);
  if (question != std::string::npos)
    step.end.push_back(read_inp_end(std::string_view(line).substr(question + 1), lines, warnings));
  constexpr std::string_view kImport = "*importfile";
  if (read_shorthand(keyword, lines, step, warnings)) return step;
  if (keyword.starts_with(kImport)) {
    const std::string rest = step.keyword.substr(kImport.size());
    step.keyword.resize(kImport.size());
    read_import(rest, lines, step, file, files);
  } else if (keyword == "*linearload") {
    read_commons(lines, step);
    read_linear(lines, step);
  } else if (keyword == "*circulatingload") {
    read_commons(lines, step);
    read_circulating(lines, step);
  } else if (keyword == "*obeyrestrictions") {
    read_commons(lines, step);
    read_restrictions(lines, step);
  } else if (keyword == "*deformationgradient") {
    lines.fail(
        "*DeformationGradient is not supported: a rotation of the specimen is not a set of linear "
        "conditions");
  } else if (keyword == "*perturbationss" || keyword == "*perturbationse") {
    lines.fail(fmt::format(
        "{} is not supported: it reverses every increment, which is a probe, not a path",
        step.keyword));
  } else {
    lines.fail(fmt::format("unknown keyword of a step {}; {}", excerpt(step.keyword),
                           suggestion(step.keyword, kKnown)));
  }
  return step;
}

}  // namespace triax::lab
