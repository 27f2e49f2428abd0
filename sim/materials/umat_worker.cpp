// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_worker.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <ctime>
#include <new>
#include <stdexcept>

#include "sim/materials/process_confinement.hpp"
#include "sim/materials/umat_process.hpp"

namespace triax::sim {
namespace {

using Clock = std::chrono::steady_clock;

/// How often a process that does not answer is looked after.
constexpr long kLookAfter_ns = 5'000'000;
/// Printed text is cut back when it is longer than this, looked at every so many calls.
constexpr off_t kMostKept = 1 << 20;
constexpr unsigned kLookAtOutput = 1024;
constexpr std::size_t kLastWords = 300;
constexpr int kMostLate = 3;

std::mutex ends_lock;
UmatEnds all_ends;

void note_end(const std::string& words) {
  const std::lock_guard lock(ends_lock);
  if (all_ends.calls++ == 0) all_ends.first = words;
}

std::string system_error(const char* what) {
  return std::string("the process for the UMAT cannot be started (") + what + ": " +
         strerrordesc_np(errno) + ")";
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// One line without control characters.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  const auto doubled = [](char a, char b) { return a == ' ' && b == ' '; };
  text.erase(std::unique(text.begin(), text.end(), doubled), text.end());
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (!text.empty() && text.front() == ' ') text.erase(0, 1);
  return text;
}

}  // namespace

UmatEnds umat_ends() {
  const std::lock_guard lock(ends_lock);
  return all_ends;
}

UmatWorker::UmatWorker(UmatPlugin plugin) : plugin_(std::move(plugin)) {
  void* shared = mmap(nullptr, sizeof(UmatExchange), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error(system_error("mmap"));
  exchange_ = new (shared) UmatExchange;
  const std::string failure = start();
  if (failure.empty()) return;
  munmap(exchange_, sizeof(UmatExchange));
  throw std::invalid_argument(failure);
}

UmatWorker::~UmatWorker() {
  stop();
  munmap(exchange_, sizeof(UmatExchange));
}

std::string UmatWorker::start() {
  sem_init(&exchange_->asked, 1, 0);
  sem_init(&exchange_->answered, 1, 0);
  exchange_->stage = UmatStage::loading;
  exchange_->finish = false;
  exchange_->say("");
  output_ = memfd_create("umat output", MFD_CLOEXEC);
  if (output_ < 0) return system_error("memfd_create");
  fcntl(output_, F_SETFL, O_APPEND);
  hide_from_umats();
  std::array<int, 2> pipe{-1, -1};
  const pid_t made = pipe2(pipe.data(), O_CLOEXEC) == 0 ? fork() : -1;
  if (made == 0) run_umat(plugin_, *exchange_, output_, pipe[0]);
  std::string failure = made < 0 ? system_error("pipe or fork") : "";
  if (pipe[0] >= 0) close(pipe[0]);
  lifeline_ = pipe[1];
  if (made < 0) {
    close_files();
    return failure;
  }
  process_ = made;
  setpgid(made, made);  // either side may be the first to do it
  const Answer answer = wait();
  if (answer != Answer::came) return ended(answer);
  if (exchange_->stage == UmatStage::ready) return {};
  const std::string why = exchange_->said();
  stop();
  return why.find(plugin_.library) == std::string::npos ? plugin_.library + ": " + why : why;
}

UmatWorker::Answer UmatWorker::wait() {
  if (spin_for(exchange_->answered)) return Answer::came;
  const auto deadline = Clock::now() + std::chrono::duration<double>(plugin_.time_limit_s);
  for (;;) {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += kLookAfter_ns;
    if (until.tv_nsec >= 1'000'000'000) {
      until.tv_nsec -= 1'000'000'000;
      ++until.tv_sec;
    }
    if (sem_clockwait(&exchange_->answered, CLOCK_MONOTONIC, &until) == 0) return Answer::came;
    if (errno != ETIMEDOUT) continue;
    const pid_t gone = waitpid(process_, &status_, WNOHANG);
    if (gone != 0) {
      if (gone < 0) status_ = -1;
      kill(-process_, SIGKILL);  // whom it left behind where it could make others
      process_ = 0;
      return sem_trywait(&exchange_->answered) == 0 && exchange_->stage == UmatStage::refused
                 ? Answer::came
                 : Answer::ended;
    }
    if (Clock::now() >= deadline) return Answer::late;
  }
}

std::string UmatWorker::how_late(const char* what) const {
  return std::string(what) + " did not end within " + number(plugin_.time_limit_s) + " s";
}

std::string UmatWorker::ended(Answer answer) {
  std::string text = plugin_.library + ": ";
  if (answer == Answer::late) {
    text += how_late(exchange_->stage == UmatStage::loading ? "loading" : "the call") +
            " and was stopped; if it is only slow, raise time_limit_s";
    kill_group();
    ++late_;
  } else {
    text += why_it_ended();
  }
  if (const std::string words = last_words(); !words.empty()) text += "; it printed: " + words;
  close_files();
  note_end(text);
  return text;
}

void UmatWorker::kill_group() {
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);  // before it was made a group
  waitpid(process_, &status_, 0);
  process_ = 0;
}

void UmatWorker::close_files() {
  for (int* file : {&output_, &lifeline_}) {
    if (*file >= 0) close(*file);
    *file = -1;
  }
}

std::string UmatWorker::how_it_trespassed() const {
  const UmatArguments::Beside where = exchange_->trespass;
  const auto number = static_cast<std::size_t>(where.argument);
  if (number >= kUmatArguments) return "the UMAT wrote over memory that is not its own";
  const UmatArgumentText argument = text_of(where.argument, plugin_);
  const std::string values =
      std::to_string(argument.values) + (argument.values == 1 ? " value" : " values");
  std::string remedy;
  if (where.argument == UmatArgument::statev) remedy = "; check state_variables";
  if (where.argument == UmatArgument::props) remedy = "; check that properties is complete";
  return std::string("the UMAT reads or writes ") +
         (where.behind ? "past the last value of " : "before the first value of ") + argument.name +
         ", which has " + values + remedy;
}

std::string UmatWorker::why_it_ended() const {
  const std::string message = one_line(exchange_->said());
  if (exchange_->stage == UmatStage::trespassed) return how_it_trespassed();
  if (exchange_->stage == UmatStage::xit)
    return "the UMAT called XIT" + (message.empty() ? "" : " (" + message + ")");
  if (exchange_->stage == UmatStage::exited)
    return "the UMAT ended its process (STOP or exit, status " +
           std::to_string(exchange_->exit_status) + ")";
  if (status_ != -1 && WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    const char* name = sigabbrev_np(signal);
    return "the UMAT crashed: SIG" + std::string(name != nullptr ? name : "?") + " (" +
           sigdescr_np(signal) + ")";
  }
  if (status_ != -1 && WIFEXITED(status_))
    return "the process of the UMAT ended with status " + std::to_string(WEXITSTATUS(status_));
  return "the process of the UMAT has ended";
}

std::string UmatWorker::last_words() const {
  struct stat file {};
  if (output_ < 0 || fstat(output_, &file) != 0 || file.st_size == 0) return {};
  const auto length = std::min<std::size_t>(static_cast<std::size_t>(file.st_size), kLastWords);
  std::string text(length, '\0');
  const auto from = file.st_size - static_cast<off_t>(length);
  const ssize_t got = pread(output_, text.data(), length, from);
  text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return one_line(text);
}

void UmatWorker::shorten_output() const {
  struct stat file {};
  if (fstat(output_, &file) == 0 && file.st_size > kMostKept && ftruncate(output_, 0) != 0) return;
}

std::string UmatWorker::call(UmatCall& c) {
  const std::lock_guard lock(mutex_);
  if (late_ == kMostLate)
    return plugin_.library + ": " + how_late("each of three calls") + "; it is not called again";
  if (process_ == 0)
    if (std::string failure = start(); !failure.empty()) return failure;
  UmatCall& there = exchange_->call;
  there.stress = c.stress;
  there.strain = c.strain;
  there.strain_increment = c.strain_increment;
  there.time = c.time;
  there.time_step = c.time_step;
  there.increment = c.increment;
  const auto used = static_cast<std::ptrdiff_t>(plugin_.state_variables);
  std::copy(c.state.begin(), c.state.begin() + used, there.state.begin());
  sem_post(&exchange_->asked);
  const Answer answer = wait();
  if (answer != Answer::came) return ended(answer);
  if (exchange_->stage == UmatStage::objected) {
    exchange_->stage = UmatStage::ready;
    return plugin_.library + ": " + one_line(exchange_->said());
  }
  c.stress = there.stress;
  c.tangent = there.tangent;
  c.smaller = there.smaller;
  std::copy(there.state.begin(), there.state.begin() + used, c.state.begin());
  if (++calls_ % kLookAtOutput == 0) shorten_output();
  return {};
}

void UmatWorker::stop() {
  if (process_ != 0) {
    exchange_->finish = true;
    sem_post(&exchange_->asked);
    int gone = 0;
    for (int i = 0; i < 200 && gone == 0; ++i) {
      gone = waitpid(process_, &status_, WNOHANG);
      if (gone == 0) usleep(i < 20 ? 50 : 1000);
    }
    if (gone == 0) kill_group();
    process_ = 0;
  }
  close_files();
}

}  // namespace triax::sim
