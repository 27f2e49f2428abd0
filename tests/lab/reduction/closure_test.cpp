#include "lab/reduction/closure.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
/// A closure fed with a file's q that is `share` of ours, on `area` of our 4000 mm².
Closure fed(double share, double area, bool in_shear = true) {
  Closure closure;
  for (int i = 1; i < 10; ++i) {
    State state;
    state.q = 10e3 * i;
    state.area_m2 = 4e-3;
    Reading reading;
    reading[Quantity::deviator_stress] = share * state.q;
    reading[Quantity::current_area] = area * state.area_m2;
    closure.add(reading, state, in_shear);
  }
  return closure;
}
}  // namespace

TEST_CASE("the difference of q is ours less theirs, over ours") {
  const auto lower = fed(0.99, 1).check(4e-3, {});
  REQUIRE(lower);
  CHECK(*lower->measured == Approx(0.01));
  CHECK(lower->ok);
  CHECK(lower->note == "the file's own q is 1.00 % lower than ours");
  CHECK_FALSE(fed(1.05, 1).check(4e-3, {})->ok);
}

TEST_CASE("the area is named only where it explains the difference") {
  const auto explained = fed(1 / 0.95, 0.95).check(4e-3, {});
  CHECK(explained->note.find("3800.0 mm2, ours is 4000.0 mm2") != std::string::npos);
  CHECK(explained->note.find("counter") == std::string::npos);
  const auto counted = fed(1 / 0.95, 0.95).check(4e-3, {{12, "back_volume jumps"}});
  CHECK(counted->note.find("counter was set back") != std::string::npos);
  CHECK(fed(1 / 0.95, 1).check(4e-3, {})->note.find("area") == std::string::npos);
}

TEST_CASE("nothing to compare is no check") {
  CHECK_FALSE(Closure().check(4e-3, {}));
  CHECK_FALSE(fed(1, 1, false).check(4e-3, {}));
}
