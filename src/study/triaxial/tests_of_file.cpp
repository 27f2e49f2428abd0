// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/tests_of_file.hpp"

#include <utility>

namespace triax::study {

lab::RecordOptions TestOfFile::options(lab::RecordOptions of_file) const {
  of_file.test = number;
  of_file.tests = all;
  return of_file;
}

std::vector<TestOfFile> tests_of(lab::TestsInFile tests) {
  const auto all = std::make_shared<const lab::TestsInFile>(std::move(tests));
  if (all->names.empty()) return {{.all = all}};
  std::vector<TestOfFile> out;
  for (std::size_t number = 1; number <= all->names.size(); ++number) out.push_back({number, all});
  return out;
}

TestOfFile test_of_block(const std::vector<TestOfFile>& tests, std::size_t block) {
  for (const TestOfFile& test : tests)
    if (test.all && !test.all->tables.empty() && test.all->tables[test.number - 1].block == block)
      return test;
  return tests.front();
}

std::vector<TestOfFile> tests_in_all_rows(const FindTests& find, const lab::SeveralTests& error) {
  auto tests = tests_of(find(lab::Extent::whole));
  if (tests.size() < 2) throw lab::SeveralTests(error);
  return tests;
}

void read_tests(const FindTests& find, const std::function<void(const TestOfFile&)>& read,
                const std::function<void(const lab::BadInput&)>& on_fault) {
  auto tests = tests_of(find(lab::Extent::sample));
  if (tests.size() == 1) try {
      return read(tests.front());
    } catch (const lab::SeveralTests& error) {
      if (tests.front().number > 0) throw;
      tests = tests_in_all_rows(find, error);
    }
  for (const TestOfFile& test : tests) try {
      read(test);
    } catch (const lab::BadInput& error) {
      on_fault(error);
    }
}

}  // namespace triax::study
