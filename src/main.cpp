// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/Error.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "sim/materials/umat_worker.hpp"
#include "src/cli/application.hpp"
#include "src/cli/candidates.hpp"
#include "src/cli/ended_early.hpp"
#include "src/cli/manual.hpp"
#include "src/cli/renamed_options.hpp"
#include "src/cli/usage_error.hpp"
#include "src/commands.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/output/written_files.hpp"
#include "src/page/record/record_process.hpp"

namespace {

constexpr int kDone = 0, kFailed = 1, kBadInput = 2;

// A closed standard error must not turn a clear status into an abort, as an exception here would.
int complain(const std::string& message, int status) {
  std::fprintf(stderr, "%s %s\n", triax::src::alarming("triax:", stderr).c_str(),
               triax::src::on_one_line(message).c_str());
  return status;
}

/// The number of a standard stream that is closed would be given to the next file that is opened,
/// and what is printed would stand in that. Nothing can be written to what is open for reading.
void keep_numbers_of_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1) static_cast<void>(open("/dev/null", O_RDONLY));
}

/// Whether there is room to work in: without it the program would end by a signal anywhere. By the
/// plainest means, which need little of it themselves.
bool has_enough_stack() {
  constexpr rlim_t kMinStack = rlim_t{1} << 20U;  // commands were seen to need up to 128 kB
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= kMinStack) return true;
  constexpr std::string_view kWords =
      "triax: the stack is limited to less than 1 MB (ulimit -s), which is not enough; allow more "
      "with ulimit -s 8192\n";
  static_cast<void>(!write(STDERR_FILENO, kWords.data(), kWords.size()));
  return false;
}

/// What was written is said whether or not the command succeeded, before the error if it did not.
void announce() {
  if (const std::string text = triax::src::take_announcement(); !text.empty())
    std::fprintf(stderr, "triax: %s\n", triax::src::on_one_line(text).c_str());
}

/// For the build, which installs the manual, and for the shells' completion; no command for users.
bool run_hidden(const triax::src::Application& application,
                const std::vector<std::string>& arguments) {
  using namespace triax;
  if (arguments.size() < 2) return false;
  if (arguments[0] == "--write-manual") {
    src::write_manual(*application.app, src::commands(), arguments[1]);
  } else if (arguments[0] == "--complete") {
    src::print(src::candidates(arguments[1], arguments.size() > 2 ? arguments[2] : "triax.db"));
  } else {
    return false;
  }
  static_cast<void>(src::take_announcement());
  return true;
}

int run(int argc, char** argv) {
  using namespace triax;
  const src::Application application = src::make_application(src::commands());
  const auto arguments = src::with_names_of_today({argv + std::min(1, argc), argv + argc});
  if (run_hidden(application, arguments)) return kDone;
  try {
    // The library takes them from the last to the first.
    application.app->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    const int status = application.app->exit(success, text, text);
    src::print(text.str());
    return status;
  } catch (const CLI::ParseError& error) {
    return complain(src::usage_message(*application.app, error, arguments), kBadInput);
  }
  if (!*application.run) {
    std::fputs(application.app->help().c_str(), stderr);
    return complain(src::missing_command(*application.app), kBadInput);
  }
  (*application.run)();
  if (const sim::UmatEnds ends = sim::umat_ends(); ends.calls > 0)
    throw lab::WorkFailed(
        fmt::format("{} ({} failed; results that depend on {} are missing)", ends.first,
                    ends.calls == 1 ? "a UMAT call" : fmt::format("{} UMAT calls", ends.calls),
                    ends.calls == 1 ? "it" : "them"));
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  if (!has_enough_stack()) return kFailed;
  keep_numbers_of_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is for us to see, not a death amid a transaction
  std::signal(SIGXFSZ, SIG_IGN);  // nor is a limit on the size of files: writing fails with EFBIG
  try {
    if (argc > 1 && argv[1] == std::string_view(triax::src::kReadRecordCommand))
      triax::src::run_record_process({argv + 2, argv + argc});
    const int status = run(argc, argv);
    announce();
    return status;
  } catch (const triax::src::ClosedPipe&) {
    announce();
    return kDone;
  } catch (const triax::src::EndedEarly& end) {
    announce();
    return complain(end.what(), end.status());
  } catch (const triax::lab::BadInput& error) {
    announce();
    return complain(error.what(), kBadInput);
  } catch (const std::exception& error) {
    announce();
    return complain(error.what(), kFailed);
  }
}
