# SPDX-License-Identifier: GPL-3.0-or-later
"""However much is asked for, a test that runs is stopped at once."""
import sqlite3
import threading
import time

from opened import Opened, same, within

with Opened() as page:
    page.enter()
    run = page.post("/api/runs", {"programme": "icu_6", "speed": 60})[1]["test"]
    # Nobody else may write: what begins waits, and takes all that work with it.
    other = sqlite3.connect(page.database, isolation_level=None)
    other.execute("BEGIN IMMEDIATE")
    answers = []
    slow = [threading.Thread(target=lambda: answers.append(page.post("/api/runs", {"programme": "icu_6", "speed": 60})[0])) for _ in range(4)]
    for one in slow:
        one.start()
    time.sleep(1.5)
    same("requests that were answered meanwhile", answers, [])
    for order in ("hold", "stop"):
        begun = time.monotonic()
        status, _ = page.post(f"/api/runs/{run}/{order}", {"who": "Anna"})
        within(f"seconds to an answer to {order}", time.monotonic() - begun, 0, 1)
        same(order, status, 200)
        time.sleep(0.5)
    same("requests that were answered meanwhile", answers, [])
    other.execute("ROLLBACK")
    other.close()
    for one in slow:
        one.join()
    same("what began later", answers, [200] * 4)
print("orders: at once")
