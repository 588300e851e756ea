// What every page has: search as you type, copying, menus that close. A page works without any of it.
import { askPart, attempt, begin, say } from "./asking.js";
import { mountBasket, withBasket } from "./basket.js";
import { mountCalls } from "./call.js";
import { mountPaths } from "./paths.js";
import { mountProposal } from "./propose.js";
import { mountRun } from "./run.js";
import { mountTree } from "./tree.js";
import { mountTry } from "./try.js";

const base = document.body.dataset.base;
document.documentElement.classList.add("live");

// -- copy -----------------------------------------------------------------------------------------------------------

/** A text that is shown: where lines are numbered or have findings beside them, only the text itself. */
const textOf = (shown) => {
  const lines = shown.querySelectorAll("li > code");
  return lines.length ? [...lines].map((line) => line.textContent.trimEnd()).join("\n") + "\n" : shown.textContent;
};

const copied = async (button) => {
  const from = button.dataset.copyFrom;
  const address = button.dataset.copyAddress;
  const text = from ? textOf(document.getElementById(from)) : address ? new URL(address, location.href).href : button.dataset.copy;
  try {
    await navigator.clipboard.writeText(text);
  } catch { // not allowed, or not a secure address: the old way
    const field = Object.assign(document.createElement("textarea"), { value: text, readOnly: true, className: "unseen" });
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
  button.textContent = "Copied";
  say(from ? "Copied" : `Copied ${text}`);
  setTimeout(() => { button.textContent = "Copy"; }, 1500);
};

document.addEventListener("click", (event) => {
  const button = event.target.closest("[data-copy], [data-copy-from], [data-copy-address]");
  if (button) copied(button);
  for (const menu of document.querySelectorAll("details.menu[open]")) {
    if (!menu.contains(event.target)) menu.open = false;
  }
});

// -- leaving the page -------------------------------------------------------------------------------------------------

document.addEventListener("submit", (event) => {
  if (!event.defaultPrevented && event.submitter?.name !== "download") begin();
});
document.addEventListener("click", (event) => {
  const link = event.target.closest("a[href]");
  const leaves = link && !link.hasAttribute("download") && link.origin === location.origin && link.pathname + link.search !== location.pathname + location.search;
  if (leaves && !event.defaultPrevented && !event.ctrlKey && !event.metaKey && !event.shiftKey) begin();
});

// -- search as you type -----------------------------------------------------------------------------------------------

const field = document.querySelector("[data-search]");
const main = document.getElementById("main");
mountBasket();
let leave = mountTree();
mountTry();
mountProposal();
mountRun();
mountCalls();
mountPaths();
let timer = 0;

const isSearch = () => location.pathname.startsWith(`${base}/search/`);

const showSearch = (address) => attempt(async () => {
  const text = await askPart(address);
  if (text === null) return;
  leave?.();
  leave = null;
  main.className = "grid search";
  main.innerHTML = text;
  document.querySelector(".bar nav [aria-current]")?.removeAttribute("aria-current");
  for (const link of document.querySelectorAll("[data-elsewhere]")) link.href = `${base}/search/${link.dataset.elsewhere}${location.search}`;
  document.title = main.querySelector("[data-title]").dataset.title + document.body.dataset.titled;
  say(main.querySelector("[data-tally]").textContent);
});

const searched = async () => {
  const address = new URL(field.form.action);
  const current = new URL(location.href);
  if (isSearch()) for (const [name, value] of current.searchParams) if (!["q", "cursor"].includes(name)) address.searchParams.set(name, value);
  if (field.value) address.searchParams.set("q", field.value);
  const picked = withBasket(address.href);
  if (isSearch()) history.replaceState({}, "", picked);
  else if (field.value.trim()) history.pushState({}, "", picked);
  else return;
  await showSearch(picked);
};

if (field) {
  field.addEventListener("input", () => { clearTimeout(timer); timer = setTimeout(searched, 60); });
  field.form.addEventListener("submit", async (event) => {
    if (!field.value.trim() && !isSearch()) return; // all nodes: the page of the results
    event.preventDefault();
    clearTimeout(timer);
    await searched();
    main.querySelector("[data-hit]")?.focus();
  });
  document.addEventListener("keydown", (event) => {
    const typing = event.target.matches("input, textarea, select, [contenteditable]");
    if (event.key === "/" && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      field.focus();
      field.select();
    }
    if (event.key === "ArrowDown" && (event.target === field || event.target.matches("[data-hit]"))) move(event, 1);
    if (event.key === "ArrowUp" && event.target.matches("[data-hit]")) move(event, -1);
    if (event.key === "Escape" && event.target.matches("[data-hit]")) field.focus();
    if (event.key === "Escape") for (const menu of document.querySelectorAll("details.menu[open]")) { menu.open = false; menu.firstElementChild.focus(); }
  });
  main.addEventListener("click", async (event) => {
    const link = event.target.closest("[data-filter]");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    history.pushState({}, "", link.href);
    field.value = new URL(link.href).searchParams.get("q") ?? "";
    await showSearch(link.href);
    if (document.activeElement === document.body) main.focus({ preventScroll: true }); // the link that had it is gone
  });
}

const move = (event, step) => {
  const hits = [...main.querySelectorAll("[data-hit]")];
  const next = hits[hits.indexOf(event.target) + step] ?? (step < 0 ? field : null);
  if (!next) return;
  event.preventDefault();
  next.focus();
};

// A step in the history while this page was loading: no script was there to follow it.
const [loaded] = performance.getEntriesByType("navigation");
if (isSearch() !== main.classList.contains("search") && new URL(loaded.name).pathname !== location.pathname) location.reload();

// Going back from results to a tree, or on from a tree to results, loads the page: its state is its address.
addEventListener("popstate", () => {
  const showsResults = main.classList.contains("search");
  if (isSearch() && showsResults) {
    field.value = new URL(location.href).searchParams.get("q") ?? "";
    showSearch(location.href);
  } else if (isSearch() || showsResults) {
    location.reload();
  }
});
