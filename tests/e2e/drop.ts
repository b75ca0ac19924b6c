import type { Page } from 'playwright-core';

/** The content of a dropped file: bytes or a text. */
export type Dropped = readonly number[] | Uint8Array | string;

/** Drops files on the page, like a drag from a folder. */
export const drop = (page: Page, files: Readonly<Record<string, Dropped>>): Promise<void> => {
  const given = Object.entries(files).map(
    ([name, content]) => [name, typeof content === 'string' ? content : [...content]] as const,
  );
  return page.evaluate((all) => {
    const dataTransfer = new DataTransfer();
    for (const [name, content] of all) {
      dataTransfer.items.add(new File([typeof content === 'string' ? content : Uint8Array.from(content)], name));
    }
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, given);
};
