// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog of one file: its first rows, what each column is, values that it lacks, and the stress path that follows.
import { post, postRecord } from "./api.js";
import { Chart } from "./chart.js";
import { el, field, fill, fresh, select } from "./dom.js";
import { assumption } from "./format.js";
import { ImportColumns } from "./import_columns.js";
import { failed } from "./notice.js";

const WAIT_MS = 150;
/** A preview of a longer text is that of its beginning. */
const PREVIEW_BYTES = 4 * 2 ** 20;
const BACK_PRESSURE = "back_pressure";
/** With one of these columns, a constant back pressure is only that. */
const HAS_PORE_PRESSURE = ["pore_pressure", "excess_pore_pressure", "axial_force"];
/** Values of the file before, by key: offered first. */
const lastValues = new Map();

/** The file, or its first lines. A workbook cannot be divided. */
async function beginningOf(file) {
  const isArchive = new TextDecoder("latin1").decode(await file.slice(0, 2).arrayBuffer()) === "PK";
  if (isArchive || file.size <= PREVIEW_BYTES) return { part: file, isWhole: true };
  const bytes = new Uint8Array(await file.slice(0, PREVIEW_BYTES).arrayBuffer());
  const end = bytes.lastIndexOf(10);
  return { part: file.slice(0, end > 0 ? end + 1 : PREVIEW_BYTES), isWhole: false };
}

/** The file and its folder. */
const shortPath = (path) => path.split("/").slice(-2).join("/");

class ValueFields {
  constructor(proposal, table, changed) {
    this.changed = changed;
    this.inputs = new Map();
    this.node = el("div", { class: "values" });
    for (const { key, label, unit, usual } of proposal.values)
      this.add(key, `${label} (${unit})`, usual, table.stated[key], table.asked.includes(key));
  }

  add(key, label, usual, stated, isAsked) {
    const offered = [...new Set([lastValues.get(key), ...usual.map(String)].filter((value) => value !== undefined))];
    const list = el("datalist", { id: fresh("usual") }, offered.map((value) => el("option", { value })));
    const input = el("input", { name: key, inputmode: "decimal", autocomplete: "off", list: list.id, placeholder: offered.length ? `e.g. ${offered[0]}` : null,
      value: stated === undefined ? "" : String(Number(stated.toPrecision(6))), on: { input: () => this.changed() } });
    const node = field(label, input, list);
    node.classList.toggle("asked", isAsked);
    this.inputs.set(key, { input, node });
    this.node.append(node);
  }

  /** Keys that the reduction needs are marked, and added if they are not among the usual ones. */
  showMissing(missing) {
    for (const { key, label, unit } of missing)
      if (!this.inputs.has(key)) this.add(key, `${label ?? key}${unit ? ` (${unit})` : ""}`, [], undefined, true);
    for (const [key, { input, node }] of this.inputs)
      if (missing.some((one) => one.key === key) && !input.value) node.classList.add("asked");
  }

  values() {
    return Object.fromEntries([...this.inputs].map(([key, { input }]) => [key, input.value.trim().replace(",", ".")]).filter(([, value]) => value !== ""));
  }
}

/** The kind of a test in total stresses, if the file does not have it. */
class KindOfTest {
  constructor(table, changed) {
    this.value = "";
    const question = table.questions.find(({ about }) => about === "programme");
    this.node = question ? field(question.text, select([["", "choose…"], ...question.answers.map(({ value, text }) => [value, `${value}: ${text}`])], "", (value) => {
      this.value = value;
      changed();
    })) : null;
    this.node?.classList.add("asked");
  }

  get isDrained() {
    return this.value === "drained";
  }

  programme() {
    return this.isDrained || this.value === "" ? null : this.value;
  }
}

class ImportForm {
  /** `propose(worksheet)` gives the proposal for another worksheet. */
  constructor(file, proposal, propose) {
    Object.assign(this, { file, proposal, propose, block: 0, remembered: false, answer: null });
    this.title = fresh("import");
    this.chart = new Chart({ title: "Stress path from the present choices", height: 230, x: { title: "p′ (kPa)" }, y: { title: "q (kPa)" }, cursor: false, nothing: "no stress path yet" });
    this.status = el("div", { class: "import-status", role: "status" });
    this.top = el("div", { class: "stack" });
    this.valuesRoom = el("div");
    this.read = el("button", { type: "button", class: "main", on: { click: () => this.readFile() } }, "Read");
    this.remember = el("button", { type: "button", class: "remember", on: { click: () => this.rememberChoices() } }, "Remember for files like this");
    this.node = el("dialog", { class: "import", "aria-labelledby": this.title }, el("div", { class: "import-body" },
      this.top,
      el("div", { class: "import-lower" }, el("div", { class: "path" }, this.chart.node), el("div", { class: "stack" }, this.valuesRoom, this.status))),
    el("div", { class: "row buttons" }, el("button", { type: "button", on: { click: () => this.node.close() } }, "Cancel"), this.remember, this.read));
    this.build();
  }

  get table() {
    return this.proposal.tables[this.block];
  }

  build() {
    const changed = () => this.later();
    this.columns = new ImportColumns(this.table, this.proposal.quantities, changed);
    this.values = new ValueFields(this.proposal, this.table, changed);
    this.kind = new KindOfTest(this.table, changed);
    this.remember.disabled = !this.proposal.key;
    this.remember.title = this.proposal.key ? "" : "A table without headings cannot be recognised again";
    fill(this.valuesRoom, el("h3", {}, "Values that the file may lack"), this.kind.node, this.values.node);
    fill(this.top, this.head(), this.questions(), this.columns.node);
    this.later(0);
  }

  head() {
    const { encoding, separator, decimal, worksheets, worksheet, tables, remembered } = this.proposal;
    const facts = worksheets?.length ? "workbook" : `${encoding}, separator ${separator}, decimal ${decimal === "," ? "comma" : "point"}`;
    return el("div", { class: "row facts" }, el("h2", { id: this.title, tabindex: -1 }, this.file.name), el("span", { class: "quiet" }, `${facts}, ${this.table.columns.length} columns${remembered ? `; read as remembered in ${shortPath(remembered)}` : ""}`),
      worksheets?.length > 1 ? field("Worksheet", select(worksheets.map((name) => [name, name]), worksheet, (name) => this.changeWorksheet(name))) : null,
      tables.length > 1 ? field("Table", select(tables.map((_, i) => [String(i), `${i + 1} of ${tables.length}`]), String(this.block), (i) => {
        this.block = Number(i);
        this.build();
      })) : null);
  }

  questions() {
    const { questions } = this.table;
    if (questions.length === 0) return null;
    return el("ul", { class: "questions" }, questions.map(({ text, explanation, column }) => el("li", {},
      column > 0 ? el("button", { type: "button", class: "plain", on: { click: () => this.columns.focus(column) } }, text) : el("strong", {}, text), " ", el("span", { class: "quiet" }, explanation))));
  }

  async changeWorksheet(name) {
    try {
      const proposal = await this.propose(name);
      if (proposal.error) throw new Error(proposal.error);
      Object.assign(this, { proposal, block: 0 });
      this.build();
    } catch (failure) {
      fill(this.status, failed(failure));
    }
  }

  /** The choices, as the server writes a dialect from them. */
  choices() {
    const { encoding, separator, decimal, thousands, worksheet } = this.proposal;
    const columns = this.columns.values();
    const constants = {};
    const back = this.values.values()[BACK_PRESSURE];
    // Without a column of it, the pore pressure of a reduced table is the back pressure.
    const isPore = !columns.some((column) => HAS_PORE_PRESSURE.includes(column.quantity));
    if (this.kind.isDrained) constants.pore_pressure = 0;
    if (back !== undefined) constants[isPore ? "pore_pressure" : BACK_PRESSURE] = Number(back);
    return { name: this.file.name.replace(/\.[^.]*$/, ""), encoding: worksheet ? null : encoding, separator, decimal, thousands, worksheet, block: this.table.block,
      programme: this.kind.programme(), columns, values: constants };
  }

  async options(signal) {
    const { [BACK_PRESSURE]: back, ...sets } = this.values.values();
    if (back !== undefined && !Number.isFinite(Number(back))) throw new Error(`constant back pressure: ${back} is not a number`);
    const { dialect } = await post("/api/dialects", this.choices(), signal);
    return { sets, dialect };
  }

  later(wait = WAIT_MS) {
    clearTimeout(this.timer);
    this.stop?.abort();
    this.chart.node.classList.add("old");
    this.timer = setTimeout(() => this.preview(), wait);
  }

  async preview() {
    const stop = (this.stop = new AbortController());
    if (this.columns.values().length === 0) return this.show({ error: "Choose the quantity of each column that is used." }, true);
    try {
      const options = await this.options(stop.signal);
      const { part, isWhole } = await beginningOf(this.file);
      const found = await postRecord(part, options, "/preview", { name: this.file.name, signal: stop.signal });
      if (!stop.signal.aborted) this.show(found, isWhole);
    } catch (failure) {
      if (failure.name === "AbortError" || stop.signal.aborted) return;
      this.show({ error: failure.message }, true);
    }
  }

  show({ error, missing = [], guessed = [], warnings = [], readings, path, tests = 1, shown = 1 }, isWhole) {
    this.chart.node.classList.remove("old");
    this.chart.set(path ? [{ kind: "line", x: path.p_eff_kPa, y: path.q_kPa, colour: "blue" }, { kind: "mark", shape: "dot", x: path.p_eff_kPa[0] ?? null, y: path.q_kPa[0] ?? null, colour: "blue" }]
      : [{ kind: "line", x: [], y: [] }]);
    this.values.showMissing(missing);
    const notes = [...guessed.map(assumption), ...warnings];
    fill(this.status, error ? el("p", { class: "notice bad" }, error) : missing.length ? el("p", { class: "notice" }, `Missing: ${missing.map(({ label, key }) => label ?? key).join(", ")}.`)
      : el("p", { class: "quiet" }, `${tests > 1 ? `${tests} tests, all are read. Test ${shown}: ` : ""}${readings} readings${isWhole ? "" : " at the beginning of the file"}; the dot is the first.`),
    notes.length ? el("details", {}, el("summary", {}, `Assumed or not used (${notes.length})`), el("ul", { class: "quiet" }, notes.map((text) => el("li", {}, text)))) : null);
  }

  async busy(button, work) {
    button.disabled = true;
    try {
      await work();
    } catch (failure) {
      fill(this.status, failed(failure));
    } finally {
      button.disabled = false;
    }
  }

  rememberChoices() {
    return this.busy(this.remember, async () => {
      const { file } = await post("/api/dialects", { ...this.choices(), key: this.proposal.key });
      this.remembered = true;
      fill(this.status, el("p", { class: "notice" }, `Remembered in ${shortPath(file)}. Files with these headings are read so from now on; values of the specimen are not remembered.`));
      this.status.scrollIntoView({ block: "nearest" });
    });
  }

  readFile() {
    return this.busy(this.read, async () => {
      const answer = await postRecord(this.file, await this.options());
      if (answer.test === null || answer.test === undefined) return this.show({ error: answer.error, missing: answer.missing, guessed: answer.guessed, warnings: answer.warnings }, true);
      this.answer = answer;
      for (const [key, value] of Object.entries(this.values.values())) lastValues.set(key, value);
      this.node.close();
    });
  }
}

/** Resolves once the dialog is closed: {answer} of the server if the file was read, {remembered} if a dialect was stored. */
export function importDialog(file, proposal, propose) {
  return new Promise((resolve) => {
    const form = new ImportForm(file, proposal, propose);
    form.node.addEventListener("close", () => {
      clearTimeout(form.timer);
      form.stop?.abort();
      form.chart.end();
      form.node.remove();
      resolve({ answer: form.answer, remembered: form.remembered });
    });
    document.body.append(form.node);
    form.node.showModal();
    form.node.querySelector("h2").focus();
  });
}
