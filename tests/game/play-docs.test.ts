import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { createPlayer, encodePlay, playOf } from '../../game/index.ts';
import { pack, shipped } from '../levels/shipped-pack.ts';

const page = readFileSync(new URL('../../docs/plays.md', import.meta.url), 'utf8');

const bytesOf = (level: (typeof pack)[number]['level'], run: number): Uint8Array => {
  const player = createPlayer(level, { replay: level.runs[run].holds });
  while (player.ending === null) player.advance(100);
  return encodePlay(playOf(player));
};

it('the page shows the bytes of a play as they are', () => {
  const block = /```text\n(89 47[\s\S]*?)```/.exec(page)?.[1] ?? '';
  const shown = block.split('\n').flatMap((line) => /^(?:[0-9a-f]{2} ?)+/.exec(line)?.[0].trim().split(/ +/) ?? []);
  const { level } = shipped('first-pull');
  expect(shown.join(' ')).toBe([...bytesOf(level, 0)].map((byte) => byte.toString(16).padStart(2, '0')).join(' '));
});

it('the page says how large the plays of the shipped runs are', () => {
  const sizes = pack.flatMap(({ level }) => level.runs.map((_, run) => bytesOf(level, run).length));
  expect(page).toContain(`those of the shipped runs take ${Math.min(...sizes)} to ${Math.max(...sizes)}.`);
});
