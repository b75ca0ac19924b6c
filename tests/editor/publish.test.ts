import { createHash } from 'node:crypto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Editor } from '../../editor/context/index.ts';
import { type PublishWish, publish } from '../../editor/dialogs/publish.ts';
import { fetchGame, playPageOf, singlePage } from '../../editor/share/index.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';

const PAGE = `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <title>Gravity Quest</title>
    <script defer src="./pack.js" ></script>
    <script defer src="./game.js"></script>
  </head>
  <body>
    <div id="app"></div>
  </body>
</html>
`;

describe('one file with a page, its game and a pack', () => {
  it('has every script in it, after the elements, and a policy that lets exactly these run', () => {
    const letters = fc.constantFrom('</script>', '</SCRIPT', '<!--', '<script>', '$&', "'", '\\', '\r\n', 'é', 'x');
    const text = fc.array(letters, { maxLength: 8 }).map((parts) => parts.join(''));
    fc.assert(
      fc.property(text, text, (title, words) => {
        const game = { page: PAGE, scripts: new Map([['./game.js', `globalThis.words = ${JSON.stringify(words)};`]]) };
        const level = { id: words, level: { name: title } };
        const page = singlePage(game, { title, accuracy: 'precise', maxTime: 60, levels: [level] });
        expect(page).not.toMatch(/\bsrc=/);
        expect(page.indexOf('id="app"')).toBeLessThan(page.indexOf('<script>'));
        // as a browser splits it
        const scripts = [...page.matchAll(/<script>(.*?)<\/script/gis)].map(([, script]) => script);
        expect(scripts).toHaveLength(2);
        // after it, "<script" hides the end of the element
        expect(scripts.join('')).not.toContain('<!--');
        const hashes = scripts.map((script) => `'sha256-${createHash('sha256').update(script).digest('base64')}'`);
        expect(page.replaceAll('&#39;', "'")).toContain(`script-src ${hashes.join(' ')};`);
        const run = new Function('globalThis', scripts.join('\n'));
        const found: { words?: string; GRAVITY_QUEST_PACK?: unknown } = {};
        run(found);
        expect(found.words).toBe(words);
        expect(found.GRAVITY_QUEST_PACK).toEqual({ title, accuracy: 'precise', maxTime: 60, levels: [level] });
      }),
    );
  });

  it('is made of the game that comes with the page; what is missing is named', async () => {
    const asked: string[] = [];
    const get = (files: Readonly<Record<string, string>>): typeof fetch =>
      (async (url: URL) => {
        asked.push(url.href);
        const text = files[url.pathname];
        return { ok: text !== undefined, status: text === undefined ? 404 : 200, text: async () => text };
      }) as unknown as typeof fetch;
    const folder = 'https://me.example/editor/game/';
    const files = { '/editor/game/index.html': PAGE, '/editor/game/game.js': 'play()' };
    expect(await fetchGame(folder, get(files))).toEqual({ page: PAGE, scripts: new Map([['./game.js', 'play()']]) });
    // the pack is another one
    expect(asked).toEqual([`${folder}index.html`, `${folder}game.js`]);
    await expect(fetchGame(folder, get({ '/editor/game/index.html': PAGE }))).rejects.toThrow(/game\.js: status 404/);
    await expect(fetchGame(folder, () => Promise.reject(new TypeError('offline')))).rejects.toThrow(/index\.html: no answer/);
  });
});

describe('what is published', () => {
  const file = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });
  const texts: Readonly<Record<string, string>> = { a: formatLevel(file('A')), b: formatLevel(file('B')), bad: '{' };

  /** @param verdicts of the levels, by their text */
  function editorWith(ids: readonly string[], verdicts: Readonly<Record<string, string>>, isSaved = true) {
    const levels = ids.map((id) => ({ id, name: id.toUpperCase() }));
    const asked: unknown[] = [];
    const opened = { id: () => ids[0], saver: { flush: async () => isSaved } };
    const storage = {
      read: async (id: string) => ({ ok: true, value: { text: texts[id], problems: [{ message: 'expected a level' }] } }),
      publish: async (wanted: unknown) => {
        asked.push(wanted);
        return { ok: true, value: { site: '/levels/site', levels: 1, bytes: 1_250_000 } };
      },
    };
    const start = (_: string, { text }: { text: string }) => ({
      end: Promise.resolve({ kind: 'done', result: { verdict: verdicts[text] } }),
    });
    const editor = {
      workspace: { storage, store: { getState: () => ({ list: { levels, folder: { id: '' } }, opened }) } },
      desk: { workers: { start } },
      terms: { getState: () => ({ folder: DEFAULT_TERMS, shown: DEFAULT_TERMS }) },
    } as unknown as Editor;
    const shown: number[] = [];
    const wish = (more: Partial<PublishWish>): PublishWish => ({
      ...{ target: 'file', site: 'site', title: 'Levels', withRuns: true, force: false },
      onProgress: (checked) => shown.push(checked),
      ...more,
    });
    return { asked, shown, publish: (more: Partial<PublishWish>) => publish(editor, wish(more)) };
  }

  it('is what is saved: changes that can not be saved are named, and nothing is published without them', async () => {
    const unsaved = editorWith(['a'], {}, false);
    const answer = await unsaved.publish({ target: 'folder' });
    expect(answer).toEqual({
      kind: 'failed',
      reasons: [],
      message: 'The levels could not be published: the latest changes to “a” are not saved yet, and would be missing.',
    });
    expect(unsaved.asked).toEqual([]);
    const saved = editorWith(['a', 'b'], {});
    expect(await saved.publish({ target: 'levelFolder' })).toMatchObject({
      kind: 'done',
      message: expect.stringMatching(/^Published 1 level in \/levels\/site \(1\.3 MB\)/),
    });
    await saved.publish({ target: 'folder' });
    expect(saved.asked).toMatchObject([{ level: 'a' }, { level: null }]);
  });

  it('has no level that is not known to be completable, unless it is wanted, and never one that is not valid', async () => {
    const { publish: make, shown } = editorWith(['a', 'b', 'bad'], { [texts.a]: 'completable', [texts.b]: 'impossible' });
    const b = { id: 'b', name: 'B', verdict: 'impossible', message: 'it is proved that nobody can complete it' };
    const bad = { id: 'bad', name: 'BAD', verdict: 'invalid', message: 'expected a level' };
    for (const force of [false, true]) expect(await make({ force })).toEqual({ kind: 'refused', levels: [b, bad] });
    expect(shown.slice(0, 4)).toEqual([0, 1, 2, 3]);
    const other = editorWith(['b', 'a'], { [texts.b]: 'broken', [texts.a]: 'completable' });
    expect(await other.publish({ target: 'levelFile' })).toMatchObject({ kind: 'refused', levels: [{ id: 'b' }] });
  });
});

describe('the address of a published page', () => {
  it.each([
    ['https://me.github.io/levels/', 'https://me.github.io/levels/'],
    [' me.github.io/levels ', 'https://me.github.io/levels'],
    ['https://me.example/a?b=c#level=old', 'https://me.example/a?b=c'],
    ['http://localhost:3000', 'http://localhost:3000/'],
    ['localhost:3000/site/', 'http://localhost:3000/site/'],
    ['file:///home/me/site/index.html', 'file:///home/me/site/index.html'],
  ])('%s is %s', (typed, address) => {
    expect(playPageOf(typed)).toEqual({ ok: true, address });
  });

  it.each(['javascript:alert(1)', 'data:text/html,x', 'https://', 'a b', 'mailto:me@example.org'])('%s is none', (typed) => {
    expect(playPageOf(typed)).toMatchObject({ ok: false, message: expect.stringMatching(/^expected /) });
  });
});
