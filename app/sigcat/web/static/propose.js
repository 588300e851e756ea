// The form of a proposed change: its overlay, findings and effects as one types.
import { fail, progress, say, settle } from "./asking.js";

const PAUSE = 150; // longer than between two keys of a word

export const mountProposal = () => {
  const form = document.querySelector("[data-proposal]");
  if (!form) return;
  const outcome = document.getElementById("outcome");
  let timer = 0;
  let under_way = null;

  const check = async () => {
    under_way?.abort();
    under_way = new AbortController();
    outcome.setAttribute("aria-busy", "true");
    const url = new URL(form.action);
    url.searchParams.set("part", "");
    try {
      const response = await progress(fetch(url, { method: "POST", body: new URLSearchParams(new FormData(form)), signal: under_way.signal }));
      const page = await response.text();
      settle();
      if (response.ok) {
        outcome.innerHTML = page;
        say(outcome.querySelector("[data-tally]").textContent);
      } else if ([429, 503].includes(response.status)) {
        timer = setTimeout(check, 1000 * (Number(response.headers.get("Retry-After")) || 2));
      } else {
        fail(`The service has no answer to this (${response.status}).`, check);
      }
    } catch (error) {
      if (error.name === "AbortError") return;
      fail("The service does not answer: the findings are those of earlier values.", check);
    }
    outcome.removeAttribute("aria-busy");
  };

  form.addEventListener("input", () => { clearTimeout(timer); timer = setTimeout(check, PAUSE); });
  form.addEventListener("submit", (event) => {
    if (event.submitter?.name) return; // the browser saves a file, or shows the page with the text
    event.preventDefault();
    clearTimeout(timer);
    check();
  });
  addEventListener("pageshow", () => {
    const isEdited = [...form.querySelectorAll("input:not([type=hidden]), textarea")].some((each) => each.value !== each.defaultValue);
    if (isEdited) check();
  });
};
