// SPDX-License-Identifier: GPL-3.0-or-later
// The first rows of a table as the file has them, with a choice of quantity, unit and sign above each column.
import { el, fill, select } from "./dom.js";

const UNUSED = ["", "not used"];
const ORDERS = [["", "order found"], ["day first", "day first"], ["month first", "month first"], ["year first", "year first"]];
const HAS_DATE = ["time", "date"];
/** What the readings of a gauge can become. */
const OF_GAUGE = ["axial_force", "axial_displacement"];

const titleOf = ({ name, symbol }) => `${name.replaceAll("_", " ")}${symbol ? ` ${symbol}` : ""}`;

class ColumnChoice {
  /** `asked`: what the questions about the column are about. */
  constructor(column, quantities, asked, changed) {
    const isAsked = asked.length > 0;
    Object.assign(this, { column, quantities, isAsked, changed, factor: column.factor, isGauge: column.factor !== 1 || asked.includes("factor"), unitOfFile: column.heading && !isAsked ? "as in file" : "choose…" });
    this.quantity = column.quantity ?? "";
    this.unit = column.unit;
    this.sign = column.sign;
    this.order = column.date_order ?? "";
    this.more = el("div", { class: "more" });
    this.node = el("th", { scope: "col" }, this.heading(), this.quantityList(), this.more);
    this.showMore();
  }

  name() {
    return `column ${this.column.position}${this.column.heading ? ` ${this.column.heading}` : ""}`;
  }

  heading() {
    const { position, heading, unit_below: below, evidence } = this.column;
    return el("div", { class: "heading", title: evidence || null }, el("span", { class: "quiet" }, position), " ", heading || "no heading", below ? el("span", { class: "quiet" }, ` ${below}`) : null);
  }

  quantityList() {
    const list = select([UNUSED, ...this.quantities.map((q) => [q.name, titleOf(q)])], this.quantity, (value) => {
      this.quantity = value;
      this.showMore();
      this.changed();
    });
    list.setAttribute("aria-label", `quantity of ${this.name()}`);
    this.list = list;
    return list;
  }

  units() {
    const known = this.quantities.find((q) => q.name === this.quantity)?.units ?? [];
    if (this.unit && !known.includes(this.unit) && this.quantity !== this.column.quantity) this.unit = "";
    const all = this.unit && !known.includes(this.unit) ? [this.unit, ...known] : known;
    return [["", this.unitOfFile], ...all.map((unit) => [unit, unit])];
  }

  part(title, choices, value, set) {
    const list = select(choices, value, (chosen) => {
      set(chosen);
      this.changed();
    });
    list.setAttribute("aria-label", `${title} of ${this.name()}`);
    return list;
  }

  hasFactor() {
    return this.isGauge && OF_GAUGE.includes(this.quantity);
  }

  factorInput() {
    return el("input", { class: "factor", inputmode: "decimal", autocomplete: "off", value: this.factor === 1 ? "" : String(this.factor), placeholder: "× 1 per reading", "aria-label": `factor of ${this.name()}`,
      on: { input: ({ target }) => {
        this.factor = target.value.trim() === "" ? 1 : Number(target.value.trim().replace(",", "."));
        this.changed();
      } } });
  }

  /** What a column that is not used does not need. */
  showMore() {
    this.node.className = [this.quantity ? "" : "unused", this.isAsked ? "asked" : ""].join(" ").trim();
    const units = this.units();
    const isDate = this.column.clock && HAS_DATE.includes(this.quantity);
    fill(this.more, this.quantity === "" ? null : [
      units.length > 1 && !this.column.clock ? this.part("unit", units, this.unit, (value) => (this.unit = value)) : null,
      units.length > 1 && !this.column.clock ? this.part("sign", [["1", "+"], ["-1", "−"]], String(this.sign), (value) => (this.sign = Number(value))) : null,
      this.hasFactor() ? this.factorInput() : null,
      isDate ? this.part("order of dates", ORDERS, this.order, (value) => (this.order = value)) : null]);
  }

  value() {
    if (this.quantity === "") return null;
    return { quantity: this.quantity, position: this.column.position, unit: this.column.clock ? "" : this.unit, sign: this.sign, factor: this.hasFactor() ? this.factor : 1, date_order: this.order || null };
  }
}

export class ImportColumns {
  /** `table` is one of a proposal; `changed()` is called after each choice. */
  constructor(table, quantities, changed) {
    const asked = (column) => table.questions.filter((question) => question.column === column.position).map((question) => question.about);
    this.choices = table.columns.map((column) => new ColumnChoice(column, quantities, asked(column), changed));
    this.node = el("div", { class: "scroll rows", tabindex: 0, role: "group", "aria-label": "First rows of the file" }, el("table", {},
      el("thead", {}, el("tr", {}, this.choices.map((choice) => choice.node))),
      el("tbody", {}, table.rows.map((row) => el("tr", {}, row.map((cell) => el("td", { class: "number" }, cell)))))));
  }

  focus(position) {
    const choice = this.choices.find((one) => one.column.position === position);
    choice?.node.scrollIntoView({ inline: "center", block: "nearest" });
    choice?.list.focus();
  }

  values() {
    return this.choices.map((choice) => choice.value()).filter(Boolean);
  }
}
