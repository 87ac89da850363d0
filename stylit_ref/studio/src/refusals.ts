// Answers of the server over HTTP: what it refuses it says in a sentence.

export class Refusal extends Error {}

/** By which the server knows the page: it lets the one that paints ask for more than others. */
let page = "";

export const namePage = (name: string) => void (page = name);

/** Ask, and get an answer; a `Refusal` tells what is wrong. */
export async function answerTo(address: string, request?: RequestInit): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(address, { ...request, headers: { ...request?.headers, "Stylit-Page": page } });
  } catch {
    throw new Refusal("The studio does not answer. Try again when the connection is back.");
  }
  if (response.ok) return response;
  const text = await response.text();
  let sentence = text;
  try {
    sentence = (JSON.parse(text) as { text?: string }).text ?? text;
  } catch {
    // It is a plain sentence.
  }
  throw new Refusal(sentence || `The studio refuses this (${response.status}).`);
}

export const sentenceOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
