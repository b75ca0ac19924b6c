import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { PROJECT } from './docs/page.ts';

// docs/compared.md claims that a test shows each row of gq

const page = readFileSync(join(PROJECT, 'docs/compared.md'), 'utf8');
const rowsOf = (text: string): string[][] =>
  text
    .split('\n')
    .filter((line) => line.startsWith('| '))
    .slice(2)
    .map((line) =>
      line
        .slice(2, -2)
        .split(' | ')
        .map((cell) => cell.trim()),
    );

const [comparison, shown] = page.split('## What shows it').map(rowsOf);

describe('docs/compared.md', () => {
  it('has a cell for each tool', () => {
    expect(comparison.length).toBeGreaterThan(20);
    expect(comparison.filter((row) => row.length !== 8 || row.includes(''))).toEqual([]);
  });

  it('names a test for each row that gq has, and for no other', () => {
    const claimed = comparison.filter(([, ours]) => ours !== '-').map(([what]) => what);
    expect(shown.map(([what]) => what)).toEqual(claimed);
  });

  it.each(shown)('%s: the test is there', (_, test) => {
    const [, file, title] = /^`(.+)`: (.+)$/.exec(test) ?? [];
    expect(existsSync(join(PROJECT, file)), file).toBe(true);
    expect(readFileSync(join(PROJECT, file), 'utf8')).toContain(`'${title}'`);
  });

  it('names the versions of the tools that are here', () => {
    const { devDependencies } = JSON.parse(readFileSync(join(PROJECT, 'package.json'), 'utf8'));
    for (const [tool, name] of [
      ['vitest', 'vitest'],
      ['biome', '@biomejs/biome'],
      ['knip', 'knip'],
    ])
      expect(page).toContain(`${tool} ${devDependencies[name]}`);
  });
});
