import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { createAttempts } from '../../editor/core/attempts/attempts.ts';
import { createEditedLevel, moveObjects, replaceHolds } from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { TEMPLATES } from '../../editor/core/templates/index.ts';
import { gripAt, holdsInWords, reachedBy } from '../../editor/timeline/holds.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import { type Hold, readLevel } from '../../schema/index.ts';

function firewalk() {
  const path = join(import.meta.dirname, '..', '..', 'levels', '16-firewalk.level.json');
  const reading = readLevel(readFileSync(path, 'utf8'));
  if (!reading.ok) throw new Error('firewalk can not be read');
  const document = createEditedLevel(reading.document.file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  return { document, proof, ticks: () => proof.reach.getState().ticks, end: () => proof.proof().run.way.count - 1 };
}

/** Hot asteroid 2, and a place at which it blocks the path. */
const [BLOCKER, IN_THE_WAY] = [['3nt2'], [-8, -40]] as const;

describe('the shown length of a run', () => {
  it('reaches to its end while it completes the level, and stays when it breaks', () => {
    const { document, proof, ticks, end } = firewalk();
    const before = end();
    expect(ticks()).toBe(before);
    document.change('block', moveObjects(BLOCKER, ...IN_THE_WAY));
    expect(proof.proof().verdict).toBe('broken');
    expect(end()).toBeLessThan(before / 2);
    expect(ticks()).toBe(before);
    expect(holdsInWords(proof.proof().run.holds, reachedBy(proof.proof()))).toBe('3 holds, 1 not reached');
    document.undo();
    expect(ticks()).toBe(before);
    expect(holdsInWords(proof.proof().run.holds, reachedBy(proof.proof()))).toBe('3 holds');
  });

  it('does not shrink during a drag, but after it', () => {
    const { document, ticks, end } = firewalk();
    document.change('longer', replaceHolds('solution', [[0, 1500]]));
    expect(ticks()).toBe(1500);
    const gesture = document.begin('drag');
    gesture.set(replaceHolds('solution', [[0, 1200]]));
    expect(ticks()).toBe(1500);
    gesture.set(replaceHolds('solution', [[0, 1700]]));
    gesture.set(replaceHolds('solution', [[0, 1300]]));
    expect(ticks()).toBe(1700);
    gesture.commit();
    expect(ticks()).toBe(1300);
    expect(end()).toBeLessThan(1300);
  });

  it('includes a hold that ends after the run, up to a limit', () => {
    const { document, proof, ticks, end } = firewalk();
    const until = (release: number) =>
      document.change(
        'longer',
        replaceHolds('solution', [
          [110, 250],
          [290, 420],
          [470, release],
        ]),
      );
    until(900);
    expect(proof.proof().verdict).toBe('completable');
    expect(ticks()).toBe(900);
    until(3600);
    expect(proof.proof().verdict).toBe('completable');
    expect(ticks()).toBe(2 * end());
  });

  it('is computed again for another run', () => {
    const { document, proof, ticks, end } = firewalk();
    document.change('longer', replaceHolds('solution', [[0, 1500]]));
    proof.showRun('all-minerals');
    expect(ticks()).toBe(end());
  });
});

describe('the part of a hold under the pointer', () => {
  const scale = { from: 0, zoom: 1 };
  const long: Hold[] = [[100, 200]];
  it.each([
    [86, null],
    [93, 'press'],
    [105, 'press'],
    [107, 'body'],
    [150, 'body'],
    [195, 'release'],
    [207, 'release'],
    [209, null],
  ] as const)('of a long bar from 100 to 200 at %i px: %s', (x, part) => {
    expect(gripAt(long, scale, x, 'fine')?.part ?? null).toBe(part);
  });

  it('includes the middle even of a short bar', () => {
    const short: Hold[] = [[100, 109]];
    const parts = [98, 101, 104.5, 108, 111].map((x) => gripAt(short, scale, x, 'fine')?.part);
    expect(parts).toEqual(['press', 'press', 'body', 'release', 'release']);
  });

  it('is the nearest edge if several are close', () => {
    const close: Hold[] = [
      [100, 200],
      [204, 300],
    ];
    expect([201, 203].map((x) => gripAt(close, scale, x, 'fine'))).toEqual([
      { index: 0, part: 'release' },
      { index: 1, part: 'press' },
    ]);
    expect(gripAt(close, scale, 180, 'coarse')).toEqual({ index: 0, part: 'release' });
    expect(gripAt(close, scale, 150, 'coarse')).toEqual({ index: 0, part: 'body' });
  });

  it('has 44 px for a finger, whatever the length of the bar', () => {
    for (const length of [3, 30, 300]) {
      const bar: Hold[] = [[1000, 1000 + length]];
      const xs = Array.from({ length: 2000 }, (_, i) => i + 0.5);
      for (const part of ['press', 'release'] as const) {
        expect(xs.filter((x) => gripAt(bar, scale, x, 'coarse')?.part === part).length).toBeCloseTo(44, -0.5);
      }
    }
  });
});

it('unfinished attempts are dropped first to make room', () => {
  const attempts = createAttempts();
  const end = { outcome: 'lost', with: null, time: 1, tick: 60 } as const;
  const played = { bytes: new Uint8Array(), hash: '', file: TEMPLATES[0].make('Empty', 1), rules: {} };
  const rest = { holds: [], tick: 60, minerals: 0, accuracy: 'precise', points: new Float32Array(), played } as const;
  for (let i = 1; i <= 200; i++) attempts.add({ ...rest, end: i === 3 ? null : end });
  attempts.add({ ...rest, end });
  attempts.add({ ...rest, end: null });
  const numbers = attempts.store.getState().map(({ number }) => number);
  expect(numbers).toHaveLength(200);
  expect(numbers.slice(0, 3)).toEqual([2, 4, 5]);
  expect(numbers.at(-1)).toBe(202);
});
