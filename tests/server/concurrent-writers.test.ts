import { readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readLevel } from '../../schema/index.ts';
import { itDeep, itQuick } from '../depth.ts';
import { gqEdit } from './command.ts';
import { levelPath, levelText, makeFolder, type Page, pageOf, serve } from './running.ts';

// Each writer adds its own marks to a level that others write at the same time. An acknowledged mark is never lost.

const start = (): string => JSON.stringify({ ...JSON.parse(levelText('shared')), 'x-marks': [] });
const marksIn = (text: string): string[] => JSON.parse(text)['x-marks'];
const withMark = (text: string, mark: string): string =>
  JSON.stringify({ ...JSON.parse(text), 'x-marks': [...marksIn(text), mark] });

type Seen = { etag: string; text: string };

/** Adds a mark as the editor would: to the content that it last saw, and after a conflict to the current one. */
async function add(page: Page, id: string, seen: Seen, mark: string): Promise<Seen> {
  for (let base = seen; ; ) {
    const text = withMark(base.text, mark);
    const answer = await page.send('PUT', levelPath(id), { text, client: 'writer' }, { 'If-Match': base.etag });
    if (answer.status === 200) return { text, etag: String(answer.headers.etag) };
    expect(answer.status).toBe(412);
    const { current } = (answer.json() as { error: { current: Seen } }).error;
    expect(marksIn(current.text)).not.toContain(mark);
    base = current;
  }
}

const read = async (page: Page, id: string): Promise<Seen> => (await page.get(levelPath(id))).json();

describe('writers at the same time', () => {
  it('lose no acknowledged change with two servers and another program in between', async () => {
    const made = makeFolder({});
    const servers = await Promise.all([serve(made.folder), serve(made.folder)]);
    const writer = fc.record({
      server: fc.nat(1),
      levels: fc.array(fc.nat(1), { minLength: 1, maxLength: 6 }),
      pauses: fc.array(fc.nat(5), { minLength: 6, maxLength: 6 }),
    });
    const pause = async (turns: number): Promise<void> => {
      for (let i = 0; i < turns; i++) await new Promise(setImmediate);
    };
    await fc.assert(
      fc.asyncProperty(
        fc.array(writer, { minLength: 2, maxLength: 5 }),
        fc.array(fc.nat(20), { maxLength: 4 }),
        async (writers, others) => {
          const ids = ['one', 'two'];
          for (const id of ids) writeFileSync(join(made.folder, `${id}.level.json`), start());
          const acknowledged: Record<string, string[]> = { one: [], two: [] };
          const work = writers.map(async ({ server, levels, pauses }, w) => {
            const { page } = servers[server];
            const seen: Record<string, Seen> = { one: await read(page, 'one'), two: await read(page, 'two') };
            for (const [i, level] of levels.entries()) {
              const id = ids[level];
              await pause(pauses[i]);
              seen[id] = await add(page, id, seen[id], `${w}.${i}`);
              acknowledged[id].push(`${w}.${i}`);
            }
          });
          // a program that ignores the lock and writes immediately
          const other = async (): Promise<void> => {
            for (const [i, turns] of others.entries()) {
              await pause(turns);
              const path = join(made.folder, 'one.level.json');
              writeFileSync(`${path}.new`, withMark(readFileSync(path, 'utf8'), `other.${i}`));
              renameSync(`${path}.new`, path);
              acknowledged.one.push(`other.${i}`);
            }
          };
          await Promise.all([...work, other()]);
          for (const id of ids) {
            const text = readFileSync(join(made.folder, `${id}.level.json`), 'utf8');
            expect(marksIn(text).sort()).toEqual(acknowledged[id].sort());
          }
          expect(readdirSync(made.folder).sort()).toEqual(['one.level.json', 'two.level.json']);
        },
      ),
      { numRuns: 8 },
    );
    for (const server of servers) {
      expect(server.crashes).toEqual([]);
      await server.close();
    }
    made.remove();
  });

  itQuick('create a new level only once', async () => {
    const made = makeFolder({});
    const servers = await Promise.all([serve(made.folder), serve(made.folder)]);
    for (let round = 0; round < 10; round++) {
      const answers = await Promise.all(
        Array.from({ length: 6 }, (_, w) =>
          servers[w % 2].page.send(
            'PUT',
            levelPath(`new-${round}`),
            { text: levelText(`${w}`), client: 'c' },
            { 'If-None-Match': '*' },
          ),
        ),
      );
      const made201 = answers.flatMap(({ status }, w) => (status === 201 ? [w] : []));
      expect(made201).toHaveLength(1);
      const text = readFileSync(join(made.folder, `new-${round}.level.json`), 'utf8');
      expect(text).toBe(levelText(`${made201[0]}`));
      for (const answer of answers)
        if (answer.status !== 201) expect(answer.json()).toMatchObject({ error: { current: { text } } });
    }
    await Promise.all(servers.map((server) => server.close()));
    made.remove();
  });

  itDeep('lose nothing in several processes', async () => {
    const made = makeFolder({ 'one.level.json': start() });
    const edits = await Promise.all([1, 2, 3].map(() => gqEdit(['.', '--port', '0'], { cwd: made.folder })));
    await Promise.all(
      edits.map(async (edit, w) => {
        const page = pageOf(edit);
        let seen = await read(page, 'one');
        for (let i = 0; i < 15; i++) seen = await add(page, 'one', seen, `${w}.${i}`);
      }),
    );
    const text = readFileSync(join(made.folder, 'one.level.json'), 'utf8');
    expect(marksIn(text)).toHaveLength(45);
    expect(new Set(marksIn(text)).size).toBe(45);
    expect(readLevel(text).ok).toBe(true);
    await Promise.all(edits.map((edit) => edit.end('SIGTERM')));
    made.remove();
  });
});
