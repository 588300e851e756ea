// The page to try a text: line numbers beside it with findings marked, and the findings as one types.
import { fail, progress, say, settle } from "./asking.js";
import { mountCompletion } from "./completion.js";

const PAUSE = 120; // longer than between two keys of a word

export const mountTry = () => {
  const form = document.querySelector("[data-try]");
  if (!form) return;
  const text = form.querySelector("[data-lines]");
  const gutter = form.querySelector("[data-gutter]");
  const outcome = document.getElementById("outcome");
  document.querySelector("[data-whole]")?.remove();
  let timer = 0;
  let under_way = null;
  let marks = new Map();
  let unread = null; // a file that is not text: its bytes are checked until the text is edited

  const readMarks = () => {
    const pairs = outcome.querySelector("[data-marks]").dataset.marks.split(" ").filter(Boolean);
    marks = new Map(pairs.map((pair) => pair.split(":")));
  };

  const number = () => {
    const count = text.value.split("\n").length;
    const rows = [];
    for (let line = 1; line <= count; line += 1) {
      const row = document.createElement("span");
      row.textContent = line;
      if (marks.has(String(line))) row.className = marks.get(String(line));
      rows.push(row);
    }
    gutter.replaceChildren(...rows);
    gutter.scrollTop = text.scrollTop;
  };

  const check = async () => {
    under_way?.abort();
    under_way = new AbortController();
    outcome.classList.add("waiting");
    outcome.setAttribute("aria-busy", "true");
    const url = new URL(form.action);
    url.searchParams.set("part", "");
    try {
      const sent = new FormData(form);
      sent.delete("file"); // its content is in the field
      if (unread) sent.set("file", unread);
      const body = unread ? sent : new URLSearchParams(sent);
      const response = await progress(fetch(url, { method: "POST", body, signal: under_way.signal }));
      const page = await response.text();
      settle();
      if (response.ok) {
        outcome.innerHTML = page;
        readMarks();
        number();
        say(outcome.querySelector("[data-tally]").textContent);
      } else {
        const lead = new DOMParser().parseFromString(page, "text/html").querySelector(".lead");
        outcome.querySelector("[data-tally]").textContent = lead?.textContent ?? "The text could not be checked.";
        if ([429, 503].includes(response.status)) timer = setTimeout(check, 1000 * (Number(response.headers.get("Retry-After")) || 2));
      }
    } catch (error) {
      if (error.name === "AbortError") return;
      fail("The service does not answer: the findings are those of an earlier text.", check);
    }
    outcome.classList.remove("waiting");
    outcome.removeAttribute("aria-busy");
  };

  const show = async (view) => {
    form.querySelector("[data-view]").value = view;
    await check();
    outcome.querySelector(`[name=view][value="${CSS.escape(view)}"]`)?.focus({ preventScroll: true });
  };

  text.addEventListener("input", () => { unread = null; number(); clearTimeout(timer); timer = setTimeout(check, PAUSE); });
  text.addEventListener("scroll", () => { gutter.scrollTop = text.scrollTop; }, { passive: true });
  form.addEventListener("submit", (event) => {
    if (event.submitter?.name === "download") return; // the browser saves the answer as a file
    event.preventDefault();
    clearTimeout(timer);
    if (event.submitter?.name === "view") show(event.submitter.value);
    else check();
  });
  form.querySelector("[data-file]")?.addEventListener("change", async (event) => {
    const [file] = event.target.files;
    if (!file) return;
    text.value = await file.text();
    unread = text.value.includes("\ufffd") ? file : null;
    marks = new Map(); // those of the text before
    event.target.value = ""; // the field holds it now, and may be edited
    number();
    check();
  });
  outcome.addEventListener("click", (event) => {
    const link = event.target.closest("[data-line]");
    if (!link) return;
    event.preventDefault();
    const lines = text.value.split("\n");
    const line = Math.min(Number(link.dataset.line), lines.length);
    const start = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
    text.focus();
    text.setSelectionRange(start + Math.max(Number(link.dataset.column) - 1, 0), start + lines[line - 1].length);
    text.scrollTop = Math.max(0, (line - 5) * (text.scrollHeight / lines.length));
  });
  addEventListener("pageshow", () => { // a reader who returns finds the typed text, and its errors
    number();
    if (text.value !== text.defaultValue) check();
  });
  mountCompletion(form, text);
  readMarks();
  number();
};
