// Calls of the API from its reference: the answer of this service to the values that one enters.
import { attempt, progress, say, Unanswered } from "./asking.js";

const SHOWN = 20_000; // characters of an answer

const addressOf = (form) => {
  let path = form.dataset.path;
  const query = new URLSearchParams();
  for (const field of form.querySelectorAll("[data-in]")) {
    if (field.dataset.in === "path") path = path.replace(`{${field.name}}`, encodeURIComponent(field.value));
    else if (field.value) query.append(field.name, field.value);
  }
  return query.size ? `${path}?${query}` : path;
};

const sent = async (form) => {
  const headers = form.token.value ? { Authorization: `Bearer ${form.token.value}` } : {};
  const body = form.body?.value;
  try {
    const response = await progress(fetch(addressOf(form), { method: form.dataset.method, headers, body }));
    const type = response.headers.get("Content-Type") ?? "";
    const isText = /json|text|yaml|xml|csv/.test(type);
    const content = isText ? await response.text() : `${type}, ${(await response.blob()).size} bytes`;
    const rest = content.length > SHOWN ? `\n… ${content.length - SHOWN} more characters` : "";
    return `${response.status} ${response.statusText}\n\n${content.slice(0, SHOWN)}${rest}`;
  } catch {
    throw new Unanswered("The service does not answer.");
  }
};

export const mountCalls = () => {
  for (const form of document.querySelectorAll("[data-call]")) {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      attempt(async () => {
        const answer = form.parentElement.querySelector("[data-answer]");
        answer.textContent = await sent(form);
        answer.hidden = false;
        say(`Answer: ${answer.textContent.split("\n")[0]}`);
      });
    });
  }
};
