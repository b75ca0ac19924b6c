import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, it } from 'vitest';

const ROOT = new URL('../../', import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, ROOT), 'utf8');

interface Survivor {
  readonly file: string;
  readonly at: string;
  readonly before: string;
}

it('every excused mutant is of a line that is still there', () => {
  const survivors: Survivor[] = JSON.parse(read('bench/mutation/survivors.json'));
  expect(survivors.length).toBeGreaterThan(0);
  const gone = survivors.filter(({ file, at, before }) => {
    const text = read(file);
    return !text.includes(before) || !text.split('\n').some((line) => line.trim() === at);
  });
  expect(gone, `mend or delete these in ${fileURLToPath(new URL('bench/mutation/survivors.json', ROOT))}`).toEqual([]);
});
