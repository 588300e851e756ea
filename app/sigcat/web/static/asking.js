// Asking the service: a bar while it takes long, and a message that offers to try again where it fails.

const SOON = 200; // what is there sooner needs no bar
const bar = document.getElementById("progress");
const failure = document.getElementById("failure");
let pending = 0;
let announced = 0;
let again = null;

/** Tell users of a screen reader what changed. */
export const say = (text) => { document.getElementById("said").textContent = text; };

// -- progress ---------------------------------------------------------------------------------------------------------

export const begin = () => {
  pending += 1;
  if (pending === 1) announced = setTimeout(() => { bar.hidden = false; }, SOON);
};

const end = () => {
  pending = Math.max(0, pending - 1);
  if (pending) return;
  clearTimeout(announced);
  bar.hidden = true;
};

/** Wait for something, with a bar if it takes long. */
export const progress = async (work) => {
  begin();
  try {
    return await work;
  } finally {
    end();
  }
};

addEventListener("pageshow", () => { pending = 0; end(); }); // also where the browser comes back to a page that left

// -- failure ----------------------------------------------------------------------------------------------------------

export class Unanswered extends Error {}

/** Say why something failed, and offer to do it again. */
export const fail = (reason, retry) => {
  again = retry;
  failure.querySelector("p").textContent = reason;
  failure.hidden = false;
};

export const settle = () => { failure.hidden = true; };

/** Do what asks the service. Where that fails, the message offers to do the same again; on failure the old state stays. */
export const attempt = async (work) => {
  try {
    await work();
    settle();
  } catch (error) {
    if (error.name === "AbortError") return;
    if (!(error instanceof Unanswered)) throw error;
    fail(error.message, () => attempt(work));
  }
};

failure.querySelector("[data-again]").addEventListener("click", async () => {
  await again();
  if (failure.hidden) document.getElementById("content").focus({ preventScroll: true }); // the button that had it is gone
});
failure.querySelector("[data-dismiss]").addEventListener("click", settle);

// -- asking -----------------------------------------------------------------------------------------------------------

const reasonOf = ({ status }) => {
  if (status === 429) return "Too much is asked from here at once.";
  if (status === 503) return "The service is busy.";
  return status >= 500 ? `The service failed (${status}).` : `The service has no answer to this (${status}).`;
};

const answered = async (address, signal, read) => {
  try {
    const response = await fetch(address, { signal });
    return { response, content: response.ok ? await read(response) : null };
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Unanswered("The service does not answer.");
  }
};

/** What an address holds. Raises Unanswered unless there is a good answer. */
export const askJson = async (address, signal) => {
  const { response, content } = await progress(answered(address, signal, (each) => each.json()));
  if (!response.ok) throw new Unanswered(reasonOf(response));
  return content;
};

let under_way = null;

/** The changing part of a page; null if a later request overtook this one, or if the whole page is loaded instead. */
export const askPart = async (address) => {
  under_way?.abort();
  under_way = new AbortController();
  const url = new URL(address, location.href);
  url.searchParams.set("part", "");
  try {
    const { response, content } = await progress(answered(url, under_way.signal, (each) => each.text()));
    if (response.status >= 500) throw new Unanswered(reasonOf(response));
    if (!response.ok) location.assign(address); // the page describes the error of the address
    return content;
  } catch (error) {
    if (error.name !== "AbortError") throw error;
    return null;
  }
};
