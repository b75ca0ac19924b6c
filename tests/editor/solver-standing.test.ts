import { describe, expect, it } from 'vitest';
import type { SearchState } from '../../editor/features/solver/search-session.ts';
import { askedInWords, summaryOf } from '../../editor/features/solver/search-summary.ts';
import { createSearchSettings } from '../../editor/features/solver/search-task.ts';

const settings = createSearchSettings().getState();
const NOBODY = { meets: null, completes: null };
const COUNT = 3;

const solving = (distance: number | null, finished = false): SearchState['solving'] => ({
  effort: { runs: 1, ticks: 1 },
  closest: distance === null ? null : { distance, tick: 60, holds: [] },
  solutions: [],
  explored: { cellSize: 32, cells: [] },
  finished,
});
const found = (...works: boolean[]): SearchState['found'] =>
  works.map((one, i) => ({
    id: String(i),
    candidate: { holds: [], outcome: 'completed', time: 1, tick: 60, minerals: [] },
    p40: null,
    certified: false,
    works: one,
  }));
const state = (changes: Partial<SearchState>): SearchState => ({
  phase: 'done',
  message: null,
  ms: 10_000,
  settings,
  solving: solving(42),
  found: [],
  impossible: null,
  mineralProofs: [],
  isHopeless: false,
  isOld: false,
  hovered: null,
  ...changes,
});
const say = (changes: Partial<SearchState>, own: Parameters<typeof summaryOf>[1] = NOBODY) => {
  const { text, note } = summaryOf(state(changes), own, COUNT, 5);
  return note === null ? text : `${text} | ${note}`;
};
const all = { ...settings, minerals: 'all' } as const;
const some = { ...settings, minerals: 'some', some: 2 } as const;

describe('the message of the solver', () => {
  it('mentions minerals only if some are required', () => {
    expect([settings, some, all].map((one) => askedInWords(one, COUNT))).toEqual([
      '',
      ' with at least 2 of 3 minerals',
      ' with all 3 minerals',
    ]);
    expect(askedInWords(all, 1)).toBe(' with the mineral');
    // all of none is any
    expect(askedInWords(all, 0)).toBe('');
    for (const phase of ['running', 'done', 'cancelled', 'stale', 'failed'] as const)
      for (const distance of [null, 0, 42])
        for (const own of [NOBODY, { meets: 'a', completes: 'a' }])
          for (const ways of [found(), found(true), found(true, false)])
            for (const isOld of [true, false])
              expect(say({ phase, solving: solving(distance), found: ways, isOld }, own)).not.toContain('mineral');
  });

  it('says that nothing was found, why the search ended, what that means, and what the own runs show', () => {
    expect(say({})).toBe(
      'The 10 s are over: no run into the black hole was found. This does not prove that there is none. The closest approach, shown on the canvas, was 42 px from the black hole at 1.00 s.',
    );
    expect(say({ phase: 'cancelled', ms: 2100, solving: null })).toMatch(/^Stopped after 2.1 s: no run into/);
    expect(say({ solving: solving(null, true) })).toMatch(/^Nothing is left to try: no run into/);
    expect(say({}, { meets: 'solution', completes: 'solution' })).toBe(
      "The 10 s are over: no other run was found. The closest approach, shown on the canvas, was 42 px from the black hole at 1.00 s. The level's own run “solution” already does this.",
    );
    expect(say({ settings: all, solving: solving(0) }, { meets: null, completes: 'solution' })).toBe(
      'The 10 s are over: no run into the black hole with all 3 minerals was found. This does not prove that there is none. It reached the black hole, but not with all 3 minerals. The level is completable all the same: its run “solution” reaches the black hole.',
    );
    expect(say({ solving: solving(0) })).toContain('It reached the black hole, but had no time');
    expect(say({ phase: 'running' })).toMatch(/^Looking for runs: none found yet\./);
    expect(say({ isHopeless: true, settings: all }, { meets: null, completes: 'solution' })).toBe(
      'Proved: no run completes the level with all 3 minerals. The level is completable all the same: its run “solution” reaches the black hole.',
    );
  });

  it('says how many of the wanted runs were found', () => {
    expect(say({ phase: 'running', found: found(true) })).toBe('1 different run found so far | Looked for up to 5 runs.');
    expect(say({ found: found(true, true), settings: some })).toBe(
      '2 different runs found | Looked for up to 5 runs with at least 2 of 3 minerals. The 10 s are over. More time or another seed may find more.',
    );
    expect(say({ found: found(true), solving: solving(0, true) })).toBe(
      '1 different run found | Looked for up to 5 runs. Nothing is left to try.',
    );
    expect(say({ found: found(true, true, true, true, true) })).toBe('5 different runs found | Looked for up to 5 runs.');
  });

  it('says what holds after a change of the level', () => {
    expect(say({ phase: 'stale', isOld: true, found: found(true, false), solving: null })).toBe(
      'The level changed, so the search stopped. 1 of 2 runs found before the level changed still works.',
    );
    expect(say({ isOld: true, solving: null })).toBe(
      'The level has changed since the search, which found no run. Solve searches the current level.',
    );
  });
});
