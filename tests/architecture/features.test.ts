import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { importsOf } from './inspect-source.ts';

// A feature of the page is a folder with a record. Whoever adds or removes one touches its folder, the list, and little else.

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const sources = readdirSync(join(root, 'editor'), { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && /\.tsx?$/.test(entry.name))
  .map((entry) => relative(root, join(entry.parentPath, entry.name)).split(sep).join('/'))
  .map((path) => {
    const text = readFileSync(join(root, path), 'utf8');
    const local = importsOf(path, text).filter((name): name is string => name?.startsWith('.') === true);
    return { path, text, targets: local.map((name) => posix.join(dirname(path), name)) };
  })
  .sort((a, b) => (a.path < b.path ? -1 : 1));

/** What stands on what: a folder knows those before its own row, and of its row itself alone. */
const ROWS: readonly (readonly string[])[] = [['workers'], ['core'], ['canvas', 'timeline'], ['features'], ['app'], ['main.tsx']];

describe('arrows inside the editor', () => {
  const folderOf = (path: string) => path.split('/')[1];
  const rowOf = (path: string) => ROWS.findIndex((row) => row.includes(folderOf(path)));

  it('every file has a row', () => {
    const others = sources.filter(({ path }) => rowOf(path) < 0).map(({ path }) => path);
    expect(others).toEqual(['editor/vite.config.ts']);
  });

  it('none runs up or across', () => {
    const wrong = sources.flatMap(({ path, targets }) =>
      targets
        .filter((target) => target.startsWith('editor/') && rowOf(path) >= 0)
        .filter((target) => folderOf(target) !== folderOf(path) && rowOf(target) >= rowOf(path))
        .map((target) => `${path} -> ${target}`),
    );
    expect(wrong.sort()).toEqual([]);
  });
});

const LIST = 'editor/features/index.ts';
const folders = readdirSync(join(root, 'editor/features'), { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name);

/** The folders outside its own that know a feature, besides the list. */
const knowing = (name: string): string[] => {
  const own = `editor/features/${name}/`;
  const others = sources.filter(
    ({ path, targets }) => !path.startsWith(own) && path !== LIST && targets.some((target) => target.startsWith(own)),
  );
  return [...new Set(others.map(({ path }) => dirname(path)))];
};

describe.each(folders)('the feature %s', (name) => {
  it('has a record of its name, which is on the list', () => {
    const record = sources.find(({ path }) => path === `editor/features/${name}/feature.tsx`);
    expect(record?.text).toMatch(new RegExp(`export const ${name}: Feature = \\{[^}]*name: '${name}'`));
    expect(sources.find(({ path }) => path === LIST)?.targets).toContain(`editor/features/${name}/feature.tsx`);
  });

  it('is known in three places at most: its folder, the list, one more', () => {
    const others = knowing(name);
    expect(others.length, others.join(', ')).toBeLessThanOrEqual(1);
  });
});

describe('layers', () => {
  const declared = (text: string) => [...text.matchAll(/\bid: '(\w+)', title: [^\n]*isShown:/g)].map(([, id]) => id);
  const layers = sources.flatMap(({ text }) => declared(text));

  it('whoever reads one names one that is there', () => {
    const read = sources.flatMap(({ text }) => [...text.matchAll(/\blayers\.([a-zA-Z]+)\b(?! *\()/g)].map(([, id]) => id));
    expect(layers.length).toBeGreaterThan(8);
    expect([...new Set(read)].filter((id) => !layers.includes(id) && id !== 'ts')).toEqual([]);
  });

  it('one of a feature is read by its own files alone', () => {
    const strangers = sources.flatMap(({ path, text }) => {
      const own = /^editor\/features\/\w+\//.exec(path)?.[0];
      if (own === undefined || !path.endsWith('/feature.tsx')) return [];
      return declared(text).flatMap((id) =>
        sources
          .filter((other) => !other.path.startsWith(own) && new RegExp(`\\blayers\\.${id}\\b`).test(other.text))
          .map((other) => `${other.path}: ${id}`),
      );
    });
    // the list of deaths shows its map
    expect(strangers).toEqual(['editor/features/attempts/DeathList.tsx: deaths']);
  });
});
