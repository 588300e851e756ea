// The tree: all rows in memory, only those in sight in the document. Keyboard: the tree pattern of the W3C's ARIA guide.
import { isPicked, onBasket, picks, toggle as togglePick } from "./basket.js";
import { askJson, askPart, attempt, say } from "./asking.js";

const MOST_ROWS = 100;
const BEYOND = 8; // rows kept above and below what is in sight
const LETTERS = { branch: "", sensor: "sen", actuator: "act", attribute: "att", struct: "{}", property: "·" };
const TYPING_PAUSE = 600;
const RESTING = 120; // after the last movement, where one has scrolled to is kept

class Entry {
  constructor(name, path, level, kind, count, users, parent, position, siblings) {
    Object.assign(this, { name, path, level, kind, count, users, parent, position, siblings, children: null, open: false });
  }
}

/** How many functions use a node, or one below it. */
const usersOf = (count) => {
  const shown = Object.assign(document.createElement("span"), { textContent: `ƒ${count}` });
  shown.setAttribute("aria-hidden", "true");
  const read = Object.assign(document.createElement("span"), { className: "unseen", textContent: `, used by ${count} function${count === 1 ? "" : "s"}` });
  const users = Object.assign(document.createElement("span"), { className: "users" });
  users.append(shown, read);
  return users;
};

/** Put compact rows (parents first) below an entry; the levels of `rows` count from the entry down. */
const fill = (parent, { kinds, rows }) => {
  const stack = [{ entry: parent, children: [] }];
  for (const [level, name, kind, count, users = 0] of rows) {
    while (stack.length > level + 1) stack.pop();
    const { entry: above, children } = stack[level];
    const path = above.path ? `${above.path}.${name}` : name;
    const entry = new Entry(name, path, above.level + 1, kinds[kind], count, users, above, children.length + 1, 0);
    children.push(entry);
    above.children = children;
    if (count) stack.push({ entry, children: [] });
  }
  const waiting = [parent];
  while (waiting.length) {
    const { children } = waiting.pop();
    for (const child of children ?? []) {
      child.siblings = children.length;
      if (child.children) waiting.push(child);
    }
  }
};

export const mountTree = () => {
  const section = document.querySelector("[data-tree]");
  if (!section) return null;
  const base = document.body.dataset.base;
  const catalogue = document.body.dataset.catalogue;
  const { state } = section.dataset;
  const view = section.querySelector(".rows");
  const article = document.getElementById("content");
  const stop = new AbortController();
  const { signal } = stop;

  const root = new Entry("", "", 0, [], 1, 0, null, 1, 1);
  let visible = [];
  let active = 0;
  let selected = section.dataset.selected;
  let wanted = null; // what will be selected as soon as it is here
  let everything = false;
  let height = 26;
  const extent = document.createElement("div");
  extent.className = "extent";

  // -- data ----------------------------------------------------------------------------------------------------------

  const load = async (entry, depth = 1) => {
    const query = new URLSearchParams({ path: entry.path, depth, v: state });
    fill(entry, await askJson(`${base}/rows/${encodeURIComponent(catalogue)}?${query}`, signal));
  };

  const opened = async (entry) => {
    if (!entry.count && entry !== root) return;
    if (!entry.children) await load(entry);
    entry.open = true;
  };

  const reveal = async (path) => {
    let above = root;
    let prefix = "";
    for (const name of path.split(".")) {
      await opened(above);
      prefix = prefix ? `${prefix}.${name}` : name;
      above = above.children?.find((child) => child.path === prefix);
      if (!above) return null;
    }
    return above;
  };

  const arrange = () => {
    visible = [];
    const waiting = [...(root.children ?? [])].reverse();
    while (waiting.length) {
      const entry = waiting.pop();
      visible.push(entry);
      if (entry.open && entry.children) for (let i = entry.children.length - 1; i >= 0; i -= 1) waiting.push(entry.children[i]);
    }
    extent.style.height = `${visible.length * height}px`;
  };

  const openPaths = () => {
    if (everything) return "*";
    const needed = new Set();
    for (let above = find(selected)?.parent; above; above = above.parent) needed.add(above.path);
    return visible.filter((entry) => entry.open && !needed.has(entry.path)).map((entry) => entry.path).join(",");
  };

  const find = (path) => {
    let entry = root;
    if (!path) return null;
    let prefix = "";
    for (const name of path.split(".")) {
      prefix = prefix ? `${prefix}.${name}` : name;
      entry = entry?.children?.find((child) => child.path === prefix);
    }
    return entry ?? null;
  };

  // -- address -------------------------------------------------------------------------------------------------------

  const addressOf = (path, open = openPaths()) => {
    const page = [base, "tree", encodeURIComponent(catalogue), ...(path ? [encodeURIComponent(path)] : [])].join("/");
    const given = [["open", open], ["pick", picks()]].filter(([, value]) => value);
    const query = given.map(([name, value]) => `${name}=${encodeURIComponent(value).replaceAll("%2C", ",").replaceAll("%2A", "*")}`);
    return query.length ? `${page}?${query.join("&")}` : page;
  };

  const remember = () => history.replaceState({ tree: true, scroll: scroller().scrollTop }, "", addressOf(selected));

  const loaded = async (path) => {
    wanted = path;
    paint();
    article.classList.add("waiting");
    const settled = () => { wanted = null; article.classList.remove("waiting"); paint(); };
    try {
      const text = await askPart(addressOf(path, ""));
      if (text !== null) settled(); // else a later request is under way
      return text;
    } catch (error) {
      settled();
      throw error;
    }
  };

  const change = async (path, { push = true, scroll = 0 } = {}) => {
    const text = await loaded(path);
    if (text === null) return;
    if (push) keepScroll();
    selected = path;
    if (push) history.pushState({ tree: true }, "", addressOf(path));
    article.innerHTML = text;
    scrollTo(push ? null : scroll);
    keepScroll();
    paint();
    const title = article.querySelector("[data-title]").dataset.title;
    document.title = title + document.body.dataset.titled;
    say(title);
    for (const link of document.querySelectorAll(".bar .menu li:not(.apart) a, [data-switch]")) {
      const url = new URL(link.href);
      url.pathname = [...url.pathname.split("/").slice(0, base.split("/").length + 2), path].filter((part, i) => part || !i).join("/");
      link.href = url.href;
    }
  };

  const select = (path, options) => attempt(() => change(path, options));

  // -- scrolling of the node -----------------------------------------------------------------------------------------

  /** What scrolls the node: its pane, or the whole page where the node is below the tree. */
  const scroller = () => (getComputedStyle(article).overflowY === "visible" ? document.scrollingElement : article);

  let resting = 0;
  const keepScroll = () => {
    clearTimeout(resting);
    history.replaceState({ ...history.state, scroll: scroller().scrollTop }, "");
  };
  const rest = () => { clearTimeout(resting); resting = setTimeout(keepScroll, RESTING); };
  article.addEventListener("scroll", rest, { signal, passive: true });
  document.addEventListener("scroll", rest, { signal, passive: true });

  /** Scroll to where one was; without a place, to the beginning of the node. */
  const scrollTo = (place) => {
    if (place !== null || scroller() === article) scroller().scrollTop = place ?? 0;
    else if (article.getBoundingClientRect().top < 0) article.scrollIntoView();
  };

  // -- rows in the document ------------------------------------------------------------------------------------------

  const pool = new Map();

  /** The mark at the end of a row, which puts its node into the basket. */
  const pickOf = () => {
    const mark = Object.assign(document.createElement("span"), { className: "pick", title: "Add to basket, or remove from it (+)" });
    mark.append(Object.assign(document.createElement("span"), { className: "unseen" }));
    return mark;
  };

  const rowOf = (index) => {
    const entry = visible[index];
    let row = pool.get(entry);
    if (!row) {
      row = document.createElement("div");
      row.setAttribute("role", "treeitem");
      row.entry = entry;
      const [type, datatype, unit, , deprecated] = entry.kind;
      row.className = `row l${Math.min(entry.level, 24)} ${deprecated}`;
      const mark = document.createElement("span");
      if (entry.count) mark.className = "chevron";
      else Object.assign(mark, { className: `letter ${type}`, textContent: LETTERS[type] ?? "?" });
      mark.setAttribute("aria-hidden", "true");
      const name = Object.assign(document.createElement("a"), { className: "name", textContent: entry.name, tabIndex: -1 });
      const hint = Object.assign(document.createElement("span"), { className: "hint", textContent: datatype });
      if (unit) hint.append(" ", Object.assign(document.createElement("i"), { textContent: unit }));
      row.append(mark, name, ...(entry.users ? [usersOf(entry.users)] : []), ...(datatype ? [hint] : []), pickOf());
      row.title = `${entry.path}${entry.count ? "" : ` (${[type, datatype, unit].filter(Boolean).join(" ")})`}`;
      row.setAttribute("aria-level", entry.level);
      row.setAttribute("aria-posinset", entry.position);
      row.setAttribute("aria-setsize", entry.siblings);
      pool.set(entry, row);
    }
    row.id = `row-${index}`;
    row.style.transform = `translateY(${index * height}px)`;
    row.children[1].href = addressOf(entry.path, "");
    const isSelected = entry.path === (wanted ?? selected);
    row.classList.toggle("selected", isSelected);
    row.classList.toggle("active", index === active);
    row.lastChild.classList.toggle("picked", isPicked(entry.path));
    row.lastChild.firstChild.textContent = isPicked(entry.path) ? ", in the basket" : "";
    row.setAttribute("aria-selected", isSelected);
    if (entry.count) {
      row.setAttribute("aria-expanded", entry.open);
      row.firstChild.classList.toggle("open", entry.open);
    }
    return row;
  };

  const paint = () => {
    const first = Math.max(0, Math.floor(view.scrollTop / height) - BEYOND);
    const fits = Math.ceil(view.clientHeight / height) + 2 * BEYOND;
    const last = Math.min(visible.length, first + Math.min(fits, MOST_ROWS));
    const rows = [];
    for (let index = first; index < last; index += 1) rows.push(rowOf(index));
    const kept = new Set(rows.map((row) => row.entry));
    for (const entry of pool.keys()) if (!kept.has(entry)) pool.delete(entry);
    extent.replaceChildren(...rows);
    if (active >= first && active < last) view.setAttribute("aria-activedescendant", `row-${active}`);
    else view.removeAttribute("aria-activedescendant");
  };

  const intoSight = (index) => {
    const top = index * height;
    if (top < view.scrollTop) view.scrollTop = top;
    else if (top + height > view.scrollTop + view.clientHeight - 12) view.scrollTop = top + height - view.clientHeight + 12;
  };

  const activate = (index) => {
    if (index < 0 || index >= visible.length) return;
    active = index;
    intoSight(index);
    paint();
  };

  const keepActive = (entry) => { active = Math.max(0, visible.indexOf(entry)); };

  // -- what one can do -----------------------------------------------------------------------------------------------

  const openVisibly = async (entry) => {
    pool.get(entry)?.firstChild.classList.add("waiting");
    try {
      await opened(entry);
    } finally {
      pool.get(entry)?.firstChild.classList.remove("waiting");
    }
  };

  const turn = async (entry, open) => {
    if (!entry.count || entry.open === open) return;
    if (open) {
      await openVisibly(entry);
    } else {
      entry.open = false;
      everything = false;
    }
    arrange();
    if (!open && selected.startsWith(`${entry.path}.`)) {
      keepActive(entry);
      await change(entry.path);
    }
    keepActive(entry);
    intoSight(active);
    paint();
    remember();
  };

  const toggle = (entry, open = !entry.open) => attempt(() => turn(entry, open));

  const openBeside = (entry) => attempt(async () => {
    for (const each of entry.parent.children) if (each.count) await opened(each);
    arrange();
    keepActive(entry);
    paint();
    remember();
  });

  const loadAll = async () => {
    section.setAttribute("aria-busy", "true");
    try {
      await load(root, 1000);
    } finally {
      section.removeAttribute("aria-busy");
    }
  };

  const expandAll = async () => {
    await loadAll();
    const waiting = [root];
    while (waiting.length) {
      const entry = waiting.pop();
      entry.open = true;
      for (const child of entry.children ?? []) if (child.count) waiting.push(child);
    }
    everything = true;
    arrange();
    keepActive(find(selected));
    intoSight(active);
    paint();
    remember();
    say(`${visible.length.toLocaleString("en")} rows`);
  };

  const collapse = () => {
    const waiting = [...root.children];
    while (waiting.length) {
      const entry = waiting.pop();
      entry.open = entry.parent === root;
      waiting.push(...(entry.children ?? []).filter((child) => child.open));
    }
    everything = false;
    const above = find(selected.split(".").slice(0, 2).join("."));
    arrange();
    keepActive(above);
    if (selected.split(".").length > 2) select(above?.path ?? "");
    view.scrollTop = 0;
    intoSight(active);
    paint();
    remember();
  };

  // -- keyboard ------------------------------------------------------------------------------------------------------

  let typed = "";
  let typedAt = 0;

  const typeAhead = (key) => {
    const now = performance.now();
    typed = now - typedAt > TYPING_PAUSE ? key : typed + key;
    typedAt = now;
    const sought = [...typed].every((c) => c === typed[0]) ? typed[0] : typed;
    const from = sought.length === 1 ? active + 1 : active;
    for (let step = 0; step < visible.length; step += 1) {
      const index = (from + step) % visible.length;
      if (visible[index].name.toLowerCase().startsWith(sought)) { activate(index); return; }
    }
  };

  const keys = {
    ArrowDown: () => activate(active + 1),
    ArrowUp: () => activate(active - 1),
    Home: () => activate(0),
    End: () => activate(visible.length - 1),
    PageDown: () => activate(Math.min(visible.length - 1, active + Math.floor(view.clientHeight / height) - 1)),
    PageUp: () => activate(Math.max(0, active - Math.floor(view.clientHeight / height) + 1)),
    ArrowRight: (entry) => { if (entry.count && !entry.open) return toggle(entry, true); if (entry.open) activate(active + 1); },
    ArrowLeft: (entry) => { if (entry.open) return toggle(entry, false); if (entry.parent !== root) activate(visible.indexOf(entry.parent)); },
    Enter: (entry) => select(entry.path).then(() => selected === entry.path && article.focus({ preventScroll: true })),
    " ": (entry) => select(entry.path),
    "*": (entry) => openBeside(entry),
    "+": (entry) => togglePick(entry.path),
  };

  view.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys[event.key];
    const entry = visible[active];
    if (act && entry) {
      event.preventDefault();
      act(entry);
    } else if (event.key.length === 1 && /\S/.test(event.key) && event.key !== "/") {
      typeAhead(event.key.toLowerCase());
    }
  }, { signal });

  article.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || document.querySelector("details.menu[open]")) return;
    view.focus({ preventScroll: true });
    intoSight(active);
    paint();
  }, { signal });

  // -- mouse ---------------------------------------------------------------------------------------------------------

  view.addEventListener("click", (event) => {
    const row = event.target.closest(".row");
    if (!row?.entry || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    active = visible.indexOf(row.entry);
    if (event.target.classList.contains("pick")) { togglePick(row.entry.path); paint(); } else if (event.target.classList.contains("chevron")) toggle(row.entry);
    else attempt(async () => { await change(row.entry.path); await turn(row.entry, true); });
    view.focus({ preventScroll: true });
  }, { signal });

  view.addEventListener("dblclick", (event) => {
    const row = event.target.closest(".row");
    if (row?.entry?.count && !event.target.classList.contains("chevron")) toggle(row.entry, false);
  }, { signal });

  onBasket(() => paint(), { signal });

  let painting = 0;
  view.addEventListener("scroll", () => {
    cancelAnimationFrame(painting);
    painting = requestAnimationFrame(paint);
  }, { signal, passive: true });

  const watch = new ResizeObserver(() => { measure(); paint(); });
  const measure = () => {
    const now = parseFloat(getComputedStyle(document.documentElement).getPropertyValue("--row")) || 26;
    if (now !== height) { height = now; arrange(); }
  };

  section.querySelector("[data-expand]").addEventListener("click", (event) => { event.preventDefault(); attempt(expandAll); }, { signal });
  section.querySelector("[data-collapse]").addEventListener("click", (event) => { event.preventDefault(); collapse(); }, { signal });

  article.addEventListener("click", (event) => {
    const link = event.target.closest("[data-node]");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    show(link.dataset.node);
  }, { signal });

  const show = (path, options) => attempt(async () => {
    const entry = await reveal(path);
    arrange();
    if (entry) keepActive(entry);
    intoSight(active);
    await change(path, options);
  });

  addEventListener("popstate", async (event) => {
    clearTimeout(resting);
    const back = { push: false, scroll: event.state?.scroll ?? 0 };
    const [, page, id = "", path = ""] = location.pathname.slice(base.length).split("/").map(decodeURIComponent);
    if (page === "search") return; // not the tree's matter
    if (page !== "tree" || id !== catalogue) location.reload();
    else if (path && path !== selected) await show(path, back);
    else if (!path) await select("", back);
  }, { signal });

  // -- width ---------------------------------------------------------------------------------------------------------

  const divider = document.querySelector("[data-divider]");
  const widen = (pixels) => {
    const width = Math.round(Math.min(Math.max(pixels, 200), innerWidth * 0.7));
    section.parentElement.style.setProperty("--tree-width", `${width}px`);
    divider.setAttribute("aria-valuenow", width);
    try { localStorage.setItem("tree-width", width); } catch { /* private browsing: the width is not kept */ }
  };
  divider.tabIndex = 0;
  divider.setAttribute("aria-valuemin", 200);
  divider.setAttribute("aria-valuenow", section.clientWidth);
  try { if (localStorage.getItem("tree-width")) widen(Number(localStorage.getItem("tree-width"))); } catch { /* as above */ }
  divider.addEventListener("pointerdown", (event) => {
    divider.setPointerCapture(event.pointerId);
    const follow = (moved) => widen(moved.clientX - section.getBoundingClientRect().left);
    divider.addEventListener("pointermove", follow);
    divider.addEventListener("lostpointercapture", () => divider.removeEventListener("pointermove", follow), { once: true });
  }, { signal });
  divider.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -24, ArrowRight: 24 }[event.key];
    if (step) widen(section.clientWidth + step);
  }, { signal });

  // -- start ---------------------------------------------------------------------------------------------------------

  const start = async () => {
    const named = section.dataset.open.split(",").filter(Boolean);
    await opened(root);
    if (named.includes("*")) {
      await expandAll();
    } else {
      for (const path of named) {
        const entry = await reveal(path);
        if (entry) await opened(entry);
      }
    }
    const entry = selected ? await reveal(selected) : null;
    view.setAttribute("role", "tree");
    view.setAttribute("aria-label", "Nodes");
    view.setAttribute("aria-description", "Space shows a node, Enter goes to it, Escape returns to the tree, plus adds it to the basket.");
    view.tabIndex = 0;
    view.replaceChildren(extent);
    measure();
    arrange();
    if (entry) keepActive(entry);
    paint();
    if (entry) { view.scrollTop = Math.max(0, (active * height) - view.clientHeight / 3); paint(); }
    watch.observe(view);
    if (history.state?.scroll) scrollTo(history.state.scroll);
    section.dataset.ready = "";
  };
  attempt(start);

  return () => { stop.abort(); watch.disconnect(); };
};
