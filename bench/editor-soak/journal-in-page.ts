import type { Page } from 'playwright-core';

/** What is looked for in the journal: the asteroid's x, px. */
const READ = `new Promise((resolve) => {
  const opening = indexedDB.open('gravity-quest-editor-journal');
  opening.onerror = () => resolve(null);
  opening.onsuccess = () => {
    const database = opening.result;
    const found = [];
    const reading = database.transaction(['heads', 'entries'], 'readonly');
    for (const name of ['heads', 'entries']) reading.objectStore(name).getAll().onsuccess = (event) => found.push(...event.target.result);
    reading.oncomplete = () => { database.close(); resolve(JSON.stringify(found)); };
    reading.onabort = () => { database.close(); resolve(null); };
  };
})`;

/** The farthest place of the object that the page's journal has; null if the journal could not be read. */
export async function furthestKept(page: Page): Promise<number | null> {
  const text = (await page.evaluate(READ)) as string | null;
  if (text === null) return null;
  // for a step that moves an object, the patch has its new x; a text of the whole level has its line
  const places = [...text.matchAll(/"(?:x\\?"|value")\s*:\s*(\d{4,})/g)].map(([, x]) => Number(x));
  return places.length === 0 ? null : Math.max(...places);
}
