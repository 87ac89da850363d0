// Elements of the page: those that stand in it, and those that are made.

export const byId = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

/** An element with properties and what it holds. */
export function made<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Partial<HTMLElementTagNameMap[K]> = {},
  ...held: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...held);
  return element;
}

/** Whether keys typed there are text, or for the element itself. */
export const takesLetters = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  target.matches("input:not([type=range], [type=checkbox], [type=radio]), select, textarea, iframe, dialog *");

/** Whether Space means something there. */
export const takesSpace = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement && target.matches("button, a, summary, input, select, textarea, iframe, dialog *");
