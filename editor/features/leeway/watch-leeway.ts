import { createStore } from 'zustand/vanilla';
import type { Terms } from '../../../engine/index.ts';
import { type Hold, KINDS, type Level, type LevelFile, OBJECT_LISTS, RULE_NAMES } from '../../../schema/index.ts';
import type { Box } from '../../canvas/index.ts';
import { type Desk, question } from '../../core/ask/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { type FoundObject, type ObjectKey, objectsOf, placesOf } from '../../core/document/index.ts';
import { ofDocument } from '../../core/kept/index.ts';
import { endInWords, isWhole, type LiveProof, withoutRuns } from '../../core/proof/index.ts';
import type { SessionStore } from '../../core/session/index.ts';
import type { SettingsStore } from '../../core/settings/index.ts';
import { jobs, type Leeway } from '../../workers/index.ts';

/** What is known of where the selection may stand. */
export interface LeewayFindings {
  /**
   * `off`: it is not shown. `nothing selected`: it is, but nothing is asked. `waiting`: the level has just changed. `too large`:
   * the level takes too much work. `done`: nothing finer is sampled.
   */
  readonly phase: 'off' | 'nothing selected' | 'waiting' | 'sampling' | 'done' | 'too large' | 'failed';
  /** Why it failed, or why the level is not simulated; null: neither. */
  readonly message: string | null;
  /** What was asked, and what is known; null: nothing is. */
  readonly answer: { readonly question: Question; readonly leeway: Leeway } | null;
  /** The place of an object with several that is moved alone; null: all of them. */
  readonly only: number | null;
}

/** What is known of where the selection of a level may stand. */
export const leewayOf = ofDocument(() =>
  createStore<LeewayFindings>(() => ({ phase: 'off', message: null, answer: null, only: null })),
);

interface LeewayParts {
  readonly level: Pick<OpenLevel, 'document' | 'proof' | 'selection'>;
  readonly session: SessionStore;
  readonly settings: Pick<SettingsStore, 'getState' | 'subscribe'>;
  /** What the canvas shows, px of the level. */
  readonly seen: { now(): Box; subscribe(call: () => void): () => void };
}

const isOn = ({ session }: LeewayParts) => session.getState().layers.leeway && session.getState().mode === 'edit';
const isInHand = ({ level: { document } }: LeewayParts) => document.committedFile() !== document.file();

/** What is asked at the moment; null: nothing is selected. */
function questionNow({ level, settings, seen }: LeewayParts): Question | null {
  const { snapToGrid, grid } = settings.getState();
  const { only } = leewayOf(level).getState();
  return questionOf(level.proof.proof(), level.selection.keys(), { only, grid: snapToGrid ? grid : null, seen: seen.now() });
}

/** What the question and its answer depend on. */
const leewayLooks = (parts: LeewayParts): ((look: () => void) => () => void)[] => [
  parts.level.proof.store.subscribe,
  parts.level.document.onStep,
  parts.level.selection.store.subscribe,
  parts.settings.subscribe,
  parts.seen.subscribe,
  (look) => {
    let wasOn = isOn(parts);
    return parts.session.subscribe(() => {
      if (isOn(parts) === wasOn) return;
      wasOn = isOn(parts);
      look();
    });
  },
  (look) => leewayOf(parts.level).subscribe((now, before) => now.only !== before.only && look()),
];

/** Where the selection may stand. */
export const leewayQuestion = question({
  job: jobs.leeway,
  request(of: Question) {
    const { level, terms, holds, only, lead, grid, seen } = of;
    const objects = objectsAsked(of).map(({ kind, index }) => ({ kind, index }));
    return { level: withoutRuns(level), terms, holds, objects, only, lead, grid, seen };
  },
  follows: {
    wait: { rest: 120 },
    of(parts: LeewayParts, asked) {
      const { proof } = parts.level;
      if (!isOn(parts)) return null;
      // holds may be re-timed in the same gesture: the answer is about those when it began
      if (isInHand(parts)) return asked !== null && isOnlyMoved(asked, proof.proof()) ? asked : null;
      return isWhole(proof.proof()) ? questionNow(parts) : null;
    },
    same: (asked, now) => asked.file === now.file && asksSame(asked, now) && contains(asked.seen, now.seen),
    on: leewayLooks,
  },
});

/**
 * While the layer is shown, samples where the selection may stand. What was found stays for as long as it is true: also while the
 * selection is dragged, as everything else is unchanged.
 */
export function watchLeeway({ desk, ...parts }: LeewayParts & { readonly desk: Desk }): () => void {
  const { proof } = parts.level;
  const store = leewayOf(parts.level);
  const leeway = leewayQuestion(desk, parts);
  const put = (now: Partial<LeewayFindings>) => store.setState({ message: null, answer: null, ...now });

  const show = () => {
    if (!isOn(parts)) {
      if (store.getState().phase !== 'off') put({ phase: 'off' });
      return;
    }
    const now = questionNow(parts);
    if (now === null) {
      if (store.getState().phase !== 'nothing selected') put({ phase: 'nothing selected' });
      return;
    }
    const { phase, of, progress, answer, message } = leeway.store.getState();
    if (isInHand(parts)) {
      // drawing what is found while something is dragged would delay the drag
      if (phase === 'idle') put({ phase: 'waiting' });
      return;
    }
    const found = answer ?? progress;
    const known = store.getState().answer;
    // what was found is shown until something newer is known
    const isTrue = known !== null && asksSame(known.question, now) && isOnlyMoved(known.question, now);
    if (!isWhole(proof.proof())) put({ phase: 'too large', message: endInWords(proof.proof()) });
    else if (phase === 'failed') put({ phase, message });
    else if (of === null || found === null) put({ phase: 'waiting', answer: isTrue ? known : null });
    else if (found.base === 'unknown') put({ phase: 'too large' });
    else put({ phase: found.isFinished ? 'done' : 'sampling', answer: { question: of, leeway: found } });
  };
  show();
  const stops = [...leewayLooks(parts).map((subscribe) => subscribe(show)), leeway.store.subscribe(show)];
  return () => {
    for (const end of stops) end();
    leeway.close();
    put({ phase: 'off' });
  };
}

/** What is asked of a level: where some of its objects may stand, moved alike. */
export interface Question {
  readonly file: LevelFile;
  readonly level: Level;
  readonly terms: Terms;
  /** null: the level has no run, she drifts */
  readonly run: string | null;
  readonly holds: readonly Hold[];
  readonly keys: readonly ObjectKey[];
  /** Index of the only place of the object that moves; null: all of them. */
  readonly only: number | null;
  /** The place that is put on the grid, px. */
  readonly lead: { readonly x: number; readonly y: number };
  /** px; null: nothing snaps to a grid */
  readonly grid: number | null;
  /** What is examined: places of the lead, px. */
  readonly seen: Box;
}

/** The objects of a question. */
export const objectsAsked = ({ file, keys }: Pick<Question, 'file' | 'keys'>): FoundObject[] =>
  keys.flatMap((key) => objectsOf(file).get(key) ?? []);

/** Asks where the selection may stand; null if it is empty. */
function questionOf(
  { file, level, terms, run }: LiveProof,
  keys: readonly ObjectKey[],
  { only, grid, seen }: Pick<Question, 'only' | 'grid' | 'seen'>,
): Question | null {
  const [first, ...others] = objectsAsked({ file, keys });
  if (first === undefined) return null;
  // a place of its own has only an object that is selected alone
  const place = others.length > 0 || placesOf(first).length === 1 ? null : only;
  const lead = placesOf(first)[place ?? 0];
  return {
    file,
    level,
    terms,
    run: run.name,
    holds: run.holds,
    keys,
    only: place,
    lead: { x: lead.x, y: lead.y },
    grid,
    seen,
  };
}

const isSameList = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  a.length === b.length && a.every((one, i) => one === b[i]);

/** Whether the same rules apply: those of the level and of its folder. */
const isSameRules = (one: Level, other: Level): boolean => RULE_NAMES.every((name) => one.rules?.[name] === other.rules?.[name]);

/** Whether only the places of some objects differ, all by the same shift as far as they move. */
export function isOnlyMoved(
  { file: before, level: one, keys, only }: Pick<Question, 'file' | 'level' | 'keys' | 'only'>,
  { file: after, level: other }: Pick<LiveProof, 'file' | 'level'>,
): boolean {
  if (!isSameRules(one, other)) return false;
  if (before === after) return true;
  if (before.range !== after.range || before.recoil !== after.recoil) return false;
  const asked = new Set(keys);
  let shift: { readonly x: number; readonly y: number } | null = null;
  const isMoved = (was: FoundObject, is: FoundObject | undefined): boolean => {
    if (is === undefined || is.kind !== was.kind || is.index !== was.index) return false;
    if (!asked.has(was.key)) return is.object === was.object;
    const { fields, places } = KINDS[was.kind];
    const [then, now] = [was.object, is.object] as unknown as Readonly<Record<string, unknown>>[];
    const moving = places.filter((_, i) => only === null || i === only).flat();
    if (!Object.keys(fields).every((name) => moving.includes(name) || then[name] === now[name])) return false;
    const [from, to] = [placesOf(was), placesOf(is)];
    for (const [i, place] of to.entries()) {
      if (only !== null && i !== only) continue;
      const by = { x: place.x - from[i].x, y: place.y - from[i].y };
      shift ??= by;
      if (Math.abs(by.x - shift.x) > ROUNDING || Math.abs(by.y - shift.y) > ROUNDING) return false;
    }
    return true;
  };
  const now = objectsOf(after);
  if (!OBJECT_LISTS.every((list) => (before[list]?.length ?? 0) === (after[list]?.length ?? 0))) return false;
  for (const [key, was] of objectsOf(before)) if (!isMoved(was, now.get(key))) return false;
  return true;
}

/** px by which shifts may differ that are meant to be the same */
const ROUNDING = 1e-6;

/** Whether an answer to one question is one to the other. */
const asksSame = (one: Question, other: Question): boolean =>
  one.terms === other.terms &&
  one.run === other.run &&
  one.grid === other.grid &&
  one.only === other.only &&
  isSameList(one.keys, other.keys) &&
  isSameRules(one.level, other.level) &&
  one.holds.join() === other.holds.join();

/** Whether a box contains another. */
const contains = (outer: Box, inner: Box): boolean =>
  outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right && outer.bottom >= inner.bottom;
