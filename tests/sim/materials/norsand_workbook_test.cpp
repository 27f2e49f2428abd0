// SPDX-License-Identifier: GPL-3.0-or-later
// NorSand against its authors' workbook, whose explicit scheme is done here on top of the law's own
// functions.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/sim/materials/norsand_paths.hpp"
#include "tests/sim/materials/norsand_sets.hpp"

using namespace triax::sim;
using triax::sim::test::loose;
using triax::sim::test::Peak;
using triax::sim::test::peak_on;
using triax::sim::test::undrained_with_water;
using Control = MixedControl<Axisymmetric>;
using State = PointState<Axisymmetric>;

namespace {

/// One row of the workbook: strain as an engineer's, from the change of height.
struct WorkbookRow {
  double strain_pct = 0, p_kPa = 0, q_kPa = 0, e = 0;
};

enum class Drainage { undrained, drained };

/// The explicit scheme of the workbook, in equal steps of plastic shear strain up to 0.22, on top
/// of the law's own functions.
class Workbook {
 public:
  Workbook(const NorSand& law, const State& start, Drainage drainage, bool softens_with_skeleton)
      : law_(law),
        state_(start),
        drainage_(drainage),
        softens_with_skeleton_(softens_with_skeleton),
        p_(start.p()),
        e_(start.void_ratio),
        p0_(start.p()),
        r_(std::exp(-1.0)) {
    place(p_ / 2.71828 / p_);
    m_ = law_.image(state_).stress_ratio;
  }

  WorkbookRow step(double d) {  // d = dε_q^p
    place(r_);
    const double shear = law_.shear_modulus(p_), bulk = law_.bulk_modulus(p_);
    const NorSand::Image image = law_.image(state_);
    const double change = 1 - m_ / image.stress_ratio;
    m_ = image.stress_ratio;
    const double plastic_volume = (m_ - eta_) * d;
    const double restraint = drainage_ == Drainage::drained ? 0 : law_.restraint(state_);
    const double softening =
        law_.cap_softening(state_, image, softens_with_skeleton_ ? bulk : restraint);
    const double growth =
        (law_.hardening(state_) * (image.largest_ratio - r_) / (r_ * r_) + softening) * d;
    const double p_before = p_, q_before = eta_ * p_;
    if (drainage_ == Drainage::undrained) {
      p_ = std::max(p_ - plastic_volume * restraint, 100.0);
      r_ *= (1 + growth) * p_before / p_;
      eta_ = m_ * (1 + std::log(r_));
    } else {
      const double slope = 3;
      const double d_eta = (eta_ * change + m_ * growth) / (1 + m_ / (slope - eta_));
      eta_ += d_eta;
      p_ += p_ * d_eta / (slope - eta_);
      r_ = std::exp(eta_ / m_ - 1);
    }
    const double q = eta_ * p_;
    const double volume = plastic_volume + (p_ - p_before) / bulk;
    const double axial = d + (q - q_before) / (3 * shear) + volume / 3;
    e_ -= (1 + e_) * volume;
    height_ *= 1 - axial;
    return {(1 - height_) * 100, p_ / 1e3, q / 1e3, e_};
  }

 private:
  void place(double ratio) {
    state_.stress = components(AxisymmetricStress{p_ * (1 + 2 * eta_ / 3), p_ * (1 - eta_ / 3)});
    state_.void_ratio = e_;
    state_.memory << ratio * p_ / p0_, p0_;
  }

  const NorSand& law_;
  State state_;
  Drainage drainage_;
  bool softens_with_skeleton_;
  double p_, e_, p0_, r_, m_ = 0, eta_ = 0, height_ = 1;
};

constexpr int kSteps = 3699;

/// All rows of the workbook with a step of plastic strain divided by `finer`.
std::vector<WorkbookRow> workbook(const NorSand& law, Drainage drainage, bool softens_with_skeleton,
                                  int finer = 1) {
  Workbook book(law, loose(law, 500, 0.108), drainage, softens_with_skeleton);
  std::vector<WorkbookRow> rows{{}};
  for (int i = 0; i < kSteps; ++i) {
    WorkbookRow row;
    for (int k = 0; k < finer; ++k) row = book.step(0.22 / kSteps / finer);
    rows.push_back(row);
  }
  return rows;
}

WorkbookRow peak_of(const std::vector<WorkbookRow>& rows) {
  return *std::max_element(
      rows.begin(), rows.end(),
      [](const WorkbookRow& a, const WorkbookRow& b) { return a.q_kPa < b.q_kPa; });
}

void check_workbook_row(const WorkbookRow& found, const WorkbookRow& printed) {
  // The workbook's own λ has more digits than are printed with it: 5e-7 kPa.
  CHECK(found.strain_pct == Approx(printed.strain_pct).margin(1e-6));
  CHECK(found.p_kPa == Approx(printed.p_kPa).margin(5e-7));
  CHECK(found.q_kPa == Approx(printed.q_kPa).margin(5e-7));
}

}  // namespace

TEST_CASE("the workbook's undrained rows come out of the law's functions, digit by digit") {
  // This file was made with K instead of K_S in the cap softening.
  const auto rows = workbook(NorSand(test::nerlerk()), Drainage::undrained, true);
  check_workbook_row(rows[1], {0.011842968, 494.3155888, 12.23922979});
  check_workbook_row(rows[50], {0.396958, 311.842335, 190.997251});
  check_workbook_row(rows[100], {0.685466, 211.693651, 174.132371});
  check_workbook_row(rows[500], {2.851869, 5.435713, 7.435512});
  check_workbook_row(rows[kSteps], {19.676024, 2.955666048, 4.285715207});
  const WorkbookRow peak = peak_of(rows);
  check_workbook_row(peak, {0.445759055, 292.2292516, 192.3586264});
  CHECK(peak.q_kPa / peak.p_kPa == Approx(0.658245625).margin(5e-9));
}

TEST_CASE("the workbook's drained rows come out of the law's functions, digit by digit") {
  const auto rows = workbook(NorSand(test::nerlerk_drained()), Drainage::drained, false);
  check_workbook_row(rows[1], {0.011139095, 501.4156009, 4.246802616});
  check_workbook_row(rows[100], {0.956934, 590.313975, 270.941925});
  check_workbook_row(rows[1000], {7.167968, 785.021927, 855.065782});
  check_workbook_row(rows[kSteps], {21.70712864, 913.2910717, 1239.873215});
  CHECK(rows[kSteps].e == Approx(0.747313955).margin(2e-9));
}

TEST_CASE("with K_S in the cap softening the workbook's peak is the published one") {
  const WorkbookRow peak = peak_of(workbook(NorSand(test::nerlerk()), Drainage::undrained, false));
  CHECK(peak.q_kPa == Approx(196.02).margin(0.005));
  CHECK(peak.q_kPa / peak.p_kPa == Approx(0.6791).margin(5e-5));
  CHECK(peak.strain_pct == Approx(0.460).margin(5e-4));
}

TEST_CASE("the converged undrained path is where the workbook goes with finer steps") {
  const NorSand law(test::nerlerk());
  const Peak converged =
      peak_on(law, loose(law, 500, 0.108), [](double d) { return undrained_with_water(d, 1e9); });
  const double q = converged.state.q() / 1e3;
  const double coarse = peak_of(workbook(law, Drainage::undrained, false)).q_kPa;
  const double fine = peak_of(workbook(law, Drainage::undrained, false, 20)).q_kPa;
  CHECK(q == Approx(coarse).epsilon(6e-3));
  CHECK(q == Approx(fine).epsilon(4e-4));
  // First order: the error falls with the step.
  CHECK((coarse - q) / (fine - q) == Approx(20).epsilon(0.1));
}

TEST_CASE("docs/how-to/material-point.md prints these peaks") {
  std::ifstream file("docs/how-to/material-point.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const NorSand law(test::nerlerk());
  const auto holds = [&](double q_kPa, double eta) {
    CHECK_THAT(page, Catch::Contains(fmt::format("| {:.2f} | {:.3f} |", q_kPa, eta)));
  };
  const WorkbookRow printed = peak_of(workbook(law, Drainage::undrained, true));
  const WorkbookRow right = peak_of(workbook(law, Drainage::undrained, false));
  const auto converged = [&](auto control) {
    return peak_on(law, loose(law, 500, 0.108), control).state;
  };
  const State watery = converged([](double d) { return undrained_with_water(d, 1e9); });
  const State undrained = converged([](double d) { return Control::strain_path(d); });
  holds(printed.q_kPa, printed.q_kPa / printed.p_kPa);
  holds(right.q_kPa, right.q_kPa / right.p_kPa);
  holds(watery.q() / 1e3, watery.q() / watery.p());
  holds(undrained.q() / 1e3, undrained.q() / undrained.p());
  const double eta = printed.q_kPa / printed.p_kPa;
  CHECK_THAT(page,
             Catch::Contains(fmt::format("{:.1f} % in q and {:.1f} % in η at the undrained peak",
                                         100 * (undrained.q() / 1e3 / printed.q_kPa - 1),
                                         100 * (undrained.q() / undrained.p() / eta - 1))));
}

TEST_CASE("the drained path is where the workbook goes with finer steps") {
  const NorSand law(test::nerlerk_drained());
  double before = 1;
  for (const int finer : {1, 10}) {
    const auto rows = workbook(law, Drainage::drained, false, finer);
    State state = loose(law, 500, 0.108);
    double strain = 0, worst = 0;
    for (const std::size_t row : {100, 1000, kSteps}) {
      const double natural = -std::log(1 - rows[row].strain_pct / 100);
      const auto step =
          advance_point<Axisymmetric>(law, state, Control::drained_compression(natural - strain));
      REQUIRE(step.outcome == StepOutcome::accepted);
      state = step.state;
      strain = natural;
      worst = std::max(worst, std::abs(state.q() / 1e3 / rows[row].q_kPa - 1));
      CHECK(state.void_ratio == Approx(rows[row].e).margin(2e-5));
      CHECK(state.q() / 1e3 == Approx(rows[row].q_kPa).epsilon(5e-3));
    }
    CHECK(worst < before);
    before = worst / 8;  // ten times finer: the error falls with the step
  }
}
