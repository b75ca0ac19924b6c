import type { Page } from 'playwright-core';

/** Elements to press, type into or choose. */
const CONTROLS = [
  ...['button', 'a[href]', 'input', 'select', 'textarea', 'summary'],
  ...['[role=tab]', '[role=treeitem]', '[role=menuitem]', '[role=option]', '[role=slider]'],
].join();

export interface Control {
  readonly name: string;
  /** px; that of its label, if pressing the label counts as well */
  readonly width: number;
  readonly height: number;
  /** Whether it is completely on the page and not covered after scrolling to it. */
  readonly isReached: boolean;
}

/** Every visible control, except those on the time axis of the timeline. */
export function controlsOf(page: Page): Promise<Control[]> {
  return page.evaluate(async (selector) => {
    const shown = [...document.querySelectorAll<HTMLElement>(selector)].filter(
      (element) =>
        element.closest('.timeline__box, [inert], [aria-hidden=true]:not(.tree__more)') === null &&
        element.checkVisibility({ visibilityProperty: true }),
    );
    const found: Control[] = [];
    for (const element of shown) {
      element.scrollIntoView({ block: 'nearest', inline: 'nearest' });
      // long lists replace their rows
      if (!element.isConnected) continue;
      const target = element.closest('label') ?? element;
      const box = target.getBoundingClientRect();
      const own = element.getBoundingClientRect();
      const at = document.elementFromPoint(own.left + own.width / 2, own.top + own.height / 2);
      const isInside = own.left >= -1 && own.top >= -1 && own.right <= innerWidth + 1 && own.bottom <= innerHeight + 1;
      found.push({
        name: `${element.tagName.toLowerCase()} ${element.ariaLabel ?? target.textContent.trim().slice(0, 40)} .${element.className}`,
        width: Math.round(box.width * 10) / 10,
        height: Math.round(box.height * 10) / 10,
        isReached: isInside && at !== null && (target.contains(at) || at.contains(element)),
      });
    }
    return found;
  }, CONTROLS);
}
