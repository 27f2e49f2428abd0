// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "db/recording/patience.hpp"
#include "db/recording/turns.hpp"
#include "db/store.hpp"
#include "lab/rig/session_listener.hpp"
#include "lab/warning/earlier_tests.hpp"

namespace triax::db {

/// Writes one running test into the database while it runs, in short transactions on a thread of
/// its own, so that others can read meanwhile and a kill at any instant loses at most the last
/// second.
///
/// Nothing is touched on disk before the first batch is due (about half a second, or some ten
/// thousand scans, or finish): bad input that shows up early leaves the database, and even its
/// absence, as it was.
///
/// While the database takes nothing (the lock of another program, a full disk), batches wait in
/// memory and in a file beside it (db/recording/spool.hpp), then the session waits, until it takes
/// them again. Nothing is lost as long as Patience::most; after that, and after a kill, `triax
/// tests repair` takes in what the file holds.
///
/// Files of the database that are renamed, removed or replaced meanwhile are noticed within a
/// second: the whole test goes into the file beside it, and at its end into the database that is
/// there then, a new one where there is none.
///
/// All calls come from one thread. What goes wrong while writing (folder
/// missing, file of another program) is thrown as lab::WorkFailed or lab::BadInput by finish(), or
/// earlier out of what the session tells next; batches committed before stand until discard().
class Recorder {
 public:
  /// `writer` names the lease of the test (db/recording/lease.hpp); empty: a random name. Another
  /// process that knows the name can remove what a killed recorder left: discard_left_test().
  /// Throws lab::BadInput where no database can be at that path, before the test starts.
  explicit Recorder(std::string path, Patience patience = {}, const std::string& writer = {});
  ~Recorder();  ///< a test that was not finished stays behind as interrupted
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Says of which sweep the test is one; before it starts. The test then enters the database with
  /// its first reading, when those of all earlier places have entered or are over: ids follow the
  /// order of the sweep, however many threads run it. `turns` must outlive this recorder; who runs
  /// the test says when its turn is over, in case it never enters.
  void belongs_to(SweepMembership sweep, Turns& turns);
  /// Says what the alarm of the test knows, for later corrections (db/corrections/correction.hpp);
  /// before the test starts.
  void knows(const lab::EarlierTests& earlier);
  /// `use` is told the test's id as soon as it has entered the database, which is then with its
  /// first reading; in the recorder's own thread. Before the test starts.
  void when_entered(std::function<void(std::int64_t)> use);
  /// What a session tells, into the database; as long as this recorder lives.
  lab::SessionListener listener();
  /// The test is over: stores the summary, marks it complete; gives its id. Throws lab::WorkFailed
  /// if no test was started.
  std::int64_t finish(const lab::TestSummary& summary);
  /// Of the database that has the test, after finish(): in the new place of its folder where that
  /// was renamed.
  const std::string& path() const;
  /// The input was bad: takes out whatever of this test had been written, and the file if this
  /// recorder made it and nobody else uses it. Does nothing after finish().
  void discard();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace triax::db
