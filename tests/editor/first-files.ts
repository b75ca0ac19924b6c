import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The page as it is built. */
export const BUILT_PAGE = fileURLToPath(new URL('../../dist/editor', import.meta.url));

const read = (path: string): Buffer => readFileSync(join(BUILT_PAGE, path));

/**
 * All that a browser loads before the page shows a level, by its path in the page: the document, its style sheet, its script, and
 * what that imports at once. Workers come besides: they are asked for what the page shows later.
 */
export function firstFiles(): ReadonlyMap<string, Buffer> {
  const files = new Map([['index.html', read('index.html')]]);
  const add = (path: string) => {
    if (files.has(path)) return;
    const content = read(path);
    files.set(path, content);
    if (!path.endsWith('.js')) return;
    for (const [, name] of content.toString().matchAll(/(?:\bfrom|\bimport)\s*"\.\/([\w.-]+\.js)"/g)) add(`assets/${name}`);
  };
  const html = (files.get('index.html') as Buffer).toString();
  for (const [, path] of html.matchAll(/(?:src|href)="\.\/(assets\/[^"]+)"/g)) add(path);
  return files;
}
