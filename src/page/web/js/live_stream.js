// SPDX-License-Identifier: GPL-3.0-or-later
// What is told while a test runs. The browser itself comes back after a break, with the id of the last event it had, and the
// server goes on from there.

const KINDS = ["reading", "event", "forecast", "channels", "stage", "progress", "window", "end"];

/** does: {reading(row), event(e), ..., lost(), back()}. Returns what ends it. */
export function listen(id, after, does) {
  const source = new EventSource(`/api/tests/${id}/live${after === null ? "" : `?after=${after}`}`);
  for (const kind of KINDS)
    source.addEventListener(kind, (event) => {
      does[kind]?.(JSON.parse(event.data));
      if (kind === "end") source.close();
    });
  source.addEventListener("open", () => does.back());
  source.addEventListener("error", () => does.lost(source.readyState === EventSource.CLOSED));
  return () => source.close();
}
