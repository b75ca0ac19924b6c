import { existsSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import process from 'node:process';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { makeFolders } from '../../cli/io/disk.ts';
import { gqProcess, makeFiles } from './gq.ts';

const place = makeFiles({});
afterAll(place.remove);

/** What a function returns, or the code of its error. */
function outcome(make: () => string | undefined): string | undefined {
  try {
    const made = make();
    return made === undefined ? undefined : resolve(made);
  } catch (error) {
    return (error as NodeJS.ErrnoException).code;
  }
}

const isFolder = (path: string): boolean => existsSync(`${path}/.`);

describe('makeFolders', () => {
  it('makes what mkdirSync makes, returns the same and refuses what it refuses', () => {
    const name = fc.constantFrom('a', 'b', 'file', 'link', 'nowhere', '.', '..', 'c');
    fc.assert(
      fc.property(fc.array(name, { minLength: 1, maxLength: 6 }), (names) => {
        // a path that leads out of the folder would differ between the two
        let depth = 0;
        for (const one of names) {
          depth += one === '..' ? -1 : one === '.' ? 0 : 1;
          if (depth < 0) return;
        }
        const [own, nodes] = ['own', 'nodes'].map((folder) => {
          const root = join(place.directory, folder);
          rmSync(root, { recursive: true, force: true });
          mkdirSync(join(root, 'a'), { recursive: true });
          writeFileSync(join(root, 'file'), '');
          symlinkSync('a', join(root, 'link'));
          symlinkSync('missing', join(root, 'nowhere'));
          return root;
        });
        const of = (root: string): string => `${root}/${names.join('/')}`;
        const made = outcome(() => makeFolders(of(own)));
        const expected = outcome(() => mkdirSync(of(nodes), { recursive: true }));
        // of a broken link, each says something else
        const isRefused = expected?.startsWith('E') === true;
        expect(isRefused ? made?.charAt(0) : made?.replace(own, nodes)).toBe(isRefused ? 'E' : expected);
        expect(isFolder(of(own))).toBe(isFolder(of(nodes)));
      }),
      { numRuns: 300 },
    );
  });

  it.runIf(process.platform === 'linux')('ends where mkdirSync does not', async () => {
    expect(outcome(() => makeFolders('/proc/no/such'))).toMatch(/^E/);
    const { code, stderr } = await gqProcess(['generate', '--out', '/proc/no/such', '--count', '1']);
    expect(code).toBe(2);
    expect(stderr).toContain('/proc/no/such');
  });
});
