// SPDX-License-Identifier: GPL-3.0-or-later
// replay and simulate: through the session into a database, and the test read back from there.
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/otherwise.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "lab/rig/simulated/without_guard.hpp"
#include "src/python/bindings.hpp"
#include "src/python/database.hpp"
#include "src/python/documents.hpp"
#include "src/python/signals.hpp"
#include "src/python/warnings.hpp"
#include "src/study/triaxial/earlier_tests.hpp"
#include "src/study/triaxial/stored_record.hpp"
#include "src/study/triaxial/test_run.hpp"

namespace triax::python {

namespace py = pybind11;

namespace {

using Path = std::filesystem::path;
using Names = std::vector<std::string>;

lab::MembraneCorrection membrane_of(const std::string& word) {
  if (word == "none") return lab::MembraneCorrection::none;
  if (word == "astm") return lab::MembraneCorrection::astm;
  if (word == "iso") return lab::MembraneCorrection::iso;
  throw lab::BadInput("membrane '" + word + "' is not valid; must be one of: none, astm, iso");
}

StoredTest replay(const Path& record, const Path& db, const std::string& dialect,
                  const py::dict& sets, const std::string& membrane, const Names& earlier) {
  const lab::RecordOptions options{.dialect = dialect, .sets = key_values(sets)};
  const lab::ReductionOptions reduction{.membrane = membrane_of(membrane)};
  const py::gil_scoped_release free;
  if (!std::filesystem::exists(record))
    throw lab::BadInput(record.string(), 0, "file does not exist");
  const auto rig = lab::open_record(record.string(), options);
  const lab::EarlierTests told = study::earlier_tests(db.string(), earlier);
  Signals signals;
  const auto otherwise = [&] {
    return lab::judge_otherwise(rig->header(), reduction, [&](const lab::Guess::Said& said) {
      lab::RecordOptions other = options;
      other.sets.emplace_back(said.key, said.value);
      return lab::open_record(record.string(), other);
    });
  };
  std::string database = db.string();
  const auto id = study::run_test(*rig,
                                  {.reduction = reduction,
                                   .stop = [&] { return signals.look(); },
                                   .otherwise = otherwise,
                                   .earlier = told},
                                  database, {}, {.say = warn});
  return test_of(database, id);
}

StoredTest simulate(const Path& programme_file, const Path& db, std::optional<std::uint64_t> seed,
                    const py::dict& sets, const std::optional<Path>& record_file,
                    const Names& earlier) {
  std::vector<lab::TomlEdit> edits;
  for (const auto& [key, value] : key_values(sets))
    edits.push_back({key == "seed" ? "test.seed" : key, value});
  const py::gil_scoped_release free;
  lab::Programme programme = lab::load_programme(programme_file.string(), edits);
  lab::name_after_changes(programme);
  lab::VirtualRig rig(programme, seed);
  const lab::EarlierTests told = study::earlier_tests(db.string(), earlier);
  study::StoredRecord record(record_file ? record_file->string() : "", rig.header());
  Signals signals;
  const auto stop = [&] { return signals.look(); };
  std::string database = db.string();
  const auto id = study::run_test(
      rig,
      {.stop = stop, .without_guard = lab::without_guard(programme, seed, stop), .earlier = told},
      database, {}, {.say = warn});
  if (const std::string unwritten = record.write(rig, database, id); !unwritten.empty())
    throw lab::WorkFailed(unwritten);
  return test_of(database, id);
}

}  // namespace

void bind_runs(py::module_& module) {
  module.def(
      "replay", &replay, py::arg("record"), py::arg("db") = "triax.db", py::kw_only(),
      py::arg("dialect") = "", py::arg("sets") = py::dict(), py::arg("membrane") = "none",
      py::arg("earlier") = Names(),
      "Reduce a recorded test, compute its second-order work and store it in the database (as "
      "triax replay).\n"
      "Returns the stored test.\n"
      "`sets` gives the values that the file does not contain: {'specimen.height_mm': 140}.\n"
      "`earlier` names tests of the same sand for the alarm.");
  module.def("simulate", &simulate, py::arg("programme"), py::arg("db") = "triax.db", py::kw_only(),
             py::arg("seed") = py::none(), py::arg("sets") = py::dict(),
             py::arg("record") = py::none(), py::arg("earlier") = Names(),
             "Run a programme on the virtual apparatus and store the test in the database (as "
             "triax simulate).\n"
             "Returns the stored test.\n"
             "`sets` changes keys of the programme.\n"
             "`record` is a file to which the readings are written as a logger would write them.");
}

}  // namespace triax::python
