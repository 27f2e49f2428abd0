// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/proposal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

using namespace triax::lab;

namespace {

Proposal proposal_of(const std::string& text) {
  const auto source = open_memory("table.csv", text);
  return propose(*source).front();
}

std::string quantity_of(const Proposal& proposal, std::size_t column) {
  const auto* quantity = proposal.meaning.columns.at(column).reading.quantity;
  return quantity ? quantity->name : "";
}

bool asks(const Proposal& proposal, const std::string& text) {
  return std::ranges::find(proposal.questions, text, &TableQuestion::text) !=
         proposal.questions.end();
}

double q_of(int i) { return 100 * std::tanh(0.2 * i); }
double u_of(int i) { return 200 + 60 * (1 - std::exp(-0.3 * i)); }

/// A row for each of 20 readings.
template <class Row>
std::string table(const std::string& headings, const Row& row) {
  constexpr int kReadings = 20;
  std::string out = headings + '\n';
  for (int i = 0; i < kReadings; ++i) out += row(i) + '\n';
  return out;
}

}  // namespace

TEST_CASE("propose: the unit of a time is asked unless the file has it", "[intake]") {
  const auto row = [](int i) {
    return fmt::format("{},{:.2f},{:.1f},{:.1f}", 60 * i, 0.5 * i, q_of(i), 150 + q_of(i) / 3);
  };
  CHECK(asks(proposal_of(table("Time,Axial strain (%),q (kPa),p' (kPa)", row)), "unit of Time"));
  CHECK(proposal_of(table("Time (s),Axial strain (%),q (kPa),p' (kPa)", row)).questions.empty());
}

TEST_CASE("propose: a stage below the name of a group is no time", "[intake]") {
  const Proposal found = proposal_of(table("Zeit;;Spannungen\nStufe;Zeit (s);q (kPa)", [](int i) {
    return fmt::format("{};{};{:.1f}", i / 7 + 1, 30 * i, q_of(i));
  }));
  CHECK(quantity_of(found, 0) == "stage");
  CHECK(quantity_of(found, 1) == "time");
}

TEST_CASE("propose: an effective stress is never read as a total one", "[intake]") {
  const Proposal found = proposal_of(
      table("Déformation axiale (%),Déviateur (kPa),Contrainte radiale effective (kPa),u (kPa)",
            [](int i) { return fmt::format("{:.2f},{:.1f},150,150", 0.5 * i, q_of(i)); }));
  CHECK(quantity_of(found, 2) == "effective_radial_stress");
}

TEST_CASE("propose: targets and columns without a name are not used", "[intake]") {
  const Proposal found =
      proposal_of(table("Def. assiale (%),q (kPa),u (kPa),Pressione di cella (kPa),"
                        "Pressione di cella impostata (kPa),xyz_ratio (-)",
                        [](int i) {
                          return fmt::format("{:.2f},{:.1f},{:.1f},299.9,300.0,{:.3f}", 0.5 * i,
                                             q_of(i), u_of(i), 1 + 0.1 * i);
                        }));
  CHECK(quantity_of(found, 3) == "cell_pressure");
  CHECK(quantity_of(found, 4) == "ignored");
  CHECK(quantity_of(found, 5).empty());
}

TEST_CASE("propose: the pressure that is constant in shear decides s′ and t", "[intake]") {
  // Saturation and consolidation raise the cell pressure before.
  const Proposal found = proposal_of(table("Stage,ε1 (%),q (kPa),u (kPa),p' (kPa)", [](int i) {
    const bool is_shear = i >= 8;
    const double t = is_shear ? q_of(i - 7) / 2 : 0, u = is_shear ? u_of(i - 8) : 25.0 * i;
    const double radial = is_shear ? 400 - u : 20.0 + 2 * i;
    return fmt::format("{},{:.2f},{:.2f},{:.2f},{:.2f}", is_shear ? 2 : 1,
                       is_shear ? 0.5 * (i - 7) : 0, t, u, radial + t);
  }));
  CHECK(quantity_of(found, 2) == "half_deviator_stress");
  CHECK(quantity_of(found, 4) == "mean_effective_stress_2d");
}

TEST_CASE("propose: rows in reverse order have the signs of the others", "[intake]") {
  const auto row = [](int i) {
    return fmt::format("{},{:.2f},{:.4f},{:.1f},150", 60 * (19 - i), 0.5 * (19 - i),
                       -1.5 * std::tanh(0.1 * (19 - i)), q_of(19 - i));
  };
  const Proposal found =
      proposal_of(table("Time (s),Axial strain (%),Volumetric strain (%),q (kPa),σ3' (kPa)", row));
  CHECK(found.is_reversed);
  CHECK(found.meaning.of("volumetric_strain")->reading.sign == -1);
}

TEST_CASE("propose: units and codes at the edges", "[intake]") {
  const Proposal permille = proposal_of(table("Axial strain ‰,q (kPa)", [](int i) {
    return fmt::format("{:.1f},{:.1f}", 5.0 * i, q_of(i));
  }));
  CHECK(permille.meaning.of("axial_strain")->reading.factor == Approx(1e-3));
  const Proposal hundredths = proposal_of(table("轴向位移/0.01 mm,q/kPa", [](int i) {
    return fmt::format("{:.1f},{:.1f}", 50.0 * i, q_of(i));
  }));
  CHECK(hundredths.meaning.of("axial_displacement")->reading.factor == Approx(0.01));
  // 9999 s is a time between two others, no code for a missing value.
  const Proposal times = proposal_of(table("Time (s),q (kPa)", [](int i) {
    return fmt::format("{},{:.1f}", i == 4 ? 9999 : 2500 * i, q_of(i));
  }));
  CHECK(times.table.missing.empty());
  const Proposal volumes = proposal_of(table("Axial strain (%),ΔV (mm³),q (kPa)", [](int i) {
    return fmt::format("{},{},{:.1f}", i, i == 10 || i == 11 ? "-9999.0" : std::to_string(-970 * i),
                       q_of(i));
  }));
  CHECK(volumes.table.missing.size() == 2);
  const Proposal stresses = proposal_of(table("Axial strain (%),σ1 (kPa),q (kPa)", [](int i) {
    return fmt::format("{},{:.1f},{:.1f}", -i, -770 - 76.33 * i, -q_of(i));  // i = 3: -999.0
  }));
  CHECK(stresses.table.missing.empty());
}

TEST_CASE("propose: the unit of an unknown name and the readings decide", "[intake]") {
  const Proposal found = proposal_of(table("MW 7 (mm),MW 9 (N),q (kPa)", [](int i) {
    return fmt::format("{:.2f},{:.1f},{:.1f}", 0.5 * i, q_of(i) / (1 - 0.005 * i), q_of(i));
  }));
  CHECK(quantity_of(found, 0) == "axial_displacement");
  CHECK(quantity_of(found, 1) == "axial_force");
  // One of many pressures, and a length that does not change.
  const Proposal open = proposal_of(table("MW 7 (mm),MW 9 (kPa),ε1 (%),q (kPa)", [](int i) {
    return fmt::format("70.00,{:.1f},{:.1f},{:.1f}", 100 + 7.3 * (i % 3), 0.5 * i, q_of(i));
  }));
  CHECK(quantity_of(open, 1).empty());
}

TEST_CASE("propose: a ratio that begins at 0 is q/p', at 1 it is σ1'/σ3'", "[intake]") {
  const auto ratio_from = [](double first) {
    return proposal_of(table("Axial strain (%),q (kPa),Stress ratio", [first](int i) {
      return fmt::format("{:.1f},{:.1f},{:.3f}", 0.5 * i, q_of(i), first + 0.07 * i);
    }));
  };
  CHECK(quantity_of(ratio_from(0), 2) == "stress_ratio");
  CHECK(quantity_of(ratio_from(1), 2) == "principal_stress_ratio");
}

TEST_CASE("propose: a column of numbers is a clock by its cells, not by its name", "[intake]") {
  const auto row = [](int i) {
    return fmt::format("{},{:.2f},{:.1f},{:.4f}", 1773124224 + 60 * i, 0.5 * i, q_of(i),
                       0.7 - 1e-3 * i);
  };
  const Proposal found = proposal_of(table("MW 7,ε1 (%),q (kPa),Fecha", row));
  CHECK(quantity_of(found, 0) == "clock");
  CHECK(quantity_of(found, 3).empty());
}

TEST_CASE("propose: repeated headings with a quoted comment mark are no rows", "[intake]") {
  std::string text = "\"# t\",\"q\"\n\"# s\",\"kPa\"\n";
  for (int i = 0; i < 12; ++i) {
    if (i == 6) text += "\"# t\",\"q\"\n\"# s\",\"kPa\"\n";
    text += fmt::format("\"{}\",\"{:.1f}\"\n", 60 * i, q_of(i));
  }
  CHECK(proposal_of(text).table.row_lines.size() == 12);
}

TEST_CASE("propose: units of the software hold for reversed rows too", "[intake]") {
  std::string text = "LabVIEW Measurement\nDecimal_Separator,.\n***End_of_Header***\n";
  text += table("X_Value,Axial strain (%),q (kPa),p' (kPa)", [](int i) {
    return fmt::format("{},{:.2f},{:.1f},{:.1f}", 60 * (19 - i), 0.5 * (19 - i), q_of(19 - i),
                       150 + q_of(19 - i) / 3);
  });
  const Proposal found = proposal_of(text);
  CHECK(found.is_reversed);
  CHECK(found.meaning.of("time")->reading.unit_source == UnitSource::format);
  CHECK(found.questions.empty());
}

TEST_CASE("propose: readings are stronger than the sign of the software", "[intake]") {
  const auto text = [](int sign) {
    return table("Time (s),Action,Action_Changed,VerticalDeformation_mm,Deviator_kPa,Trajectory",
                 [sign](int i) {
                   return fmt::format("{},Start,True,{:.2f},{:.1f},CTC", 60 * i, sign * 0.4 * i,
                                      q_of(i));
                 });
  };
  CHECK(proposal_of(text(1)).meaning.of("axial_displacement")->reading.sign == 1);
  CHECK(proposal_of(text(-1)).meaning.of("axial_displacement")->reading.sign == -1);
}

TEST_CASE("propose: a dial in divisions has the factor of its displacement", "[intake]") {
  const Proposal found =
      proposal_of(table("Dial reading,Axial displacement (mm),q (kPa)", [](int i) {
        return fmt::format("{},{:.2f},{:.1f}", 50 * i, 0.5 * i, q_of(i));
      }));
  REQUIRE(found.has("dial_reading"));
  CHECK(found.meaning.of("dial_reading")->reading.factor == Approx(0.01));
}

TEST_CASE("propose: a void ratio below % is a plain number") {
  const auto row = [](int i) {
    const double eps_v = 0.001 * i;
    return fmt::format("{},{},{},{},{}", 0.5 * i, 100 * eps_v, 1.8 * (1 - eps_v) - 1, q_of(i),
                       100 + q_of(i) / 3);
  };
  const auto proposal = proposal_of(table("eps1,epsv,Void ratio,q,p'\n%,%,%,kPa,kPa", row));
  REQUIRE(quantity_of(proposal, 2) == "void_ratio");
  CHECK(proposal.meaning.columns[2].reading.factor == 1);
  CHECK(proposal.meaning.columns[1].reading.factor == Approx(0.01));
}

TEST_CASE("propose: the unit of a strain beyond 100 % is asked") {
  const auto proposal =
      proposal_of(table("Displ,str_ax,e_V,er,q\n[mm],[x],[x],[x],[kPa]", [](int i) {
        return fmt::format("{:.2f},{:.1f},{:.1f},{:.1f},{:.1f}", 1.0 * i, 7.0 * i, 1.0 * i,
                           -3.0 * i, q_of(i));
      }));
  REQUIRE(quantity_of(proposal, 1) == "axial_strain");
  CHECK(asks(proposal, "unit of str ax"));
  const auto usual = proposal_of(table("Displ,str_ax,q\n[mm],[%],[kPa]", [](int i) {
    return fmt::format("{:.2f},{:.1f},{:.1f}", 1.0 * i, 1.0 * i, q_of(i));
  }));
  CHECK_FALSE(asks(usual, "unit of str ax"));
}

TEST_CASE("propose: the sign of a volume change is decided across a gap, or asked") {
  const auto text = [](double sign, const char* second) {
    const std::vector<double> volumes{0, 0.375, 0.485, 0.456, -0.114, -0.289, -0.467, -0.646};
    std::string out = "Settlement (mm),q (kPa),Specimen volume change (cm3)\n";
    int row = 0;
    for (const double volume : volumes) {
      out += fmt::format("{:.1f},{:.1f},{:.3f}\n", 1.0 * row, q_of(row), sign * volume);
      ++row;
      if (volume != 0.456) continue;
      for (int i = 0; i < 3; ++i, ++row)
        out += fmt::format("{:.1f},{:.1f},{}\n", 1.0 * row, q_of(row), second);
    }
    return out;
  };
  for (const double sign : {1.0, -1.0}) {
    const auto proposal = proposal_of(text(sign, "#DIV/0!"));
    CHECK(proposal.meaning.of("volume_change")->reading.sign == sign);
    CHECK_FALSE(asks(proposal, "sign of Specimen volume change"));
  }
  const auto noisy =
      proposal_of(table("Settlement (mm),q (kPa),Specimen volume change (cm3)", [](int i) {
        return fmt::format("{:.1f},{:.1f},{:.3f}", 1.0 * i, q_of(i),
                           i % 2 == 0 ? 0.01 * i : -0.01 * i);
      }));
  CHECK(asks(noisy, "sign of Specimen volume change"));
}

namespace {

/// Saturation with water flowing in, consolidation and undrained shear. `moved_mm` is how far the
/// axis moves in saturation.
std::string saturated_test(const char* volume_heading, double sign, double moved_mm,
                           const char* axis_heading = "Axial displacement (mm)") {
  std::string out =
      fmt::format("{},Cell pressure (kPa),u (kPa),{},q (kPa)\n", axis_heading, volume_heading);
  const auto add = [&](double axis, double cell, double u, double volume, double q) {
    out += fmt::format("{:.4f},{:.1f},{:.1f},{:.0f},{:.2f}\n", axis, cell, u, sign * volume, q);
  };
  for (int i = 0; i < 20; ++i) add(moved_mm * i / 19, 30 + 17.0 * i, 20 + 15.0 * i, -47.0 * i, 0);
  for (int i = 0; i < 20; ++i) {
    const double f = 1 - std::exp(-0.3 * i);
    add(moved_mm + 0.46 * f, 400, 360 - 60 * f, -893 + 4300 * f, 0);
  }
  for (int i = 0; i < 60; ++i)
    add(moved_mm + 0.46 + 0.45 * i, 400, 100 + u_of(i), 3392, 60 * std::tanh(0.2 * i));
  return out;
}

}  // namespace

TEST_CASE("propose: water that flows in in saturation does not decide the sign of a volume") {
  const char* const volume = "Volume change (mm3)";
  for (const double sign : {1.0, -1.0}) {
    for (const char* axis : {"Axial displacement (mm)", "Axial strain (%)"}) {
      const auto found = proposal_of(saturated_test(volume, sign, 0.02, axis));
      CHECK(found.meaning.of("volume_change")->reading.sign == sign);
      CHECK_FALSE(asks(found, "sign of Volume change"));
    }
    // The axis moves in saturation, too, so that the readings contradict each other.
    CHECK(asks(proposal_of(saturated_test(volume, sign, 0.2)), "sign of Volume change"));
  }
  const auto back = proposal_of(saturated_test("Back volume (mm3)", -1, 0.02));
  CHECK(back.meaning.of("back_volume")->reading.sign == 1);
}

TEST_CASE("propose: names that the pore pressure contradicts are asked") {
  const auto text = [](double fraction, double later) {
    return table("eps1 (%),q (kPa),u (kPa),p' (kPa)", [=](int i) {
      constexpr int kSecondTest = 10;
      const double cell_pressure = i < kSecondTest ? 300 : later;
      return fmt::format("{:.2f},{:.2f},{:.2f},{:.2f}", 0.5 * i, q_of(i), u_of(i),
                         cell_pressure - u_of(i) + fraction * q_of(i));
    });
  };
  CHECK(asks(proposal_of(text(1, 600)), "that these are s' and t"));
  CHECK_FALSE(asks(proposal_of(text(1. / 3, 300)), "that these are s' and t"));
}

TEST_CASE("propose: a strain that is not that of the height is asked") {
  const auto text = [](double times) {
    return table("t (s),e_v (-),u (kPa),Height (mm)", [times](int i) {
      const double strain = 0.01 * (1 - std::exp(-0.3 * i));
      return fmt::format("{},{:.5f},{:.1f},{:.4f}", 60 * i, times * strain,
                         200 - 10 * (1 - std::exp(-0.3 * i)), 142.24 * (1 - strain));
    });
  };
  CHECK(asks(proposal_of(text(3)), "meaning of e v"));
  CHECK_FALSE(asks(proposal_of(text(1)), "meaning of e v"));
}

TEST_CASE("propose: a strain without its first readings does not hide the contraction") {
  const auto text = [](double sign) {
    return table("eps_a (-),eps_v (-),q (kPa)", [sign](int i) {
      constexpr int kMissing = 3;
      const double x = 0.5 * i, volume = 0.002 * x * std::exp(1 - x) - 0.0003 * x * x;
      return fmt::format("{},{:.5f},{:.1f}",
                         i < kMissing ? "9.90000E+37" : fmt::format("{:.5f}", 0.008 * i),
                         sign * volume, q_of(i));
    });
  };
  for (const double sign : {1.0, -1.0})
    CHECK(proposal_of(text(sign)).meaning.of("volumetric_strain")->reading.sign == sign);
}

TEST_CASE("propose: a wide calculation sheet has its best meaning") {
  const Proposal found = proposal_of(table(
      "Date,Time,Axial strain Reading DL (mm),Axial strain Difference (mm),Axial strain ε "
      "(%),Axial force Reading R (div),"
      "Axial force R-R0 (div),Axial force P (N),Volume change Reading (cm³),"
      "Volume change Difference (cm³),Volume change εv (%),Area As (mm²),"
      "Deviator stress (σ1-σ3)m (kPa),Deviator stress σmb (kPa),Deviator stress (σ1-σ3) (kPa),"
      "Principal stresses σ1' (kPa),Principal stresses σ3' (kPa),Principal stresses σ1'/σ3',"
      "Stress path s' (kPa),Stress path t' (kPa)",
      [](int i) {
        const double strain = 0.01 * i, area = 1928, height = 98.4, volume = 0.3 * strain;
        const double membrane = 2 * strain, corrected = 3 * q_of(i);
        const double measured = corrected + membrane, current = area * (1 - volume) / (1 - strain);
        const double force = measured * current / 1e3, ring = force / 1.82;
        const double flow = volume * area * height / 1e3, major = 150 + corrected;
        return fmt::format(
            "2023-11-08,{:02}:{:02},{:.3f},{:.3f},{:.2f},{:.1f},{:.1f},{:.1f},{:.2f},{:.2f},{:.3f},"
            "{:.1f},{:.1f},{:.2f},{:.1f},{:.1f},150,{:.3f},{:.1f},{:.1f}",
            9 + i / 12, i % 12 * 5, 1.25 + height * strain, height * strain, 100 * strain,
            64 + ring, ring, force, 31.6 - flow, flow, 100 * volume, current, measured, membrane,
            corrected, major, major / 150, (major + 150) / 2, corrected / 2);
      }));
  CHECK(quantity_of(found, 4) == "axial_strain");
  CHECK(quantity_of(found, 7) == "axial_force");
  CHECK(quantity_of(found, 10) == "volumetric_strain");
  CHECK(quantity_of(found, 12) == "deviator_stress_uncorrected");
  CHECK(quantity_of(found, 13) == "membrane_and_drain_correction");
  CHECK(quantity_of(found, 14) == "deviator_stress");
  CHECK_FALSE(asks(found, "meaning of Axial strain Reading DL"));
}

TEST_CASE("propose: the correction tells the corrected deviator stress") {
  for (const bool is_first : {true, false}) {
    const Proposal found = proposal_of(
        table("Strain (%),q (kPa),Deviator (kPa),Membrane correction (kPa)", [is_first](int i) {
          const double correction = 0.3 * i, corrected = q_of(i), measured = corrected + correction;
          return fmt::format("{:.1f},{:.1f},{:.1f},{:.1f}", 0.5 * i,
                             is_first ? corrected : measured, is_first ? measured : corrected,
                             correction);
        }));
    CHECK(quantity_of(found, is_first ? 1 : 2) == "deviator_stress");
    CHECK(quantity_of(found, is_first ? 2 : 1) == "deviator_stress_uncorrected");
  }
}

TEST_CASE("propose: s′ and t under the names of p′ and q are found by a rounded pore pressure") {
  for (const double start : {300.0, 0.0}) {
    const std::string u_name = start > 0 ? "u" : "Δu";
    const Proposal found = proposal_of(
        table("Time (min),Strain (%)," + u_name + " (kPa),Stresses q (kPa),Stresses p´ (kPa)",
              [start](int i) {
                const double t = 18 * std::tanh(0.4 * i), u = start + 22 * std::tanh(0.4 * i);
                const double scatter = 0.3 * std::sin(7.0 * i);  // of the cell pressure
                return fmt::format("{},{:.3f},{:.2f},{:.1f},{:.1f}", 100 * i, 0.94 * i, u, t,
                                   start + 50.2 + scatter - u + t);
              }));
    CHECK(quantity_of(found, 3) == "half_deviator_stress");
    CHECK(quantity_of(found, 4) == "mean_effective_stress_2d");
  }
}

TEST_CASE("propose: a held pressure in coarse steps is the sum of effective and pore pressure") {
  const Proposal found =
      proposal_of(table("e_vol (%),cp_meas (bar),Pw_base (bar),eff_rad_stress (kPa)", [](int i) {
        const double u = 347.7 - 150 * std::tanh(0.1 * i);
        return fmt::format("{:.2f},5.5,{:.3f},{:.2f}", 0.14 * i, u / 100, 549.99 - u);
      }));
  CHECK(quantity_of(found, 1) == "cell_pressure");
  CHECK(quantity_of(found, 2) == "pore_pressure");
}
