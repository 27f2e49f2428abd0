// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "db/catalogue.hpp"
#include "db/query.hpp"
#include "src/python/bindings.hpp"
#include "src/python/database.hpp"
#include "src/python/documents.hpp"
#include "src/python/signals.hpp"
#include "src/python/test_tables.hpp"
#include "src/python/warnings.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::python {

namespace py = pybind11;

StoredTest test_of(const std::string& db, std::int64_t id) {
  auto database = std::make_shared<Database>(db);
  db::StoredTest stored = database->store.load(id);
  return {std::move(database), std::move(stored)};
}

namespace {

using Path = std::filesystem::path;

template <class Work>
auto alone(const std::shared_ptr<Database>& database, const Work& work) {
  const py::gil_scoped_release free;
  const std::lock_guard lock(database->one_at_a_time);
  return work(database->store);
}

StoredTest found(const std::shared_ptr<Database>& database, const std::string& name) {
  return alone(database, [&](const db::Store& store) {
    return StoredTest{database, store.load(store.find({name}).front())};
  });
}

StoredTest numbered(const std::shared_ptr<Database>& database, std::int64_t id) {
  return alone(database, [&](const db::Store& store) {
    return StoredTest{database, store.load(id)};
  });
}

std::vector<StoredTest> all_of(const std::shared_ptr<Database>& database) {
  return alone(database, [&](const db::Store& store) {
    std::vector<StoredTest> tests;
    for (const std::int64_t id : store.find({})) tests.push_back({database, store.load(id)});
    return tests;
  });
}

/// Loads a table of a test unless it is there.
template <class Make>
std::shared_ptr<Columns> table(StoredTest& test, std::shared_ptr<Columns> StoredTest::*member,
                               const Make& make) {
  return alone(test.from, [&](const db::Store& store) {
    if (!(test.*member)) test.*member = std::make_shared<Columns>(make(store));
    return test.*member;
  });
}

py::object python_value(const db::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value))
    return py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text->data(), static_cast<py::ssize_t>(text->size()), "replace"));
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return py::int_(*whole);
  if (const auto* number = std::get_if<double>(&value)) return py::float_(*number);
  return py::none();
}

py::list rows_of(const std::string& path, const std::string& name_or_sql, double time_limit_s) {
  std::vector<std::string> names;
  std::vector<std::vector<db::Value>> rows;
  {
    const py::gil_scoped_release free;
    Signals signals;
    db::query(
        path, name_or_sql, [&](const std::vector<std::string>& columns) { names = columns; },
        [&](const std::vector<db::Value>& row) {
          signals.look();
          rows.push_back(row);
        },
        time_limit_s);
  }
  constexpr std::size_t kBetweenSignals = 1024;
  py::list all;
  for (const auto& row : rows) {
    if (all.size() % kBetweenSignals == 0 && PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    py::dict one;
    for (std::size_t i = 0; i < row.size(); ++i) one[py::str(names[i])] = python_value(row[i]);
    all.append(std::move(one));
  }
  return all;
}

py::object report_of(const StoredTest& test) {
  std::string json;
  {
    const py::gil_scoped_release free;
    json = src::json_of_test({test.stored, {}});
  }
  return document(json);
}

py::object instant_of(const StoredTest& test, const char* key) {
  return document(src::json_of_instants(test.stored))[key];
}

std::string words_of(const StoredTest& test) {
  return "<triax.Test " + std::to_string(test.stored.id) + " '" + test.stored.header.name + "', " +
         std::string(lab::to_string(test.stored.header.origin)) + ", " +
         std::to_string(test.stored.summary.readings) + " readings>";
}

void bind_test(py::module_& module) {
  py::class_<StoredTest>(module, "Test", "Test that is stored in a database.")
      .def_property_readonly(
          "id", [](const StoredTest& t) { return t.stored.id; },
          "Number of the test in the database.")
      .def_property_readonly(
          "name", [](const StoredTest& t) { return t.stored.header.name; }, "Name of the test.")
      .def_property_readonly(
          "origin", [](const StoredTest& t) { return lab::to_string(t.stored.header.origin); },
          "Origin of the test: 'recorded' or 'simulated'.")
      .def_property_readonly(
          "status", [](const StoredTest& t) { return db::to_string(t.stored.status); },
          "Status of the test when it was loaded: 'running', 'complete' or 'interrupted'.")
      .def_property_readonly(
          "tags", [](const StoredTest& t) { return t.stored.tags; }, "Tags of the test.")
      .def_property_readonly(
          "db", [](const StoredTest& t) { return t.from->path; }, "Path of the database file.")
      .def_property_readonly("report", &report_of,
                             "Document of triax report --format json: specimen, consolidation, "
                             "peak, collapse, events, checks,\n"
                             "warnings. Units are part of the names. An unknown value is None.")
      .def_property_readonly(
          "onset", [](const StoredTest& t) { return instant_of(t, "onset"); },
          "Onset of instability, None without one: reading, time_s, q_kPa, p_eff_kPa,\n"
          "pore_pressure_kPa, axial_strain, eta, their 95 % intervals, detected_at, "
          "total_interval\n"
          "and uncertainty_budget.")
      .def_property_readonly(
          "loss_of_control", [](const StoredTest& t) { return instant_of(t, "loss_of_control"); },
          "Loss of control, None without one: the reading from which the programme could not be\n"
          "maintained. Keys as in onset, without the total uncertainty.")
      .def_property_readonly(
          "states",
          [](StoredTest& test) {
            return table(test, &StoredTest::states, [&](const db::Store& store) {
              return table_of_states(store, test.stored.id);
            });
          },
          "Stresses and strains of every reading, compression positive. Read from the database "
          "once, then kept.")
      .def_property_readonly(
          "readings",
          [](StoredTest& test) {
            return table(test, &StoredTest::readings, [&](const db::Store& store) {
              return table_of_readings(store, test.stored);
            });
          },
          "Every reading as it came from the instruments or the file. Read from the database once, "
          "then kept.")
      .def_property_readonly(
          "second_order_work",
          [](StoredTest& test) {
            return table(test, &StoredTest::work, [&](const db::Store& store) {
              return table_of_work(store, test.stored.id);
            });
          },
          "Second-order work along the measured path: by Eqs. (23), (10), (7) of the paper, and "
          "normalised, in [-1, 1].")
      .def("__repr__", &words_of);
}

}  // namespace

void bind_tests(py::module_& module) {
  bind_test(module);
  py::class_<Database, std::shared_ptr<Database>>(module, "Database",
                                                  "Read-only database of tests. database['CSU 26'] "
                                                  "selects a test by name, database[3] by number.")
      .def(py::init([](const Path& path) {
             const py::gil_scoped_release free;
             auto database = std::make_shared<Database>(path.string());
             warn_of_missing_readings(database->path);
             return database;
           }),
           py::arg("path") = "triax.db")
      .def_property_readonly(
          "path", [](const Database& d) { return d.path; }, "Path of the database file.")
      .def("__getitem__", &numbered, py::arg("test"))
      .def("__getitem__", &found, py::arg("test"))
      .def("__len__",
           [](const std::shared_ptr<Database>& d) {
             return alone(d, [](const db::Store& store) { return store.find({}).size(); });
           })
      .def("__iter__",
           [](const std::shared_ptr<Database>& d) { return py::iter(py::cast(all_of(d))); })
      .def("tests", &all_of,
           "List all tests, oldest first. The tests of a sweep are next to each other.")
      .def(
          "query",
          [](const Database& d, const std::string& sql, double time_limit_s) {
            return rows_of(d.path, sql, time_limit_s);
          },
          py::arg("name_or_sql"), py::arg("time_limit_s") = db::kQueryLimit_s,
          "Return the rows of a named query (triax query --list) or of one SQL statement, as "
          "dicts.\n"
          "The statement cannot change the database.\n"
          "Raises WorkFailed if it computes for longer than time_limit_s.")
      .def("__repr__", [](const Database& d) { return "<triax.Database '" + d.path + "'>"; });
}

}  // namespace triax::python
