import { readdirSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

// The page loads all of its stylesheets together: two parts that give a class the same name would dress each other.

const editor = fileURLToPath(new URL('../../editor/', import.meta.url));
/** They change how others look, for a finger and for high contrast. */
const FOR_ALL = ['core/ui/touch.css', 'core/ui/contrast.css'];

/** The classes that a stylesheet dresses by themselves: `.note`, not `.row .note`; looks of them (`.note--old`) may be shared. */
function classesIn(css: string): Set<string> {
  const rules = css.replace(/\/\*[\s\S]*?\*\//g, '').matchAll(/([^{}]+)\{/g);
  const alone = [...rules].flatMap(([, selectors]) =>
    selectors.split(',').flatMap((selector) => /^\.([a-z]\w*(?:-\w+)*)$/.exec(selector.trim())?.[1] ?? []),
  );
  return new Set(alone);
}

it('no class is dressed by two parts of the page', () => {
  const owners = new Map<string, string[]>();
  const sheets = readdirSync(editor, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && entry.name.endsWith('.css'))
    .map((entry) => relative(editor, join(entry.parentPath, entry.name)).split(sep).join('/'))
    .filter((sheet) => !FOR_ALL.includes(sheet));
  expect(sheets.length).toBeGreaterThan(20);
  for (const sheet of sheets)
    for (const name of classesIn(readFileSync(join(editor, sheet), 'utf8')))
      owners.set(name, [...(owners.get(name) ?? []), sheet]);
  expect([...owners].filter(([, those]) => those.length > 1)).toEqual([]);
});
