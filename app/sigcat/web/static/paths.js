// Completion of the path of a node in a field: the browser's own list, filled by the search. Without it one types the whole.

const SOUGHT = 50; // the search finds more than what has the typed text
const SHOWN = 12;
const PAUSE = 60; // as the search waits

const catalogueOf = (field) => field.closest("fieldset")?.querySelector("select")?.value ?? field.dataset.paths;

const found = async (catalogue, typed) => {
  const query = new URLSearchParams({ q: typed, limit: SOUGHT });
  const response = await fetch(`${document.body.dataset.base}/api/v1/catalogues/${encodeURIComponent(catalogue)}/search?${query}`).catch(() => null);
  const { hits } = response?.ok ? await response.json() : { hits: [] };
  return hits.filter(({ path }) => path.toLowerCase().includes(typed.toLowerCase())).slice(0, SHOWN);
};

const offered = ({ path, type, datatype, unit }) => Object.assign(document.createElement("option"), { value: path, label: [path, type, datatype, unit].filter(Boolean).join(" ") });

const mount = (field, index) => {
  const list = Object.assign(document.createElement("datalist"), { id: `paths-${index}` });
  let timer = 0;
  const fill = async () => {
    const typed = field.value.trim();
    const hits = typed ? await found(catalogueOf(field), typed) : [];
    if (field.value.trim() === typed) list.replaceChildren(...hits.map(offered)); // not an answer to what was typed before
  };
  field.after(list);
  field.setAttribute("list", list.id);
  field.addEventListener("input", () => { clearTimeout(timer); timer = setTimeout(fill, PAUSE); });
};

export const mountPaths = () => document.querySelectorAll("[data-paths]").forEach(mount);
