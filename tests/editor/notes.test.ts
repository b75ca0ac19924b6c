import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  addHold,
  addNote,
  createEditedLevel,
  deleteHolds,
  deleteNote,
  duplicateRun,
  holdsOf,
  moveHold,
  moveNote,
  notesOf,
  type Recipe,
  renameRun,
  replaceHolds,
  rewordNote,
  splitHold,
  stretchHold,
  writeScript,
} from '../../editor/core/document/index.ts';
import { formatRunText, type Hold, type LevelFile, LIMITS, type RunNote, readRunText } from '../../schema/index.ts';

const levelWith = (holds: readonly Hold[], notes: readonly RunNote[]): LevelFile => ({
  version: 1,
  name: 'notes',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  runs: [{ name: 'run', holds: holds.map(([a, b]) => [a, b]), notes: notes.map((note) => ({ ...note })) }],
});

function outcomeOf(holds: readonly Hold[], notes: readonly RunNote[], recipe: Recipe) {
  const level = createEditedLevel(levelWith(holds, notes));
  const before = level.file();
  const result = level.change('act', recipe);
  if (!result.ok) throw new Error(result.refusal.message);
  const now = { holds: holdsOf(level.file(), 'run'), notes: notesOf(level.file(), 'run'), file: level.file() };
  level.undo();
  expect(level.file()).toEqual(before);
  return now;
}

const HOLDS: readonly Hold[] = [
  [60, 150],
  [200, 410],
  [500, 600],
];
const NOTES: readonly RunNote[] = [
  { tick: 10, text: 'waits' },
  { tick: 60, text: 'first' },
  { tick: 150, text: 'lets go' },
  { tick: 200, text: 'second' },
  { tick: 300, text: 'inside' },
  { tick: 450, text: 'gap' },
  { tick: 500, text: 'third' },
  { tick: 900, text: 'far' },
];
const ticksOf = (notes: readonly RunNote[]) => Object.fromEntries(notes.map(({ tick, text }) => [text, tick]));
const acted = (recipe: Recipe) => ticksOf(outcomeOf(HOLDS, NOTES, recipe).notes);
const still = ticksOf(NOTES);

describe('notes follow the holds', () => {
  it('that are moved', () => {
    expect(acted(moveHold('run', 1, 30))).toEqual({ ...still, second: 230, inside: 330 });
    expect(acted(moveHold('run', 0, -500))).toEqual({ ...still, first: 0, 'lets go': 90 });
    expect(acted(moveHold('run', 1, 30, { ripple: true }))).toEqual({
      ...still,
      second: 230,
      inside: 330,
      gap: 480,
      third: 530,
      far: 930,
    });
  });

  it('that are stretched', () => {
    expect(acted(stretchHold('run', 1, 'press', 180))).toEqual({ ...still, second: 180 });
    expect(acted(stretchHold('run', 1, 'press', 180, { ripple: true }))).toEqual({
      ...still,
      second: 180,
      inside: 280,
      gap: 430,
      third: 480,
      far: 880,
    });
    expect(acted(stretchHold('run', 0, 'release', 160))).toEqual({ ...still, 'lets go': 160 });
    expect(acted(stretchHold('run', 1, 'release', 250, { ripple: true }))).toEqual({
      ...still,
      inside: 250,
      gap: 290,
      third: 340,
      far: 740,
    });
  });

  it('that are split, joined, added and deleted', () => {
    expect(acted(splitHold('run', 1, 300))).toEqual(still);
    expect(acted(addHold('run', 140, 220))).toEqual(still);
    const { second: _, ...others } = still;
    expect(acted(deleteHolds('run', [1]))).toEqual(others);
    expect(acted(deleteHolds('run', [1], { ripple: true }))).toEqual({ ...others, inside: 200, gap: 240, third: 290, far: 690 });
  });

  it('that an attempt or a tool replaces, as far as they are kept', () => {
    const shorter = replaceHolds('run', [
      [62, 150],
      [500, 600],
    ]);
    expect(acted(shorter)).toEqual({ ...still, first: 62 });
    expect(acted(replaceHolds('run', []))).toEqual(still);
    expect(
      acted(
        replaceHolds('run', [
          [60, 150],
          [204, 414],
          [500, 600],
        ]),
      ),
    ).toEqual({ ...still, second: 204, inside: 304 });
  });

  it('in any way of moving: what stands beside a hold still does', () => {
    const edges = (holds: readonly Hold[], notes: readonly RunNote[]) =>
      notes.map(({ tick, text }) => [
        text,
        holds.findIndex(([press]) => press === tick),
        holds.findIndex(([, release]) => release === tick),
      ]);
    const notes = HOLDS.flatMap(([press, release], i) => [
      { tick: press, text: `press ${i}` },
      { tick: release, text: `release ${i}` },
    ]);
    const act = fc.record({ index: fc.nat(2), by: fc.integer({ min: -700, max: 700 }), ripple: fc.boolean(), kind: fc.nat(2) });
    fc.assert(
      fc.property(act, ({ index, by, ripple, kind }) => {
        const edge = kind === 0 ? 'press' : 'release';
        const to = (edge === 'press' ? HOLDS[index][0] : HOLDS[index][1]) + by;
        const recipe = kind === 2 ? moveHold('run', index, by, { ripple }) : stretchHold('run', index, edge, to, { ripple });
        const now = outcomeOf(HOLDS, notes, recipe);
        expect(edges(now.holds, now.notes)).toEqual(edges(HOLDS, notes));
      }),
      { numRuns: 300 },
    );
  });
});

describe('notes', () => {
  it('stay with their run when it is renamed or duplicated, and a copy is its own', () => {
    const { file } = outcomeOf(HOLDS, NOTES, (draft) => {
      renameRun('run', 'other')(draft);
      duplicateRun('other', 'copy')(draft);
      addNote('copy', 5, 'only here')(draft);
    });
    expect(notesOf(file, 'other')).toEqual(NOTES);
    expect(notesOf(file, 'copy')).toEqual([{ tick: 5, text: 'only here' }, ...NOTES]);
  });

  it('are added, reworded, moved and deleted; the last one takes the list along', () => {
    expect(acted(addNote('run', 60, 'more'))).toEqual({ ...still, more: 60 });
    expect(
      outcomeOf(HOLDS, NOTES, addNote('run', 60, 'more'))
        .notes.map(({ text }) => text)
        .slice(1, 3),
    ).toEqual(['first', 'more']);
    expect(acted(rewordNote('run', 0, ' rests '))).toEqual({ ...acted(deleteNote('run', 0)), rests: 10 });
    expect(acted(rewordNote('run', 0, '  '))).toEqual(acted(deleteNote('run', 0)));
    expect(outcomeOf(HOLDS, NOTES, moveNote('run', 0, 700)).notes.at(-2)).toEqual({ tick: 700, text: 'waits' });
    const { file } = outcomeOf(HOLDS, [NOTES[0]], deleteNote('run', 0));
    expect(file.runs?.[0]).toEqual({ name: 'run', holds: HOLDS });
  });

  it('are made valid: on one line, not too long, within the ticks', () => {
    const put = (tick: number, text: string) => outcomeOf([], [], addNote('run', tick, text)).notes;
    expect(put(-5, 'a\nb\u2028c')).toEqual([{ tick: 0, text: 'a b c' }]);
    expect(put(1e9, 'x')).toEqual([{ tick: LIMITS.tick, text: 'x' }]);
    expect(put(2.4, `${'a'.repeat(199)}🚀`)).toEqual([{ tick: 2, text: 'a'.repeat(199) }]);
    const level = createEditedLevel(levelWith([], []));
    expect(level.change('act', addNote('run', Number.NaN, 'x')).ok).toBe(false);
    const many = Array.from({ length: LIMITS.notes }, (_, i) => ({ tick: i, text: 'x' }));
    const full = createEditedLevel(levelWith([], many));
    expect(full.change('act', addNote('run', 1, 'one more'))).toMatchObject({ ok: false });
  });

  it('keep keys that the text of a run does not show', () => {
    const notes: (RunNote & { 'x-colour': string })[] = [{ tick: 60, text: 'first', 'x-colour': 'red' }];
    const reading = readRunText('70-150 # first\n# new');
    if (!reading.ok) throw new Error(reading.message);
    const now = outcomeOf(HOLDS, notes, writeScript('run', reading));
    expect(now.notes).toEqual<object[]>([
      { tick: 70, text: 'first', 'x-colour': 'red' },
      { tick: 150, text: 'new' },
    ]);
    expect(formatRunText(now)).toBe('70-150 # first\n# new');
  });
});
