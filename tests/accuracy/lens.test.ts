import { expect, it } from 'vitest';
import { drawLens, waysAtAll } from '../../cli/commands/accuracy/lens.ts';
import { ACCURACIES, DEFAULT_TERMS } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { pack } from '../levels/shipped-pack.ts';
import { SPECK } from './scenes.ts';

const count = (svg: string, part: RegExp): number => svg.match(part)?.length ?? 0;

it('a run at all accuracies is drawn once for each, and glows where it is first a pixel from precise', () => {
  const { level } = pack.find(({ slug }) => slug.endsWith('grand-tour'))!;
  const ways = waysAtAll(level, level.runs[0].holds, DEFAULT_TERMS);
  const svg = drawLens(level, 'solution', ways, 'dark');
  expect(ways[0].label).toMatch(/; a pixel from precise at 4\.5\d s; first otherwise: /);
  expect(count(svg, /data-kind="way"/g)).toBe(Object.keys(ACCURACIES).length);
  // only arcade parts from it
  expect(svg.match(/data-kind="glow" data-index="\d"/g)).toEqual(['data-kind="glow" data-index="0"']);
  expect(svg).toContain('Grand Tour at all accuracies');
});

it('says which contact decided where an outcome flips', () => {
  const labels = waysAtAll(resolveLevel(SPECK), [], DEFAULT_TERMS).map(({ label }) => label);
  expect(labels).toHaveLength(4);
  expect(labels[0]).toMatch(
    /^arcade reaches the black hole at 1\.98 s; first otherwise: completed: touches the black hole at 1\.98 s, at precise collided: touches nova 1 at 0\.11 s$/,
  );
  expect(labels[3]).toMatch(/^precise collides with nova 1 at 0\.11 s$/);
});

it('a run that takes more work than is allowed is not drawn, and why is said', () => {
  const { level } = pack.find(({ slug }) => slug.endsWith('grand-tour'))!;
  const terms = { ...DEFAULT_TERMS, maxWork: 10 };
  expect(() => waysAtAll(level, level.runs[0].holds, terms)).toThrow(/more work than allowed, 10 pieces/);
});
