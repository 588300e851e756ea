// The basket: chosen paths in the address of the page. Links show the same without any of this; here nothing is loaded again.
import { say } from "./asking.js";

const PICK = "pick";
const MOST = 6000; // characters, as the service takes them
const base = document.body.dataset.base;
const CHANGED = "basket";
let paths = (new URL(location.href).searchParams.get(PICK) ?? "").split(",").filter(Boolean);

export const picks = () => paths.join(",");
export const isPicked = (path) => paths.includes(path);
export const onBasket = (act, options) => document.addEventListener(CHANGED, act, options);

/** An address with the basket as it is now. */
export const withBasket = (address) => {
  const url = new URL(address, location.href);
  if (paths.length) url.searchParams.set(PICK, picks());
  else url.searchParams.delete(PICK);
  return url.href.replaceAll("%2C", ",");
};

const show = () => {
  const link = document.querySelector("[data-basket]");
  if (!link) return; // a page without catalogues
  link.hidden = !paths.length && !link.hasAttribute("aria-current");
  link.querySelector("[data-basket-count]").textContent = paths.length;
  for (const each of document.querySelectorAll("a[data-pick]")) {
    each.firstChild.data = isPicked(each.dataset.pick) ? "Remove from basket" : "Add to basket";
  }
  document.dispatchEvent(new Event(CHANGED));
};

export const toggle = (path) => {
  const changed = isPicked(path) ? paths.filter((each) => each !== path) : [...paths, path];
  if (changed.join(",").length > MOST) {
    say("The basket is full. Choose branches instead.");
    return;
  }
  paths = changed;
  history.replaceState(history.state, "", withBasket(location.href));
  show();
  say(`${isPicked(path) ? "Added" : "Removed"} ${path}. ${paths.length} in the basket`);
};

const isPage = (link) => link.origin === location.origin && !link.hasAttribute("download")
  && !/^\/(api|static|openapi\.json)(\/|$)/.test(link.pathname.slice(base.length));

export const mountBasket = () => {
  document.addEventListener("click", (event) => {
    const link = event.target.closest?.("a[href]");
    if (!link) return;
    if (link.dataset.pick && !event.ctrlKey && !event.metaKey && !event.shiftKey) {
      event.preventDefault();
      event.stopPropagation();
      toggle(link.dataset.pick);
    } else if (isPage(link) && !link.pathname.startsWith(`${base}/basket/`) && !link.dataset.pick) {
      link.href = withBasket(link.href);
    } else if (link.hasAttribute("data-basket")) {
      link.href = withBasket(link.href);
    }
  }, true);
  document.addEventListener("submit", (event) => {
    if (event.target.method !== "get" || event.target.elements.namedItem(PICK) || !paths.length) return;
    const field = Object.assign(document.createElement("input"), { type: "hidden", name: PICK, value: picks() });
    event.target.append(field);
  }, true);
  addEventListener("popstate", () => { // a step back does not undo the choice
    history.replaceState(history.state, "", withBasket(location.href));
  });
};
