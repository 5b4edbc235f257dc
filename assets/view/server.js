// What the page asks of the program that serves it.

export const client = crypto.getRandomValues(new Uint32Array(2)).join("-");

export class Refusal extends Error {}

async function answered(response) {
  if (response.status === 200) return response;
  if (response.status === 202 || response.status === 204 || response.status === 409 || response.status === 429) return null;
  throw new Refusal(await response.text());
}

async function asked(path, options) {
  return answered(await ask(path, options));
}

/** The response as it is. */
export async function ask(path, options) {
  let response;
  try {
    response = await fetch(path, options);
  } catch {
    throw new Refusal("fumon does not answer: it has ended, or the line to it is cut");
  }
  return response;
}

export async function get(path) {
  const response = await asked(path);
  return response.json();
}

/** The response, or null where the program works on something newer or is not that far yet. */
export function post(path, body) {
  return asked(path, { method: "POST", body: JSON.stringify({ client, ...body }) });
}

export async function postForJson(path, body) {
  return (await post(path, body)).json();
}

/** Saves by the program, or hands the file to the browser; says where it is. */
export async function save(path, body) {
  const response = await post(path, body);
  if (!response) throw new Refusal("it is not computed yet; try again");
  if (response.headers.get("Content-Type").startsWith("application/json")) return (await response.json()).saved;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(await response.blob());
  link.download = body.name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  return `${body.name}, to where this browser saves`;
}
