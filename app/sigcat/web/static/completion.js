// Completion of paths, units and datatypes in a text, by the list of the W3C's ARIA guide. Without it one types the whole.
import { say } from "./asking.js";

const SHOWN = 9; // at once; the list moves with what is chosen, and needs no scrolling
const LINE = 20; // as the style sheet has it
const EDGE = 12;

/** What stands before the caret and asks for a completion: (kind, what is typed of it). */
const KEY = ["path", /^["']?([A-Za-z]\w*(?:\.\w*)*)$/];
const ASKED = {
  overlay: [KEY],
  tree: [KEY],
  function: [["path", /\bpath:\s*["']?([A-Za-z]\w*(?:\.\w*)*)$/], ["path", /^\s+["']?([A-Za-z]\w*\.[\w.]*)$/]],
};
const EVERYWHERE = [["unit", /\bunit:\s*["']?([^\s,}"'#]*)$/], ["datatype", /\bdatatype:\s*["']?([\w.[\]]*)$/]];

/** What is offered, in the order of the catalogue: names that begin with what is typed before those that hold it. */
const fitting = (offers, typed) => {
  const sought = typed.toLowerCase();
  const begin = offers.filter(({ name }) => name.toLowerCase().startsWith(sought));
  const hold = offers.filter(({ name, words = "" }) => !name.toLowerCase().startsWith(sought) && `${name} ${words}`.toLowerCase().includes(sought));
  return [...begin, ...(sought ? hold : [])];
};

/** Branches that a text writes right below another one: a tree has no others. */
const writtenBelow = (branch, text) => {
  const written = [...text.matchAll(/^["']?([A-Za-z]\w*(?:\.\w+)*)["']?[ \t]*:(?=\s|$)([^\n]*(?:\n[ \t][^\n]*)*)/gm)];
  const branches = written.filter(([, , values]) => /\btype:\s*["']?branch\b/.test(values)).map(([, path]) => path);
  const above = written.flatMap(([, path]) => path.split(".").slice(0, -1).map((_, end, names) => names.slice(0, end + 1).join(".")));
  const start = branch && `${branch}.`;
  const below = [...branches, ...above].filter((path) => path.startsWith(start) && !path.slice(start.length).includes("."));
  return [...new Set(below)].map((path) => ({ name: path.slice(start.length), isBranch: true, hint: "branch" }));
};

export const mountCompletion = (form, text) => {
  const base = document.body.dataset.base;
  const patterns = [...ASKED[form.dataset.try], ...EVERYWHERE];
  const known = new Map();
  const list = Object.assign(document.createElement("ul"), { id: "completions", className: "completions", hidden: true });
  list.setAttribute("role", "listbox");
  list.setAttribute("aria-label", "Completions");
  form.append(list);
  text.setAttribute("aria-autocomplete", "list");
  text.setAttribute("aria-haspopup", "listbox");
  text.setAttribute("aria-controls", list.id);
  let offered = [];
  let active = 0;
  let first = 0;
  let asked = null;
  let turn = 0;

  // -- offers --------------------------------------------------------------------------------------------------------

  const ask = async (address) => {
    const response = await fetch(base + address);
    return response.ok ? response.json() : null;
  };

  const childrenOf = async (branch) => {
    const found = await ask(`/rows/${encodeURIComponent(form.dataset.completedFrom)}?${new URLSearchParams({ path: branch })}`);
    return (found?.rows ?? []).filter(([level]) => level === 0).map(([, name, kind, count]) => {
      const [type, datatype, unit] = found.kinds[kind];
      return { name, isBranch: count > 0 || type === "branch", hint: [type, datatype, unit].filter(Boolean).join(" ") };
    });
  };

  const units = async () => {
    const found = await ask(`/api/v1/catalogues/${encodeURIComponent(form.dataset.completedFrom)}/units`);
    return (found?.units ?? []).map(({ key, name }) => ({ name: key, hint: name, words: name }));
  };

  const datatypes = () => form.dataset.datatypes.split(" ").map((name) => ({ name, hint: "" }));

  /** What the catalogue has; it is asked once for each branch. */
  const offersOf = (kind, typed) => {
    const branch = kind === "path" ? typed.slice(0, Math.max(0, typed.lastIndexOf("."))) : "";
    if (kind === "path" && form.dataset.try === "tree") return writtenBelow(branch, text.value);
    const key = `${kind} ${branch}`;
    if (!known.has(key)) known.set(key, { path: () => childrenOf(branch), unit: units, datatype: datatypes }[kind]());
    return known.get(key);
  };

  // -- the list ------------------------------------------------------------------------------------------------------

  const close = () => {
    turn += 1;
    asked = null;
    list.hidden = true;
    text.removeAttribute("aria-activedescendant");
  };

  const optionOf = (index) => {
    const { name, hint } = offered[index];
    const option = Object.assign(document.createElement("li"), { id: `completion-${index}` });
    option.setAttribute("role", "option");
    option.setAttribute("aria-posinset", index + 1);
    option.setAttribute("aria-setsize", offered.length);
    option.setAttribute("aria-selected", index === active);
    option.append(Object.assign(document.createElement("b"), { textContent: name }));
    if (hint) option.append(" ", Object.assign(document.createElement("span"), { className: "hint", textContent: hint }));
    return option;
  };

  const paint = () => {
    const count = Math.min(SHOWN, offered.length - first);
    list.replaceChildren(...Array.from({ length: count }, (_, number) => optionOf(first + number)));
    list.dataset.place = offered.length > SHOWN ? `${active + 1} of ${offered.length}` : "";
    text.setAttribute("aria-activedescendant", `completion-${active}`);
  };

  const mark = (index) => {
    active = index;
    first = Math.min(Math.max(first, index - SHOWN + 1), index);
    paint();
  };

  /** Below the place where the name begins; above it without room below. */
  const place = () => {
    const before = text.value.slice(0, text.selectionStart - asked.rest.length);
    const style = getComputedStyle(text);
    const pen = document.createElement("canvas").getContext("2d");
    pen.font = style.font;
    const line = before.split("\n");
    const x = text.offsetLeft + EDGE + pen.measureText(line.at(-1)).width - text.scrollLeft;
    const y = text.offsetTop + parseFloat(style.paddingTop) + line.length * LINE - text.scrollTop;
    list.style.left = `${Math.max(0, Math.min(x, form.clientWidth - list.offsetWidth))}px`;
    const room = innerHeight - form.getBoundingClientRect().top - y;
    list.style.top = `${room < list.offsetHeight && y > list.offsetHeight ? y - list.offsetHeight - LINE : y}px`;
  };

  const show = () => {
    list.hidden = false;
    first = 0;
    mark(0);
    place();
    say(`${offered.length} completion${offered.length === 1 ? "" : "s"}`);
  };

  const context = () => {
    if (text.selectionStart !== text.selectionEnd) return null;
    const before = text.value.slice(text.value.lastIndexOf("\n", text.selectionStart - 1) + 1, text.selectionStart);
    if (/^[\w.]/.test(text.value.slice(text.selectionStart))) return null; // within a word
    for (const [kind, pattern] of patterns) {
      const found = pattern.exec(before);
      if (found) return { kind, typed: found[1], rest: kind === "path" ? found[1].split(".").at(-1) : found[1] };
    }
    return null;
  };

  const offer = async () => {
    asked = context();
    if (!asked) return close();
    turn += 1;
    const mine = turn;
    const offers = await Promise.resolve(offersOf(asked.kind, asked.typed)).catch(() => []); // without an answer nothing is offered
    if (mine !== turn) return;
    offered = fitting(offers, asked.rest);
    const isWhole = offered.length === 1 && offered[0].name === asked.rest;
    if (!offered.length || isWhole) close();
    else show();
  };

  /** Put the chosen name in place of its typed part, so that it can be undone. A branch continues, a signal ends. */
  const accept = (index) => {
    const { name, isBranch } = offered[index];
    const follows = text.value[text.selectionStart] ?? "\n";
    const isKey = asked.kind === "path" && form.dataset.try === "overlay" && follows !== ":";
    const end = asked.kind !== "path" ? "" : isBranch ? "." : isKey ? ":" : "";
    text.setSelectionRange(text.selectionStart - asked.rest.length, text.selectionStart);
    close();
    if (!document.execCommand("insertText", false, name + end)) {
      text.setRangeText(name + end, text.selectionStart, text.selectionEnd, "end");
      text.dispatchEvent(new InputEvent("input", { bubbles: true }));
    }
  };

  // -- what one does -------------------------------------------------------------------------------------------------

  const keys = {
    ArrowDown: () => mark((active + 1) % offered.length),
    ArrowUp: () => mark((active + offered.length - 1) % offered.length),
    Enter: () => accept(active),
    Tab: () => accept(active),
    Escape: close,
  };
  text.addEventListener("keydown", (event) => {
    if (event.ctrlKey && event.key === " ") {
      event.preventDefault();
      offer();
    }
    const act = keys[event.key];
    if (list.hidden || !act || event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    if (event.key === "Enter" && offered[active].name === asked.rest) { close(); return; } // it is complete: the line ends
    event.preventDefault();
    event.stopPropagation();
    act();
  });
  text.addEventListener("input", (event) => { if (event.inputType !== "insertFromPaste") offer(); });
  text.addEventListener("blur", close);
  text.addEventListener("click", close);
  text.addEventListener("scroll", () => { if (!list.hidden) place(); }, { passive: true });
  list.addEventListener("mousedown", (event) => {
    event.preventDefault(); // the text keeps the focus
    const option = event.target.closest("[role=option]");
    if (option) accept(first + [...list.children].indexOf(option));
  });
  list.addEventListener("wheel", (event) => {
    event.preventDefault();
    mark(Math.min(Math.max(active + Math.sign(event.deltaY), 0), offered.length - 1));
  });
};
