// monitor/web/src/dom.ts: making and changing elements; text goes in as text, never as markup.

const SVG = "http://www.w3.org/2000/svg";

export type Attributes = Record<string, string | number>;

export function svg<Name extends keyof SVGElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  parent?: Element,
): SVGElementTagNameMap[Name] {
  const element = document.createElementNS(SVG, name);
  set(element, attributes);
  parent?.append(element);
  return element;
}

export function html<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  className = "",
  parent?: Element,
  text = "",
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  if (className) element.className = className;
  if (text) element.textContent = text;
  parent?.append(element);
  return element;
}

/** Numbers are rounded to hundredths: finer is not seen, and makes every frame differ. */
export function set(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    const text = typeof value === "number" ? String(Math.round(value * 100) / 100) : value;
    if (element.getAttribute(name) !== text) element.setAttribute(name, text);
  }
}

export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no element "${id}"`);
  return element;
}

/** Elements that are made when their key first shows and removed when it is gone. */
export class Keyed<Item> {
  private readonly items = new Map<string, { item: Item; root: Element }>();

  constructor(private readonly make: (key: string) => { item: Item; root: Element }) {}

  get(key: string): Item {
    let entry = this.items.get(key);
    if (!entry) {
      entry = this.make(key);
      this.items.set(key, entry);
    }
    return entry.item;
  }

  keepOnly(keys: Set<string>): void {
    for (const [key, entry] of this.items) {
      if (keys.has(key)) continue;
      entry.root.remove();
      this.items.delete(key);
    }
  }
}
