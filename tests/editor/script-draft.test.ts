import { describe, expect, it } from 'vitest';
import { createEditedLevel, moveHold, renameRun, stretchHold } from '../../editor/core/document/index.ts';
import {
  draftsOf,
  dropDraft,
  endScript,
  remarksInWords,
  renameDraft,
  scriptText,
  shownDraft,
  typeScript,
} from '../../editor/features/runs/script-draft.ts';
import type { LevelFile } from '../../schema/index.ts';

const FILE: LevelFile = {
  version: 1,
  name: 'text',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  runs: [
    { name: 'solution', holds: [[60, 150]], notes: [{ tick: 60, text: 'first' }] },
    { name: 'other', holds: [] },
  ],
};

function stage() {
  const document = createEditedLevel(FILE);
  const level = { document };
  const text = (run = 'solution') => scriptText(document.file(), run);
  return {
    document,
    level,
    text,
    type: (typed: string, run = 'solution') => typeScript(level, run, typed),
    /** What the field shows. */
    field: (run = 'solution') => shownDraft(draftsOf(level).getState().get(run), text(run))?.text ?? text(run),
    mistake: (run = 'solution') => {
      const draft = shownDraft(draftsOf(level).getState().get(run), text(run));
      return draft !== null && !draft.reading.ok ? draft.reading : null;
    },
  };
}

describe('typing a run as text', () => {
  it('changes the run with every letter that can be read, in one step of undo', () => {
    const { document, type, text, field } = stage();
    for (const typed of [
      '60-150 # first, ',
      '60-150, 2',
      '60-150, 200-4',
      '60-150, 200-41',
      '60-150, 200-410 #',
      '60-150, 200-410 # swing',
    ]) {
      type(typed);
      expect(field()).toBe(typed);
    }
    expect(text()).toBe('60-150, 200-410 # swing');
    expect(document.labels()).toEqual(['Edit run solution as text']);
    document.undo();
    expect(document.file()).toEqual(createEditedLevel(FILE).file());
    expect(field()).toBe('60-150 # first');
  });

  it('is a step of its own after the field was left, and is laid out then', () => {
    const { document, level, type, field } = stage();
    type('60 .. 150');
    expect(field()).toBe('60 .. 150');
    endScript(level, 'solution');
    expect(field()).toBe('60-150');
    type('60-151');
    endScript(level, 'solution');
    expect(document.labels()).toHaveLength(2);
  });

  it('with a mistake changes nothing and is not lost, whatever else happens', () => {
    const { document, level, type, field, text, mistake } = stage();
    type('60-150, 200-');
    expect(mistake()).toMatchObject({ line: 1, column: 13 });
    expect(text()).toBe('60-150 # first');
    endScript(level, 'solution');
    document.change('Move hold', moveHold('solution', 0, 5));
    expect(text()).toBe('65-155 # first');
    expect(field()).toBe('60-150, 200-');
    // another run has its own text
    type('5-9', 'other');
    expect([field('other'), field()]).toEqual(['5-9', '60-150, 200-']);
    document.change('Rename run', renameRun('solution', 'other name'));
    renameDraft(level, 'solution', 'other name');
    expect(field('other name')).toBe('60-150, 200-');
    document.undo();
    renameDraft(level, 'other name', 'solution');
    dropDraft(level, 'solution');
    expect(field()).toBe('65-155 # first');
  });

  it('follows the lane: a text without mistakes gives way to a change that came from elsewhere', () => {
    const { document, type, field } = stage();
    type('60 - 150 # first');
    expect(field()).toBe('60 - 150 # first');
    document.change('Move release', stretchHold('solution', 0, 'release', 170));
    expect(field()).toBe('60-170 # first');
    document.undo();
    expect(field()).toBe('60 - 150 # first');
  });

  it('says what becomes of holds that overlap, and of many only the first', () => {
    const { level, type, text } = stage();
    type('60-150, 100-200');
    expect(text()).toBe('60-200');
    const { reading } = draftsOf(level).getState().get('solution') ?? {};
    expect(reading !== undefined && remarksInWords(reading)).toEqual([
      '1:9 60-150 and 100-200 overlap or touch, and become 60-200.',
    ]);
    type(Array.from({ length: 8 }, (_, i) => `${100 * i}-${100 * i + 20}, ${100 * i + 10}-${100 * i + 30}`).join('\n'));
    const many = draftsOf(level).getState().get('solution')?.reading;
    expect(many !== undefined && remarksInWords(many)).toHaveLength(4);
    expect(many !== undefined && remarksInWords(many).at(-1)).toBe('And 5 more.');
  });
});
