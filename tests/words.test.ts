import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { formsInOutput, formsInSource, glossaryProblems } from './architecture/message-words.ts';

const root = join(import.meta.dirname, '..');
const read = (path: string): string => readFileSync(join(root, path), 'utf8');

const filesIn = (folder: string, end: RegExp): string[] =>
  readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && end.test(entry.name))
    .map((entry) =>
      join(entry.parentPath, entry.name)
        .slice(root.length + 1)
        .replaceAll('\\', '/'),
    )
    .sort();

/** Files that need the words of the original, because they read its files. */
const IMPORT = 'schema/exchange/import-original.ts';

describe('the glossary', () => {
  it('has a well-formed table in every section, and each term once', () => {
    expect(glossaryProblems(read('docs/glossary.md'))).toEqual([]);
  });

  it('is refused if it is not well-formed', () => {
    const table = (...rows: string[]) => ['| term | meaning | not |', '| --- | --- | --- |', ...rows].join('\n');
    expect(glossaryProblems(table('| tick | 1/60 s | step |'))).toEqual([]);
    expect(glossaryProblems(table())).toEqual(['1: there is no term']);
    expect(glossaryProblems(table('| tick | 1/60 s |'))).toEqual(['3: expected 3 cells, found 2', '1: there is no term']);
    expect(glossaryProblems(table('| tick | | step |'))).toHaveLength(1);
    expect(glossaryProblems(table('| tick | 1/60 s | step |', '| tick | again | |'))).toEqual(['4: tick is in line 3 already']);
    expect(glossaryProblems(table('| tick | 1/60 s | step, tick |'))).toEqual(['3: tick is not to be used for itself']);
    expect(glossaryProblems('| word | meaning | not |\n| --- | --- | --- |\n| a | b | c |')).toHaveLength(1);
  });
});

describe.each(['schema', 'engine', 'solver', 'check', 'cli', 'picture'])('the texts of %s', (room) => {
  it('contain none of the banned forms', () => {
    const found = filesIn(room, /\.tsx?$/).flatMap((path) =>
      formsInSource(path, read(path), path === IMPORT).map((form) => `${path}:${form}`),
    );
    expect(found).toEqual([]);
  });
});

it('the output of commands counts objects from 1', () => {
  const found = filesIn('tests/cli/fixtures', /\.txt$/)
    // JSON counts from 0
    .filter((path) => !read(path).startsWith('{'))
    .flatMap((path) => formsInOutput(read(path)).map((form) => `${path}:${form}`));
  expect(found).toEqual([]);
});

/** «x» stands for an expression in a template. */
const withTemplates = (code: string): string => code.replaceAll('«', ['$', '{'].join('')).replaceAll('»', '}');

describe('the search for banned forms', () => {
  it.each([
    ["f('the asteroids[0] is lost')", 'asteroids['],
    ['f(`the asteroids[«i»] is lost`)', 'asteroids['],
    ["f('collided with nova 0')", 'nova 0'],
    ['f(`hot asteroid «index» is near`)', 'asteroid «index»'],
    ['f(`target: asteroid «event.index»`)', 'asteroid «event.index»'],
    ["f('only the first 20 are told')", 'are told'],
    ["f('whoever has it')", 'whoever'],
    ["f('mend these first')", 'mend'],
    ["f('then all is well')", 'all is well'],
    ["f('3 really different runs')", 'really different'],
    ["f('lay files out canonically')", 'canonically'],
    ['f(<p>it hangs by a hair</p>)', 'hangs by'],
    ["f('--run and --holds exclude each other')", 'exclude each other'],
    ["f('a/b: can’t be looked into')", 'looked into'],
    ["f('it lies inside something deadly')", 'something deadly'],
    ["f('every shift by up to so much succeeds')", 'so much succeeds'],
    ["f('its grid is none')", 'its grid is none'],
    ["f('which the proof does not understand')", 'does not understand'],
    ["f('all goodies of the level')", 'goodies'],
  ])('finds it in %s', (code, form) => {
    expect(formsInSource('a.tsx', withTemplates(code))).toEqual([expect.stringContaining(`1: ${form}: `)]);
  });

  it.each([
    'f(asteroids[0])',
    "f('asteroids[0]')",
    '// the asteroids[0] is told',
    'f(`asteroid «index + 1» is near`)',
    'f(`the asteroid «name» is near`)',
    "f('asteroid 1 and nova 10')",
  ])('ignores %s', (code) => {
    expect(formsInSource('a.ts', withTemplates(code))).toEqual([]);
  });

  it('allows goodies in the import of original files', () => {
    expect(formsInSource(IMPORT, "f('all goodies of the level')", true)).toEqual([]);
  });

  it('reads the output of a command', () => {
    expect(formsInOutput('fine\n18.0 px clear of nova 0, near asteroids[2]')).toEqual(['2: asteroids[', '2: nova 0']);
  });
});
