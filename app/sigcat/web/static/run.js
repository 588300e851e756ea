// The picture of a run: values under the pointer, and a part of it by dragging. The links and the form do the same without it.
import { askJson, askPart, attempt, say } from "./asking.js";

const SVG = "http://www.w3.org/2000/svg";
const SHORTEST = 5; // pixels that one drags across before it is a zoom

const added = (svg, name, attributes) => {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return svg.appendChild(element);
};

/** The value that holds at a time; a value holds until the next one. */
const at = (values, time) => {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle][0] <= time) low = middle + 1;
    else high = middle;
  }
  return low ? values[low - 1][1] : "";
};

const mountPicture = (region) => {
  const svg = region.querySelector("svg");
  const [left, width, top, bottom, first, last] = ["left", "width", "top", "bottom", "first", "last"].map((each) => Number(svg.dataset[each]));
  const readouts = [...svg.querySelectorAll("[data-readout]")];
  const cursor = added(svg, "path", { class: "cursor", visibility: "hidden" });
  const label = added(svg, "text", { class: "minor", y: bottom + 36, "text-anchor": "middle", visibility: "hidden" });
  const area = added(svg, "rect", { class: "selection", y: top, height: bottom - top, visibility: "hidden" });
  let signals = null;
  let place = left;
  let from = null;

  const timeAt = (x) => first + ((last - first) * (x - left)) / width;
  const written = (time) => time.toFixed(Math.max(0, Math.min(9, 3 - Math.floor(Math.log10(last - first || 1)))));
  const within = (event) => {
    const box = svg.getBoundingClientRect();
    const [start, , whole] = svg.getAttribute("viewBox").split(" ").map(Number);
    return Math.min(left + width, Math.max(left, start + ((event.clientX - box.left) * whole) / box.width));
  };

  const load = async () => {
    if (signals) return;
    signals = [];
    await attempt(async () => {
      const address = new URL(document.getElementById("run").dataset.values, location.href);
      for (const [name, value] of new URL(location.href).searchParams) if (!["view", "run"].includes(name)) address.searchParams.append(name, value);
      signals = (await askJson(address)).signals;
    });
    if (cursor.getAttribute("visibility") === "visible") show(place);
  };

  const show = (x) => {
    place = x;
    const time = timeAt(x);
    for (const each of [cursor, label]) each.setAttribute("visibility", "visible");
    cursor.setAttribute("d", `M${x} ${top}V${bottom}`);
    label.setAttribute("x", x);
    label.textContent = `${written(time)} s`;
    readouts.forEach((readout, index) => {
      const signal = signals?.[index];
      if (!signal) return;
      const beside = signal.beside.length ? ` (dashed: ${at(signal.beside, time)})` : "";
      readout.textContent = `${at(signal.points, time)}${beside}`;
    });
  };

  const hide = () => {
    for (const each of [cursor, label, area]) each.setAttribute("visibility", "hidden");
    for (const each of readouts) each.textContent = "";
  };

  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.pointerType === "touch") return;
    from = within(event);
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    load();
    const x = within(event);
    show(x);
    if (from === null || Math.abs(x - from) < SHORTEST) return;
    area.setAttribute("visibility", "visible");
    area.setAttribute("x", Math.min(x, from));
    area.setAttribute("width", Math.abs(x - from));
  });
  svg.addEventListener("pointerup", (event) => {
    const ends = [from, within(event)].sort((one, other) => one - other);
    const isZoom = from !== null && ends[1] - ends[0] >= SHORTEST;
    from = null;
    if (!isZoom) return;
    const address = new URL(location.href);
    address.searchParams.set("from", written(timeAt(ends[0])));
    address.searchParams.set("to", written(timeAt(ends[1])));
    draw(address.href);
  });
  svg.addEventListener("pointercancel", () => { from = null; hide(); });
  svg.addEventListener("pointerleave", () => { if (from === null) hide(); });

  region.addEventListener("focus", load);
  region.addEventListener("blur", hide);
  region.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    show(Math.min(left + width, Math.max(left, place + step * (event.shiftKey ? 20 : 2))));
    const titles = readouts.map((each) => `${each.previousElementSibling.textContent}: ${each.textContent}`);
    say([label.textContent, ...titles].join(", "));
  });
};

/** Replace the picture by that of another address; what had the focus has it again. */
const draw = (address) => attempt(async () => {
  const text = await askPart(address);
  if (text === null) return;
  const made = new DOMParser().parseFromString(text, "text/html");
  const focused = document.activeElement?.dataset.zoom;
  document.querySelector("form.signals").replaceWith(made.querySelector("form.signals"));
  document.getElementById("run").replaceWith(made.getElementById("run"));
  history.replaceState({}, "", address);
  mountRun();
  const region = document.querySelector("[data-run]");
  if (focused) (document.querySelector(`[data-zoom="${focused}"]`) ?? region)?.focus({ preventScroll: true });
  const { first, last } = region.querySelector("svg").dataset;
  say(`${first} to ${last} seconds`);
});

export const mountRun = () => {
  const region = document.querySelector("[data-run]");
  if (!region) return;
  mountPicture(region);
  document.querySelector(".zooms").addEventListener("click", (event) => {
    const link = event.target.closest("[data-zoom]");
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    draw(link.href);
  });
};
