import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { isDeep, someOf } from '../depth.ts';
import { isUpdating, PROJECT } from '../docs/page.ts';
import { draw, pageText, pictureOf, ROUNDING, rowOf } from './page.ts';
import { sections } from './sections.ts';

// Holds docs/hard-cases.md to the code. `npm run docs:outputs` writes page and pictures anew.

const PAGE = 'docs/hard-cases.md';
const read = (path: string): string => readFileSync(join(PROJECT, path), 'utf8');

/** What a cell says: its words, and its number, if it has one. */
function said(cell: string): { words: string; number: number } {
  const found = /(?:< )?(\d[\d.]*(?:e-?\d+)?)(?= s|$)/.exec(cell);
  const number = found === null ? ROUNDING : Math.max(ROUNDING, Number(found[1]));
  return { words: found === null ? cell : cell.replace(found[0], ''), number };
}

const cellsOf = (row: string): string[] => row.slice(2, -2).split(/ +\| +/);

describe('docs/hard-cases.md', () => {
  const list = sections();
  const all = list.flatMap(({ cases }) => cases);

  it('has every case, and says what the code has to say', () => {
    if (isUpdating()) {
      // the quick set computes only some of the rows
      if (isDeep) writeFileSync(join(PROJECT, PAGE), pageText(rowOf));
      return;
    }
    const text = read(PAGE);
    const rows = new Map(
      text
        .split('\n')
        .filter((line) => line.startsWith('| '))
        .map((line) => [cellsOf(line)[0], line]),
    );
    expect(all.filter(({ name }) => !rows.has(name)).map(({ name }) => name)).toEqual([]);
    expect(text).toBe(pageText(({ name }) => rows.get(name) as string));
  });

  it.each(someOf(all, 16))('has the outcomes of $name, and its figures within a factor of ten', (c) => {
    if (isUpdating()) return;
    const rows = read(PAGE).split('\n');
    const shown = cellsOf(rows.find((line) => line.startsWith(`| ${c.name} `)) as string);
    for (const [i, cell] of cellsOf(rowOf(c)).entries()) {
      const [now, then] = [said(cell), said(shown[i])];
      expect(then.words).toBe(now.words);
      // how near the references are to each other is a matter of their last digits
      if (i < shown.length - 1) expect(Math.abs(Math.log10(then.number / now.number)), cell).toBeLessThan(1);
    }
  });

  it.each(list)('has the picture that the code draws: $title', (section) => {
    const drawn = draw(section);
    if (isUpdating()) writeFileSync(join(PROJECT, pictureOf(section)), drawn);
    else expect(drawn === read(pictureOf(section)), `npm run docs:outputs draws ${pictureOf(section)} anew`).toBe(true);
    expect(drawn.length).toBeLessThan(30_000);
  });
});
