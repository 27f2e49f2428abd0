// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/grains/figures/grain_rose_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lab/grains/grain_words.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "src/plot/angle_axis.hpp"
#include "src/plot/axes.hpp"
#include "src/plot/energy_axis.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/probe/figures/response_envelope.hpp"
#include "src/study/grains/grain_rose_findings.hpp"

namespace triax::src {
namespace {

constexpr int kGrainRoseWidth = 1000, kGrainRoseHeight = 450 + kOriginHeight;
constexpr double kStepDeg = 60;  // between the numbers of an axis half as wide as the plot

using Probes = std::vector<sim::GrainProbe>;
using Value = double (*)(const sim::GrainProbe&);

Probes made(const sim::ProbeRose& rose) {
  Probes probes;
  std::ranges::copy_if(rose.probes, std::back_inserter(probes),
                       [](const auto& probe) { return !probe.stopped; });
  return probes;
}

/// Degrees from one probe to the next, the last to the first.
double gap_after(const Probes& probes, std::size_t i) {
  const double next = i + 1 < probes.size() ? sim::degrees(probes[i + 1].angle)
                                            : sim::degrees(probes.front().angle) + kTurnDeg;
  return next - sim::degrees(probes[i].angle);
}

double step_of(const Probes& probes) {
  double least = kTurnDeg;
  for (std::size_t i = 0; i < probes.size(); ++i) least = std::min(least, gap_after(probes, i));
  return least;
}

/// A gap where directions were not probed, or (not finite) have no value. The first one stands at
/// the end again, a turn later.
Points over_angle(const Probes& probes, Value value) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  const double widest = 1.5 * step_of(probes);
  Points points;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    points.emplace_back(sim::degrees(probes[i].angle), value(probes[i]));
    if (gap_after(probes, i) > widest)
      points.emplace_back(kGap, kGap);
    else if (i + 1 == probes.size())
      points.emplace_back(points.front().x() + kTurnDeg, points.front().y());
  }
  return points;
}

struct Series {
  const char* name;
  Value value;
  QPen pen;
  bool marked = false;
};

QCPScatterStyle ring(const QPen& pen) {
  return {QCPScatterStyle::ssCircle, line(pen.color(), 1.4), QBrush(Qt::white), 5};
}

void name_series(QCPAxisRect& rect, const std::vector<Series>& all) {
  for (const auto& one : all) {
    auto* curve = draw_curve(rect, {}, one.pen, one.name);
    if (one.marked) curve->setScatterStyle(ring(one.pen));
  }
}

void draw_series(QCPAxisRect& rect, const Probes& probes, const std::vector<Series>& all) {
  for (const auto& one : all) {
    auto* curve = draw_curve(rect, over_angle(probes, one.value), one.pen);
    if (one.marked) curve->setScatterStyle(ring(one.pen));
  }
}

QCPRange range_of(const Probes& probes, const std::vector<Series>& all) {
  RangeOf range;
  range.add(0);
  for (const auto& one : all)
    for (const auto& probe : probes) range.add(one.value(probe));
  return range.with_margin(0.06, true);
}

void shade(QCPAxisRect& rect, const Probes& probes, const std::vector<study::AngleRange>& ranges,
           const QColor& colour) {
  const double half = step_of(probes) / 2;
  for (const auto& [from, to, directions] : ranges) {
    const bool all = directions == static_cast<int>(probes.size()) && half * 2 * directions > 359;
    shade_directions(rect, all ? 0 : sim::degrees(from) - half,
                     all ? kTurnDeg : sim::degrees(to) + half, colour);
  }
}

void name_shade(QCPAxisRect& rect, const QColor& colour, const std::string& name) {
  QColor light = colour;
  light.setAlpha(45);
  draw_area(rect, {}, light, Qt::NoPen, name);
}

struct Panels {
  OwnPlot plot;
  QCPAxisRect *left, *right;
};

Panels two_panels(const Subject& subject, const std::string& left_title,
                  const std::string& right_title) {
  Panels panels{make_plot(kGrainRoseWidth, kGrainRoseHeight), nullptr, nullptr};
  panels.left = panels.plot->axisRect();
  panels.right = &add_axes_beside(*panels.plot);
  constexpr auto kPlane = sim::ProbePlane::axisymmetric;
  style_angle_axes(*panels.left, kPlane, subject.kind, left_title, kStepDeg);
  style_angle_axes(*panels.right, kPlane, subject.kind, right_title, kStepDeg);
  return panels;
}

/// Of a probe at rest: one that runs away would leave no room for the others.
template <class Work>
double at_rest(const sim::GrainProbe& probe, const Work& work) {
  return probe.at_rest ? work(probe.work) : std::numeric_limits<double>::quiet_NaN();
}
double kinetic(const sim::GrainProbe& p) { return p.most_kinetic_j; }

std::string not_at_rest_words(const Probes& probes) {
  const auto count = std::ranges::count(probes, false, &sim::GrainProbe::at_rest);
  return count > 0
             ? fmt::format(" {} of {} probes did not reach equilibrium.", count, probes.size())
             : std::string();
}

}  // namespace

Drawing grain_envelope_figure(const sim::ProbeRose& rose, double norm, const Subject& subject) {
  const Probes probes = made(rose);
  Drawing drawing = response_envelope(study::circle_of(rose, subject.kind, norm), norm, subject);
  if (drawing.plot && !not_at_rest_words(probes).empty())
    drawing.caption += not_at_rest_words(probes) + " They are not used.";
  return drawing;
}

Drawing grain_work_figure(const sim::ProbeRose& rose, const Subject& subject) {
  const Probes probes = made(rose);
  if (probes.empty()) return {};
  const study::GrainRoseFindings found = study::rose_findings(rose);
  const std::vector<Series> macro = {
      {"semi-Lagrangian (7)",
       [](const auto& p) { return at_rest(p, [](auto& w) { return w.lagrangian; }); },
       line(kBlue, 1.8), true},
      {"Eulerian (10)",
       [](const auto& p) { return at_rest(p, [](auto& w) { return w.eulerian(); }); },
       line(kVermilion, 1.6, Qt::DashLine)},
      {"Δσ : LΔt", [](const auto& p) { return at_rest(p, [](auto& w) { return w.stress_part; }); },
       line(kGreen, 1.6, Qt::DotLine)},
      {"div(Δu) σ : LΔt",
       [](const auto& p) { return at_rest(p, [](auto& w) { return w.volume_part; }); },
       line(kPurple, 1.6, Qt::DashDotLine)},
      {"−σ Lᵗ Δt : LΔt",
       [](const auto& p) { return at_rest(p, [](auto& w) { return w.transport_part; }); },
       line(kOrange, 1.6, Qt::DashDotDotLine)}};
  const std::vector<Series> micro = {
      macro.front(),
      {"microscopic (11)",
       [](const auto& p) { return at_rest(p, [](auto& w) { return w.microscopic(); }); },
       line(kInk, 1.6, Qt::DashLine), true},
      {"(7) + turning of grains and contacts",
       [](const auto& p) {
         return at_rest(p, [](auto& w) { return w.microscopic() - w.gap_left(); });
       },
       line(kOrange, 1.6, Qt::DotLine)}};
  auto [plot, left, right] = two_panels(subject, "density of second-order work (J/m³)",
                                        "density of second-order work (J/m³)");
  name_series(*left, macro);
  name_series(*right, {micro[1], micro[2]});
  if (!found.negative.empty()) name_shade(*left, kVermilion, "W₂ < 0");
  if (!found.agreeing.empty())
    name_shade(*right, kGreen, fmt::format("micro = macro within {:g} %", 100 * study::kAgreement));
  if (!found.not_at_rest.empty()) name_shade(*left, kGrey, "not in equilibrium, not used");
  legend_below(*plot, 4);
  origin_below(*plot, subject);
  left->axis(QCPAxis::atLeft)->setRange(range_of(probes, macro));
  right->axis(QCPAxis::atLeft)->setRange(range_of(probes, micro));
  for (auto* rect : {left, right}) shade(*rect, probes, found.not_at_rest, kGrey);
  shade(*left, probes, found.negative, kVermilion);
  shade(*right, probes, found.agreeing, kGreen);
  draw_series(*left, probes, macro);
  draw_series(*right, probes, micro);
  return {std::move(plot),
          fmt::format("Density of second-order work over the direction of the {} probe: "
                      "macroscopic with the parts of the Eulerian form (left), macroscopic and "
                      "microscopic (right).{} {}",
                      lab::word(subject.kind), not_at_rest_words(probes), simulated_with(subject))};
}

Drawing grain_contacts_figure(const sim::ProbeRose& rose, const Subject& subject) {
  const Probes probes = made(rose);
  if (probes.empty()) return {};
  const study::GrainRoseFindings found = study::rose_findings(rose);
  const std::vector<Series> contacts = {
      {"sliding", [](const auto& p) { return 100 * p.sliding_share; }, line(kBlue, 1.8), true},
      {"non-permanent", [](const auto& p) { return 100 * p.work.non_permanent_share(); },
       line(kVermilion, 1.8, Qt::DashLine), true}};
  const std::vector<Series> energy = {{"kinetic energy", kinetic, line(kInk, 1.8), true}};
  auto [plot, left, right] = two_panels(subject, "fraction of the contacts at the start (%)",
                                        "largest kinetic energy (J)");
  name_series(*left, contacts);
  name_series(*right, energy);
  const double null_energy = rose.null_probe.stopped ? 0 : rose.null_probe.most_kinetic_j;
  const QPen null_pen = line(kGrey, 1.4, Qt::DotLine);
  EnergyRange energies;
  for (const auto& probe : probes) energies.add(probe.most_kinetic_j);
  energies.apply(*right->axis(QCPAxis::atLeft));
  const bool below = null_energy < right->axis(QCPAxis::atLeft)->range().lower;
  if (null_energy > 0)
    draw_curve(*right, {}, null_pen,
               fmt::format("null probe, {:.1e} J{}", null_energy, below ? " (below)" : ""));
  if (!found.irreversible.empty())
    name_shade(*left, kOrange,
               fmt::format("both {:g} % above the null probe", 100 * study::kIrreversible));
  if (!found.dynamic.empty())
    name_shade(*right, kPurple, fmt::format("above {:g} times the least", study::kDynamic));
  legend_below(*plot, 3);
  origin_below(*plot, subject);
  left->axis(QCPAxis::atLeft)->setRange(range_of(probes, contacts));
  shade(*left, probes, found.irreversible, kOrange);
  shade(*right, probes, found.dynamic, kPurple);
  draw_series(*left, probes, contacts);
  draw_series(*right, probes, energy);
  if (null_energy > 0) draw_curve(*right, {{0, null_energy}, {kTurnDeg, null_energy}}, null_pen);
  return {std::move(plot),
          fmt::format("Sliding and non-permanent contacts (left) and the largest "
                      "kinetic energy (right) over the direction of the {} "
                      "probe.{} {}",
                      lab::word(subject.kind), not_at_rest_words(probes), simulated_with(subject))};
}

}  // namespace triax::src
