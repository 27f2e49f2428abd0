// SPDX-License-Identifier: GPL-3.0-or-later
// What the page asks of the server that served it. Failures are errors with the server's own words.

async function answer(response) {
  const text = await response.text();
  let body = null;
  try {
    body = text ? JSON.parse(text) : null;
  } catch {
    body = null;
  }
  if (!response.ok) throw Object.assign(new Error(body?.error ?? (text.slice(0, 300) || `the server answered ${response.status}`)), { status: response.status });
  return body;
}

async function asked(path, options) {
  let response;
  try {
    response = await fetch(path, { credentials: "same-origin", cache: "no-store", ...options });
  } catch (failure) {
    if (failure.name === "AbortError") throw failure;
    throw new Error("no answer: is \"triax open\" still running?");
  }
  return answer(response);
}

export const get = (path, signal) => asked(path, { signal });

export const post = (path, body, signal) =>
  asked(path, { method: "POST", signal, headers: { "X-Triax": "1", "Content-Type": "application/json" }, body: JSON.stringify(body) });

/** The bytes of a record file, with what the file does not say: values by key, a dialect (TOML), the worksheet of a workbook. `task` is "" to
 *  read it, "/proposal" for what its columns may be, "/preview" for its stress path. */
export function postRecord(file, { sets = {}, dialect = "", worksheet = "" }, task = "", { name = file.name, signal } = {}) {
  const query = new URLSearchParams({ name });
  for (const [key, value] of Object.entries(sets)) query.append("set", `${key}=${value}`);
  for (const line of dialect ? dialect.split("\n") : []) query.append("dialect", line);
  if (worksheet) query.set("worksheet", worksheet);
  return asked(`/api/records${task}?${query}`,
    { method: "POST", signal, headers: { "X-Triax": "1", "Content-Type": "application/octet-stream" }, body: file });
}

export const windowPath = (id, columns, { from, to, pixels, work = false }) => {
  const query = new URLSearchParams({ pixels: String(Math.max(50, Math.round(pixels))), columns: columns.join(",") });
  if (work) query.set("work", "1");
  if (Number.isFinite(from)) query.set("from", String(Math.floor(from)));
  if (Number.isFinite(to)) query.set("to", String(Math.ceil(to)));
  return `/api/tests/${id}/window?${query}`;
};
