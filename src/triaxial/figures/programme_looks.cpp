// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/programme_looks.hpp"

#include <array>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

constexpr const char* kOther = "other";

struct Look {
  QCPScatterStyle::ScatterShape shape;
  QColor colour;
};

const Look& look(std::size_t number) {
  static const std::array<Look, 5> kLooks = {{{QCPScatterStyle::ssCircle, kBlue},
                                              {QCPScatterStyle::ssSquare, kGreen},
                                              {QCPScatterStyle::ssTriangle, kOrange},
                                              {QCPScatterStyle::ssDiamond, kPurple},
                                              {QCPScatterStyle::ssTriangleInverted, kInk}}};
  return kLooks.at(number % kLooks.size());
}

}  // namespace

ProgrammeLooks::ProgrammeLooks(const std::vector<std::string>& programmes) {
  for (const auto& name : programmes) numbers_.emplace(name.empty() ? kOther : name, 0);
  std::size_t next = 0;
  for (auto& [name, number] : numbers_) number = next++;
}

std::vector<std::string> ProgrammeLooks::names() const {
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers_) names.push_back(name);
  return names;
}

std::size_t ProgrammeLooks::number(const std::string& programme) const {
  return numbers_.at(programme.empty() ? kOther : programme);
}

QColor ProgrammeLooks::colour(const std::string& programme) const {
  return look(number(programme)).colour;
}

QCPScatterStyle ProgrammeLooks::marker(const std::string& programme, bool simulated) const {
  const Look& it = look(number(programme));
  return {it.shape, line(it.colour, 1.8), simulated ? QBrush(Qt::white) : QBrush(it.colour), 9};
}

}  // namespace triax::src
