// The tree: all rows in memory, only those in sight in the document. Keyboard: the tree pattern of the W3C's ARIA guide.

const MOST_ROWS = 100;
const BEYOND = 8; // rows kept above and below what is in sight
const LETTERS = { branch: "", sensor: "S", actuator: "A", attribute: "P", struct: "{}", property: "·" };
const TYPING_PAUSE = 600;

class Entry {
  constructor(name, path, level, kind, count, parent, position, siblings) {
    Object.assign(this, { name, path, level, kind, count, parent, position, siblings, children: null, open: false });
  }
}

/** Put compact rows (parents first) below an entry; the levels of `rows` count from the entry down. */
const fill = (parent, { kinds, rows }) => {
  const stack = [{ entry: parent, children: [] }];
  for (const [level, name, kind, count] of rows) {
    while (stack.length > level + 1) stack.pop();
    const { entry: above, children } = stack[level];
    const path = above.path ? `${above.path}.${name}` : name;
    const entry = new Entry(name, path, above.level + 1, kinds[kind], count, above, children.length + 1, 0);
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

export const mountTree = ({ fetchPart, progress, say }) => {
  const section = document.querySelector("[data-tree]");
  if (!section) return null;
  const base = document.body.dataset.base;
  const catalogue = document.body.dataset.catalogue;
  const { state } = section.dataset;
  const view = section.querySelector(".rows");
  const article = document.getElementById("node");
  const stop = new AbortController();
  const { signal } = stop;

  const root = new Entry("", "", 0, [], 1, null, 1, 1);
  let visible = [];
  let active = 0;
  let selected = section.dataset.selected;
  let everything = false;
  let height = 26;
  const extent = document.createElement("div");
  extent.className = "extent";

  // -- data ----------------------------------------------------------------------------------------------------------

  const load = async (entry, depth = 1) => {
    const query = new URLSearchParams({ path: entry.path, depth, v: state });
    const response = await progress(fetch(`${base}/rows/${encodeURIComponent(catalogue)}?${query}`, { signal }));
    if (!response.ok) throw new Error(`The rows below ${entry.path} did not come: ${response.status}`);
    fill(entry, await response.json());
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
    return open ? `${page}?open=${encodeURIComponent(open).replaceAll("%2C", ",").replaceAll("%2A", "*")}` : page;
  };

  const remember = () => history.replaceState({ tree: true }, "", addressOf(selected));

  const select = async (path, { push = true } = {}) => {
    selected = path;
    if (push) history.pushState({ tree: true }, "", addressOf(path));
    paint();
    article.classList.add("waiting");
    const text = await fetchPart(addressOf(path, ""));
    if (text === null || text === undefined) return;
    article.classList.remove("waiting");
    article.innerHTML = text;
    article.scrollTop = 0;
    const title = article.querySelector("[data-title]")?.dataset.title ?? "";
    document.title = `${title} · sigcat`;
    say(title);
    for (const link of document.querySelectorAll(".bar .menu li:not(.apart) a, [data-switch]")) {
      const url = new URL(link.href);
      url.pathname = [...url.pathname.split("/").slice(0, base.split("/").length + 2), path].filter((part, i) => part || !i).join("/");
      link.href = url.href;
    }
  };

  // -- rows in the document ------------------------------------------------------------------------------------------

  const pool = new Map();

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
      row.append(mark, name, ...(datatype ? [hint] : []));
      row.title = `${entry.path}${entry.count ? "" : ` (${type})`}`;
      row.setAttribute("aria-level", entry.level);
      row.setAttribute("aria-posinset", entry.position);
      row.setAttribute("aria-setsize", entry.siblings);
      pool.set(entry, row);
    }
    row.id = `row-${index}`;
    row.style.transform = `translateY(${index * height}px)`;
    row.children[1].href = addressOf(entry.path, "");
    row.classList.toggle("selected", entry.path === selected);
    row.classList.toggle("active", index === active);
    row.setAttribute("aria-selected", entry.path === selected);
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

  const toggle = async (entry, open = !entry.open) => {
    if (!entry.count || entry.open === open) return;
    if (open) {
      pool.get(entry)?.firstChild.classList.add("waiting");
      await opened(entry);
      pool.get(entry)?.firstChild.classList.remove("waiting");
    } else {
      entry.open = false;
      everything = false;
    }
    arrange();
    if (!open && selected.startsWith(`${entry.path}.`)) {
      keepActive(entry);
      await select(entry.path);
    }
    keepActive(entry);
    intoSight(active);
    paint();
    remember();
  };

  const openBeside = async (entry) => {
    for (const each of entry.parent.children) if (each.count) await opened(each);
    arrange();
    keepActive(entry);
    paint();
    remember();
  };

  const expandAll = async () => {
    section.setAttribute("aria-busy", "true");
    await load(root, 1000);
    const waiting = [root];
    while (waiting.length) {
      const entry = waiting.pop();
      entry.open = true;
      for (const child of entry.children ?? []) if (child.count) waiting.push(child);
    }
    everything = true;
    arrange();
    keepActive(find(selected));
    section.removeAttribute("aria-busy");
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
    Enter: (entry) => select(entry.path),
    " ": (entry) => select(entry.path),
    "*": (entry) => openBeside(entry),
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

  // -- mouse ---------------------------------------------------------------------------------------------------------

  view.addEventListener("click", (event) => {
    const row = event.target.closest(".row");
    if (!row?.entry || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    active = visible.indexOf(row.entry);
    if (event.target.classList.contains("chevron")) toggle(row.entry);
    else select(row.entry.path).then(() => row.entry.count && toggle(row.entry, true));
    view.focus({ preventScroll: true });
  }, { signal });

  view.addEventListener("dblclick", (event) => {
    const row = event.target.closest(".row");
    if (row?.entry?.count && !event.target.classList.contains("chevron")) toggle(row.entry, false);
  }, { signal });

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

  section.querySelector("[data-expand]").addEventListener("click", (event) => { event.preventDefault(); expandAll(); }, { signal });
  section.querySelector("[data-collapse]").addEventListener("click", (event) => { event.preventDefault(); collapse(); }, { signal });

  article.addEventListener("click", (event) => {
    const link = event.target.closest("[data-node]");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    show(link.dataset.node);
  }, { signal });

  const show = async (path, options) => {
    const entry = await reveal(path);
    arrange();
    if (entry) keepActive(entry);
    intoSight(active);
    await select(path, options);
  };

  addEventListener("popstate", async () => {
    const [, page, id = "", path = ""] = location.pathname.slice(base.length).split("/").map(decodeURIComponent);
    if (page === "search") return; // not the tree's matter
    if (page !== "tree" || id !== catalogue) location.reload();
    else if (path && path !== selected) await show(path, { push: false });
    else if (!path) await select("", { push: false });
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
    view.tabIndex = 0;
    view.replaceChildren(extent);
    measure();
    arrange();
    if (entry) keepActive(entry);
    paint();
    if (entry) { view.scrollTop = Math.max(0, (active * height) - view.clientHeight / 3); paint(); }
    watch.observe(view);
    section.dataset.ready = "";
  };
  start();

  return () => { stop.abort(); watch.disconnect(); };
};
