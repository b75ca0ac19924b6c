import { createStore } from 'zustand/vanilla';
import { joinHolds } from '../../../engine/index.ts';
import { formatRunText, type LevelFile, type RunTextReading, readRunText } from '../../../schema/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { holdsOf, notesOf, writeScript } from '../../core/document/index.ts';
import { ofDocument } from '../../core/kept/index.ts';

/** A text that was typed for a run. */
export interface Draft {
  readonly text: string;
  readonly reading: RunTextReading;
  /** What the run is with this text, canonically; null if the text has a mistake, which leaves the run as it was. */
  readonly means: string | null;
}

/** What is typed for the runs of a level, by their names: it stays while other panels are in front. */
export const draftsOf = ofDocument(() => createStore<ReadonlyMap<string, Draft>>(() => new Map()));

/** A run of a file as canonical text. */
export const scriptText = (file: LevelFile, run: string): string =>
  formatRunText({ holds: holdsOf(file, run), notes: notesOf(file, run) });

/** The draft to show; null: the run itself is shown. A text without mistakes gives way to a change that came from elsewhere. */
export const shownDraft = (draft: Draft | undefined, text: string): Draft | null =>
  draft === undefined || (draft.means !== null && draft.means !== text) ? null : draft;

/** What the typed text means. */
export function draftOf(text: string): Draft {
  const reading = readRunText(text);
  const means = reading.ok ? formatRunText({ holds: joinHolds(reading.holds), notes: reading.notes }) : null;
  return { text, reading, means };
}

/** Types a text for a run: the run changes at once, in one step of undo until `seal`; a mistake changes nothing. */
export function typeScript(level: Pick<OpenLevel, 'document'>, run: string, text: string): void {
  const drafts = draftsOf(level);
  const draft = draftOf(text);
  drafts.setState(new Map(drafts.getState()).set(run, draft), true);
  const { reading } = draft;
  if (!reading.ok) return;
  const script = { holds: joinHolds(reading.holds), notes: reading.notes };
  level.document.change(`Edit run ${run} as text`, writeScript(run, script), { gesture: `text ${run}` });
}

/** Forgets what is typed for a run. */
export function dropDraft(level: Pick<OpenLevel, 'document'>, run: string): void {
  const drafts = draftsOf(level);
  if (!drafts.getState().has(run)) return;
  const left = new Map(drafts.getState());
  left.delete(run);
  drafts.setState(left, true);
}

/** Keeps what is typed for a run that gets another name. */
export function renameDraft(level: Pick<OpenLevel, 'document'>, run: string, to: string): void {
  const drafts = draftsOf(level);
  const draft = drafts.getState().get(run);
  if (draft === undefined || run === to) return;
  dropDraft(level, run);
  drafts.setState(new Map(drafts.getState()).set(to, draft), true);
}

/** Ends typing: what was typed is one step, and a text without mistakes is replaced by the canonical one. */
export function endScript(level: Pick<OpenLevel, 'document'>, run: string): void {
  level.document.seal();
  if (draftsOf(level).getState().get(run)?.reading.ok === true) dropDraft(level, run);
}

/** What is done with a text that says it in another way: at most so many remarks are listed. */
const MOST_REMARKS = 3;

/** What the reader of a text did that the text does not say, as sentences. */
export function remarksInWords(reading: RunTextReading): string[] {
  if (!reading.ok) return [];
  const said = reading.remarks.slice(0, MOST_REMARKS).map(({ line, column, message }) => `${line}:${column} ${message}.`);
  const more = reading.remarks.length - said.length;
  return more === 0 ? said : [...said, `And ${more} more.`];
}
