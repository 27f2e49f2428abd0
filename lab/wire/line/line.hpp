// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The controller's side of a line: asks one exchange after the other, each with a deadline.
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lab/wire/exchange.hpp"
#include "lab/wire/line/line_loop.hpp"
#include "lab/wire/link_address.hpp"

namespace triax::lab {

class ByteLine;
class TcpConnector;

/// What became of an exchange.
struct Asked {
  enum class Kind {
    answered,   ///< `values` or `text`; nothing where no answer was wanted
    late,       ///< the deadline came first
    malformed,  ///< `why`: what came instead
    closed      ///< `why` the line is down
  };
  Kind kind = Kind::closed;
  std::vector<double> values{};
  std::string text{};
  std::string why{};       ///< empty if answered
  double sent_s = 0;       ///< when the question left, on the loop's clock; 0: it never did
  double answered_s = 0;   ///< when the last byte of the answer came
  std::size_t length = 0;  ///< of the answer, bytes
  bool trailing = false;   ///< more bytes had come behind the answer to a question
};

struct LineTimes {
  double pause_s = 0;     ///< from the end of one exchange to the next question
  double owed_s = 1;      ///< how long after its deadline an answer may still come
  double quiet_s = 0.05;  ///< a serial line silent for so long is at a border between answers
};

/// One instrument's line. No answer is ever taken for that to another question:
/// - what came before a question is thrown away when it is asked. (What an instrument says to a
///   message of which `answered` denies it may still come behind the next question.)
/// - an answer that is late is awaited for owed_s more and thrown away, and questions wait
/// meanwhile
///   (their own deadlines run). If it does not come, a TCP line is closed; a serial line, which has
///   no end, is asked again: there owed_s is the most that an answer may be late;
/// - behind bytes of which no answer can be made out (Exchange::whole throws) a TCP line is closed;
///   a serial line is asked again when it has been quiet. A whole answer that says nothing
///   (Exchange::values throws), or that more bytes follow, closes nothing; a serial line is then
///   asked again when it has been quiet, too.
/// An exchange without a request takes what the instrument says unasked: the next whole answer that
/// comes after it was asked; the first after opening is thrown away, since it may be a part.
/// Handlers are called from the loop, and from open() and close() as said there. They may ask, open
/// and close, but not end the life of the line.
class Line {
 public:
  Line(LineLoop& loop, LinkAddress link, const LineTimes& times = {});
  ~Line();
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  const LinkAddress& link() const { return link_; }
  bool is_open() const { return line_ != nullptr; }
  std::size_t waiting() const { return queue_.size(); }

  /// Closes what is open and connects anew, until `deadline_s` on the loop's clock. `opened` gets
  /// an empty text, or why not: "Connection refused". A handler that asks at once is heard.
  void open(double deadline_s, std::function<void(const std::string& why)> opened);
  /// Asks when those before are done. `done` is called once, by the deadline or as soon after as
  /// the loop runs; an answer that is read after the deadline is late. It owns what it needs: a
  /// caller that waits may return before it is called.
  void ask(Exchange exchange, double deadline_s, std::function<void(const Asked&)> done);
  /// Drops all exchanges without a call; an answer under way is awaited as a late one.
  void cancel();
  /// All exchanges are done, as closed, before this returns; so is an opening under way.
  void close(const std::string& why = "closed by us");
  /// Called, after the exchanges, when a line that was open is lost by itself.
  void on_lost(std::function<void(const std::string& why)> lost) { lost_ = std::move(lost); }

 private:
  struct Pending {
    Exchange exchange;
    double deadline_s;
    std::function<void(const Asked&)> done;
    double sent_s = 0;
    LineTimer deadline{};
  };
  using Entry = std::shared_ptr<Pending>;
  enum class State {
    idle,
    asked,    ///< the front of the queue is under way
    owed,     ///< the answer to `owed_` is late
    resyncs,  ///< until the line is quiet
    pauses
  };

  void take_up(std::unique_ptr<ByteLine> line);
  void opened_as(const std::string& why);
  void heard(std::string_view bytes);
  /// Length of the answer to `exchange` at the front of what came; 0: none yet, or unreadable().
  std::size_t whole(const Exchange& exchange);
  void unreadable(const std::string& what);
  void read_answer();
  void next();
  void send_front();
  void drop_old_answers(const Exchange& exchange);
  void at_deadline(const Entry& entry);
  void owe(Exchange exchange);
  void give_up_owed();
  void rest(State state, double seconds);
  Entry take_front();
  void lose(const std::string& why);
  void drop_line();

  LineLoop& loop_;
  LinkAddress link_;
  LineTimes times_;
  std::unique_ptr<ByteLine> line_;
  std::unique_ptr<TcpConnector> connector_;
  std::function<void(const std::string&)> opened_;
  std::function<void(const std::string&)> lost_;
  LineTimer opening_, rest_;
  std::deque<Entry> queue_;
  State state_ = State::idle;
  Exchange owed_;
  std::string received_;
  bool part_ = true;  ///< received_ may begin in the middle of an answer
};

}  // namespace triax::lab
