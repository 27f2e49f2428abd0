#include "src/triaxial/figures/origin_note.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"
#include "src/plot/plot_style.hpp"
#include "tests/src/sample_tests.hpp"

using namespace triax::src;
using namespace triax::study;

namespace {

TestResult simulated_with(const std::string& name, const std::string& material) {
  auto test = test::simulated_test();
  test.stored.header.name = name;
  test.stored.header.specimen.material = material;
  return test;
}

std::string note_in(QCustomPlot& plot) {
  for (int row = 0; row < plot.plotLayout()->rowCount(); ++row)
    if (auto* note = qobject_cast<QCPTextElement*>(plot.plotLayout()->element(row, 0)))
      return note->text().toStdString();
  return {};
}

}  // namespace

TEST_CASE("recorded tests have no note; simulated ones tell their materials once") {
  const auto recorded = test::flow_test();
  const auto a = simulated_with("A", "inl2/x"), b = simulated_with("B", "inl2/x"),
             c = simulated_with("C", "sanisand/y");
  CHECK(origin_of({&recorded}).empty());
  CHECK(origin_of({}).empty());
  CHECK(origin_of({&a, &b}) == "simulated: inl2/x");
  CHECK(origin_of({&a, &b, &c}) == "simulated: inl2/x, sanisand/y");
}

TEST_CASE("among recorded tests the simulated ones are named") {
  const auto recorded = test::flow_test();
  const auto a = simulated_with("A", "inl2/x"), b = simulated_with("B", "");
  CHECK(origin_of({&recorded, &a}) == "simulated: A, with inl2/x");
  CHECK(origin_of({&b}) == "simulated");
}

TEST_CASE("of many materials their number is told") {
  std::vector<TestResult> tests;
  std::vector<const TestResult*> pointers;
  for (int i = 0; i < 4; ++i) tests.push_back(simulated_with("T", "inl2/" + std::to_string(i)));
  for (const auto& test : tests) pointers.push_back(&test);
  CHECK(origin_of(pointers) == "simulated: 4 sets of parameters");
}

TEST_CASE(
    "a note is broken behind commas where the plot is too narrow, an empty one is not drawn") {
  auto narrow = make_plot(240, 200), broad = make_plot(900, 200), none = make_plot(240, 200);
  const std::string text = "simulated: inl2/S28-general, sanisand/S28-general, norsand/S28";
  note_below(*narrow, text);
  note_below(*broad, text);
  note_below(*none, "");
  CHECK(note_in(*broad) == text);
  CHECK(note_in(*narrow).find(",\n") != std::string::npos);
  CHECK(note_in(*none).empty());
}
